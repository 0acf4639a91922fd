#include "grass/tessellated_settings.h"

#include <cmath>

#include "core/json.h"
#include "grass/hybrid.h"
#include "scene/field_rows.h"

namespace sward {
namespace {

FeatureSet featuresOfTessellated(const FieldEntity& field) {
    const FeatureSet blades = featureSet(Feature::GrassTessellated);
    return field.settings<TessellatedBlades>().beyond == Beyond::Slice ? blades | featureSet(Feature::GrassFar)
                                                                       : blades;
}

FieldTiers tessellatedTiers(const FieldEntity& field, float pixelsPerMetre) {
    const auto& own = field.settings<TessellatedBlades>();
    const HybridTiers slices = tiersSeen(field, pixelsPerMetre);
    FieldTiers t;
    t.blades = {own.maxDistance, -1, own.maxDistance};
    t.images = fadeRange(own.lowerFrom * own.maxDistance, own.maxDistance);  // take over while blades get lower
    t.flat = fadeRange(slices.minBTF, slices.maxBTF);
    t.soil = t.flat;
    t.shadowsTo = std::max(slices.maxBTF, slices.maxGeom);
    return t;
}

std::string roundedSetting(const char* name, double v) {
    return std::string(name) + "=" + shortestText(static_cast<float>(std::round(v * 1000) / 1000));
}
// Fewer blades and less far, coarser blades, and who tessellates.
std::vector<SettingValues> sweepTessellated(const FieldEntity& field) {
    const auto& own = field.settings<TessellatedBlades>();
    std::vector<SettingValues> out;
    for (const double far : {0.5, 1.0})
        out.push_back({roundedSetting("maxDistance", static_cast<double>(own.maxDistance) * far), "msaa=4"});
    for (const char* one : {"thinning=0", "levelBy=pixels", "msaa=1", kTemporalSetting}) out.push_back({one});
    for (const char* one : {"leastPixels=0.25", "leastPixels=0.5", "leastPixels=1"})
        out.push_back({one, kTemporalSetting});
    return out;
}

constexpr KnobRow kKnobs[] = {
    {"far", true, 1, 0, 1e30, true}, {"kept", true, 1, 0, 1e30, true}, kSamplesKnob, {"wide", false, 0, -1, 1, false}};
// far: how far blades are drawn; kept: share of the blades that is left there; wide: how wide they are at least.
SettingValues tessellatedTurned(const FieldEntity& field, std::span<const double> k) {
    const auto& own = field.settings<TessellatedBlades>();
    const double kept = (1 - static_cast<double>(own.thinning)) * k[1];
    return {roundedSetting("maxDistance", std::clamp(static_cast<double>(own.maxDistance) * k[0], 0.1, 1e6)),
            roundedSetting("thinning", std::clamp(1 - kept, 0.0, 1.0)), samplesTurned(k[2]),
            roundedSetting("leastPixels", std::clamp(static_cast<double>(own.leastPixels) + k[3], 0.0, 1.0))};
}

constexpr const char* kSettings[] = {"TessellatedBlades", "GrassSlices", "GrassDrawing", "FarLook"};

}  // namespace

ComponentRow tessellatedBladesRow() {
    static constexpr FieldRow kFields[] = {
        real("maxDistance", offsetof(TessellatedBlades, maxDistance), "m", {0.1, 1e6, 5, 200},
             "from here no blade is drawn"),
        titled("Detail by", choice("levelBy", &TessellatedBlades::levelBy, offsetof(TessellatedBlades, levelBy),
                                   kLevelsBy, "what says how fine a blade is, its distance or its length on screen")),
        real("pixelsPerQuad", offsetof(TessellatedBlades, pixelsPerQuad), "pixels", {0.5, 1000, 2, 40},
             "by pixels: length of a blade's quad on screen"),
        real("thinning", offsetof(TessellatedBlades, thinning), "", kShare,
             "share of the blades that is missing at maxDistance"),
        titled("Blades at least", real("leastPixels", offsetof(TessellatedBlades, leastPixels), "px", {0, 1, 0, 1},
                                       "on screen: where blades would be thinner there are fewer, as wide as this")),
        flag("widening", offsetof(TessellatedBlades, widening),
             "blades that are left are wider, so as to cover as much"),
        real("lowerFrom", offsetof(TessellatedBlades, lowerFrom), "", kShare,
             "share of maxDistance from which blades get lower; 1: they do not"),
        titled("Drawn beyond",
               choice("beyond", &TessellatedBlades::beyond, offsetof(TessellatedBlades, beyond), kBeyonds,
                      "what grows beyond maxDistance: the horizontal slice, or nothing, as published")),
        choice("tessellation", &TessellatedBlades::tessellation, offsetof(TessellatedBlades, tessellation),
               kTessellations, "by the GPU's stages, or by strips from a compute pass; auto: what is faster here"),
    };
    return settingsRow<TessellatedBlades>("TessellatedBlades", "How blades are tessellated by distance, and how far.",
                                          kFields, "GrassField");
}

TechniqueRow tessellatedTechnique() {
    return {.name = "tessellated",
            .label = "Tessellated",
            .help = "blades one by one, each as finely as its distance asks (Jahrmann 2013)",
            .color = 0x56b4e9,
            .settings = kSettings,
            .features = featuresOfTessellated,
            .tiers = tessellatedTiers,
            .sweep = sweepTessellated,
            .knobs = kKnobs,
            .turned = tessellatedTurned};
}

}  // namespace sward
