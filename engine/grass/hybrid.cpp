#include "grass/hybrid.h"

#include <array>
#include <cmath>

#include "core/json.h"
#include "grass/slice_settings.h"
#include "scene/field_rows.h"

namespace sward {
namespace {

constexpr float kSlicesReach = 1.1f;  // by pixels: of where blades end, so that slices have room to fade

// --- distances -------------------------------------------------------------------------------------------------------
// A pair of distances in order, so that a formula may divide by their difference. Both infinite: never fades, and is
// kept. Appends what was done.
void repairPair(const char* nearName, float& near, const char* farName, float& far, std::vector<std::string>& said) {
    if (near < far || (std::isinf(near) && std::isinf(far))) return;
    if (near > far) {
        std::swap(near, far);
        said.push_back(fmt::format("{} was greater than {}; swapped to {} and {}", nearName, farName,
                                   shortestText(near), shortestText(far)));
        return;
    }
    const float widened = near + std::max(0.1f, near * 0.1f);
    said.push_back(fmt::format("{} and {} were both {}; {} is now {}", nearName, farName, shortestText(near), farName,
                               shortestText(widened)));
    far = widened;
}
std::vector<std::string> repairTiers(void* component) {
    auto& t = *static_cast<HybridTiers*>(component);
    std::vector<std::string> said;
    repairPair("minGeom", t.minGeom, "maxGeom", t.maxGeom, said);
    repairPair("minBTF", t.minBTF, "maxBTF", t.maxBTF, said);
    return said;
}

// Metres at which something of `size` metres is `pixels` wide; `own`, where that says nothing.
float seenTo(float own, float size, float pixelsPerMetre, float pixels) {
    const bool follows = own > 0 && std::isfinite(own) && size > 0;
    return follows ? size * pixelsPerMetre / pixels : own;
}

bool byPixels(const void* tiers) { return static_cast<const HybridTiers*>(tiers)->tiersBy == TiersBy::Pixels; }

// --- what is drawn where ---------------------------------------------------------------------------------------------
FeatureSet hybridFeatures(const FieldEntity& field) {
    const auto& t = field.settings<HybridTiers>();
    FeatureSet s;
    if (t.maxGeom > 0) s |= featureSet(Feature::GrassGeometry);
    if (std::isinf(t.minGeom)) return s;
    if (t.maxBTF > t.minGeom || (byPixels(&t) && t.maxBTF > 0))
        s |= featureSet(t.middleTier == MiddleTier::Raytraced ? Feature::GrassRaytraced : Feature::GrassSlices);
    return s | featureSet(Feature::GrassFar);
}
// What all four have in common.
FieldTiers flatTiers(const FieldEntity& field, float pixelsPerMetre) {
    const HybridTiers t = tiersSeen(field, pixelsPerMetre);
    FieldTiers tiers;
    tiers.flat = fadeRange(t.minBTF, t.maxBTF);
    tiers.soil = tiers.flat;
    tiers.shadowsTo = std::max(t.maxBTF, t.maxGeom);
    return tiers;
}
FieldTiers hybridTiers(const FieldEntity& field, float pixelsPerMetre) {
    const HybridTiers t = tiersSeen(field, pixelsPerMetre);
    FieldTiers tiers = flatTiers(field, pixelsPerMetre);
    tiers.blades = tiers.images = fadeRange(t.minGeom, t.maxGeom);
    tiers.slicesFrom = tiers.flatFrom = t.minGeom;
    tiers.slicesTo = t.maxBTF;
    tiers.soil = fadeRange(std::max(t.minBTF, t.maxGeom), std::max(t.maxBTF, t.maxGeom));
    return tiers;
}
bool hasMiddle(const FeatureSet& s) { return has(s, Feature::GrassSlices) || has(s, Feature::GrassRaytraced); }
// The middle tier stands for what else is drawn blade by blade.
FeatureSet withoutBlades(FeatureSet s) { return hasMiddle(s) ? s & ~featureSet(Feature::GrassGeometry) : s; }
FieldTiers hybridCoarseTiers(const FieldEntity& field, float pixelsPerMetre) {
    FieldTiers tiers = hybridTiers(field, pixelsPerMetre);
    if (!hasMiddle(hybridFeatures(field))) return tiers;
    tiers.images = fadeRange(0, 0);
    tiers.slicesFrom = tiers.flatFrom = -1;
    return tiers;
}

FeatureSet geometryFeatures(const FieldEntity&) { return featureSet(Feature::GrassGeometry); }
FieldTiers geometryTiers(const FieldEntity& field, float pixelsPerMetre) {
    FieldTiers tiers = flatTiers(field, pixelsPerMetre);
    tiers.blades = {0, 0, INFINITY};
    tiers.soil = fadeRange(INFINITY, INFINITY);
    return tiers;
}

FeatureSet slicesFeatures(const FieldEntity&) { return featureSet(Feature::GrassSlices, Feature::GrassFar); }
FieldTiers slicesTiers(const FieldEntity& field, float pixelsPerMetre) {
    FieldTiers tiers = flatTiers(field, pixelsPerMetre);
    tiers.flat = {0, 0, INFINITY};
    tiers.slicesTo = INFINITY;
    return tiers;
}

FeatureSet flatFeatures(const FieldEntity&) { return featureSet(Feature::GrassFar); }

// --- what a sweep tries ----------------------------------------------------------------------------------------------
std::string scaled(const char* name, float own, double factor) {
    return std::string(name) + "=" +
           shortestText(static_cast<float>(std::round(static_cast<double>(own) * factor * 1000) / 1000));
}
// By pixels: what is half as wide in the picture is twice as far away.
SettingValues scaledPixels(const HybridTiers& t, double near, double far) {
    return {scaled("bladePixels", t.bladePixels, 1 / near), scaled("slicePixels", t.slicePixels, 1 / far)};
}
// Where blades give way to slices, and slices to the ground's one, as factors of the field's own distances.
SettingValues scaledTiers(const HybridTiers& t, double near, double far, const char* msaa) {
    if (t.tiersBy == TiersBy::Pixels) {
        SettingValues out = scaledPixels(t, near, far);
        out.push_back(msaa);
        return out;
    }
    const double least = std::isfinite(t.maxGeom) ? t.maxGeom * near / std::max(t.minBTF, 1e-3f) : 0;
    far = std::max(far, std::min(least, 1e3));
    return {scaled("minGeom", t.minGeom, near), scaled("maxGeom", t.maxGeom, near), scaled("minBTF", t.minBTF, far),
            scaled("maxBTF", t.maxBTF, far), msaa};
}
std::vector<SettingValues> hybridSweep(const FieldEntity& field) {
    const auto& own = field.settings<HybridTiers>();
    std::vector<SettingValues> out;
    for (const double near : {0.25, 0.5, 0.7071, 1.0, 1.4142, 2.0})
        for (const double far : {0.5, 1.0, 2.0}) out.push_back(scaledTiers(own, near, far, "msaa=4"));
    for (const double near : {0.5, 1.0, 2.0}) out.push_back(scaledTiers(own, near, 1, "msaa=1"));
    out.push_back({kTemporalSetting});
    out.push_back({"middleTier=raytraced", "msaa=4"});
    for (const char* one : {"sharpness=0", "sharpness=1", "sharpness=2", "filtering=trilinear", "sliceCover=published",
                            "lightWeights=published", "transparency=both", "storage=compressed"})
        out.push_back({one, "msaa=4"});
    return out;
}
// At less detail there are fewer and wider blades.
std::vector<SettingValues> geometrySweep(const FieldEntity&) {
    std::vector<SettingValues> out;
    for (const char* detail : {"detail=0.125", "detail=0.25", "detail=0.5", "detail=1"})
        for (const char* msaa : {"msaa=1", "msaa=4"}) out.push_back({detail, msaa});
    out.push_back({kTemporalSetting});
    return out;
}
SettingValues slicesScaled(const HybridTiers& own, double far, const char* msaa) {
    if (own.tiersBy == TiersBy::Pixels) return {scaled("slicePixels", own.slicePixels, 1 / far), msaa};
    return {scaled("minBTF", own.minBTF, far), scaled("maxBTF", own.maxBTF, far), msaa};
}
std::vector<SettingValues> slicesSweep(const FieldEntity& field) {
    const auto& own = field.settings<HybridTiers>();
    std::vector<SettingValues> out;
    for (const double far : {0.5, 1.0, 2.0}) out.push_back(slicesScaled(own, far, "msaa=4"));
    out.push_back({"msaa=1"});
    out.push_back({kTemporalSetting});
    return out;
}
std::vector<SettingValues> flatSweep(const FieldEntity&) { return {{"msaa=1"}, {"msaa=4"}, {kTemporalSetting}}; }

// --- what a fit turns ------------------------------------------------------------------------------------------------
constexpr KnobRow kFarKnob{"far", true, 1, 0, 1e30, true}, kSharpnessKnob{"sharpness", false, 0, -8, 8, true},
    kFilteringKnob{"filtering", false, 0, 0, 1, false};  // 1: the other way than the field's own
enum Knob { kNear, kFar, kFade, kSharpness, kSamples };
constexpr KnobRow kHybridKnobs[] = {{"near", true, 1, 0, 1e30, true},
                                    kFarKnob,
                                    {"fade", true, 1, 1, 4, false},
                                    kSharpnessKnob,
                                    kSamplesKnob,
                                    kFilteringKnob};
enum ImagesKnob { kImagesFar, kImagesSharpness, kImagesSamples };
constexpr KnobRow kSlicesKnobs[] = {kFarKnob, kSharpnessKnob, kSamplesKnob, kFilteringKnob},
                  kFlatKnobs[] = {kSamplesKnob, kFilteringKnob};
std::string rounded(const char* name, double v) {
    return std::string(name) + "=" + shortestText(static_cast<float>(std::round(v * 1000) / 1000));
}
std::string sharpnessTurned(const FieldEntity& field, double k) {
    return rounded("sharpness", std::clamp(static_cast<double>(field.settings<GrassSlices>().sharpness) + k, 0.0, 8.0));
}
std::string filteringTurned(const FieldEntity& field, double k) {
    const Filtering own = field.settings<GrassSlices>().filtering,
                    other = own == Filtering::Trilinear ? Filtering::Anisotropic : Filtering::Trilinear;
    return std::string("filtering=") + kFilterings[k < 0.5 ? own : other];
}
// Distances as knobs say, in order: blades begin to go before they are gone, and slices go no nearer than blades do.
SettingValues tiersTurned(const HybridTiers& own, std::span<const double> k) {
    if (own.tiersBy == TiersBy::Pixels)
        return {rounded("bladePixels", std::clamp(own.bladePixels / k[kNear], 0.01, 1e3)),
                rounded("slicePixels", std::clamp(own.slicePixels / k[kFar], 0.01, 1e3)),
                rounded("minGeom", own.minGeom / k[kFade]), rounded("minBTF", own.minBTF / k[kFade])};
    const double maxGeom = std::clamp(own.maxGeom * k[kNear], 0.1, 1e5);
    const double minGeom = std::clamp(own.minGeom * k[kNear] / k[kFade], 0.0, maxGeom);
    const double maxBTF = std::max(own.maxBTF * k[kFar], maxGeom);
    const double minBTF = std::clamp(own.minBTF * k[kFar] / k[kFade], std::min(maxGeom, maxBTF), maxBTF);
    return {rounded("minGeom", minGeom), rounded("maxGeom", maxGeom), rounded("minBTF", minBTF),
            rounded("maxBTF", maxBTF)};
}
SettingValues hybridTurned(const FieldEntity& field, std::span<const double> k) {
    SettingValues out = tiersTurned(field.settings<HybridTiers>(), k);
    out.push_back(sharpnessTurned(field, k[kSharpness]));
    out.push_back(samplesTurned(k[kSamples]));
    out.push_back(filteringTurned(field, k.back()));
    return out;
}
SettingValues slicesTurned(const FieldEntity& field, std::span<const double> k) {
    const auto& own = field.settings<HybridTiers>();
    SettingValues out;
    if (own.tiersBy == TiersBy::Pixels)
        out = {rounded("slicePixels", std::clamp(own.slicePixels / k[kImagesFar], 0.01, 1e3))};
    else
        out = {rounded("minBTF", own.minBTF * k[kImagesFar]), rounded("maxBTF", own.maxBTF * k[kImagesFar])};
    out.push_back(sharpnessTurned(field, k[kImagesSharpness]));
    out.push_back(samplesTurned(k[kImagesSamples]));
    out.push_back(filteringTurned(field, k.back()));
    return out;
}
SettingValues flatTurned(const FieldEntity& field, std::span<const double> k) {
    return {samplesTurned(k.front()), filteringTurned(field, k.back())};
}

constexpr const char* kFewBlades[] = {"tiersBy=metres", "minGeom=3", "maxGeom=6", "minBTF=6", "maxBTF=6"};
constexpr const char* kHybridSettings[] = {"HybridTiers", "RaytracedGrass", "GrassSlices", "GrassDrawing", "FarLook"};
constexpr const char* kAllSettings[] = {"HybridTiers", "GrassSlices", "GrassDrawing", "FarLook"};
constexpr const char* kBladeSettings[] = {"GrassDrawing", "FarLook"};

}  // namespace

ComponentRow hybridTiersRow() {
    static constexpr Range kDistance{0, 1e6, 0, 200}, kPixels{0.01, 1e3, 0.1, 10};
    static constexpr FieldRow kFields[] = {
        titled("All blades up to", distance("minGeom", offsetof(HybridTiers, minGeom), kDistance,
                                            "up to here every blade is drawn by itself")),
        titled("Blades end at", distance("maxGeom", offsetof(HybridTiers, maxGeom), kDistance,
                                         "from here no blade is drawn by itself; inf: never fades")),
        titled("All slices up to", distance("minBTF", offsetof(HybridTiers, minBTF), kDistance,
                                            "up to here every vertical slice is drawn")),
        titled("Slices end at",
               distance("maxBTF", offsetof(HybridTiers, maxBTF), kDistance,
                        "from here only the horizontal slice is drawn; inf: vertical slices never fade")),
        choice("middleTier", &HybridTiers::middleTier, offsetof(HybridTiers, middleTier), kMiddleTiers,
               "what is drawn between: vertical slices as quads, or rays through them, pixel by pixel"),
        titled("Distances follow",
               choice("tiersBy", &HybridTiers::tiersBy, offsetof(HybridTiers, tiersBy), kTiersBy,
                      "nothing: they are metres; or what the picture shows: farther where it is larger or the lens "
                      "longer, with fades in proportion to the metres above")),
        where(byPixels,
              titled("Blades end at width", real("bladePixels", offsetof(HybridTiers, bladePixels), "px", kPixels,
                                                 "no blade is drawn by itself from where one is narrower than this"))),
        where(byPixels, titled("Slices end at height",
                               real("slicePixels", offsetof(HybridTiers, slicePixels), "px", kPixels,
                                    "only the horizontal slice is drawn from where grass is lower than this"))),
    };
    ComponentRow row = settingsRow<HybridTiers>(
        "HybridTiers", "From where to where grass is blades, slices, and one slice over the ground.", kFields,
        "GrassField");
    row.repair = repairTiers;
    return row;
}

BladeSize bladeSize(const GrassField& field) {
    BladeSize sum;
    float blades = 0;
    for (const Species& s : field.species) {
        sum.width += s.bladesPerM2 * s.width, sum.height += s.bladesPerM2 * s.height;
        blades += s.bladesPerM2;
    }
    return blades > 0 ? BladeSize{sum.width / blades, sum.height / blades} : BladeSize{};
}

HybridTiers tiersSeen(const FieldEntity& field, float pixelsPerMetre) {
    HybridTiers t = field.settings<HybridTiers>();
    if (t.tiersBy == TiersBy::Metres) return t;
    const BladeSize size = bladeSize(field.grows);
    const HybridTiers own = t;
    t.maxGeom = seenTo(own.maxGeom, size.width, pixelsPerMetre, own.bladePixels);
    if (t.maxGeom != own.maxGeom) t.minGeom *= t.maxGeom / own.maxGeom;
    if (own.maxBTF <= 0) return t;  // no slices
    t.maxBTF = std::max(seenTo(own.maxBTF, size.height, pixelsPerMetre, own.slicePixels), kSlicesReach * t.maxGeom);
    if (std::isfinite(t.maxBTF) && own.maxBTF > 0) t.minBTF = std::max(own.minBTF * (t.maxBTF / own.maxBTF), t.maxGeom);
    return t;
}

std::span<const TechniqueRow> hybridTechniques() {
    static constexpr TechniqueRow kRows[] = {
        {.name = "hybrid",
         .label = "Hybrid",
         .help = "blades near the eye, slices of them farther away, one slice over the ground beyond (Boulanger 2006)",
         .color = 0x009e73,
         .settings = kHybridSettings,
         .features = hybridFeatures,
         .tiers = hybridTiers,
         .coarse = withoutBlades,
         .coarseTiers = hybridCoarseTiers,
         .sweep = hybridSweep,
         .fewBlades = kFewBlades,
         .knobs = kHybridKnobs,
         .turned = hybridTurned},
        {.name = "geometry",
         .label = "Geometry",
         .help = "every blade by itself, however far",
         .color = 0xd55e00,
         .settings = kBladeSettings,
         .features = geometryFeatures,
         .tiers = geometryTiers,
         .sweep = geometrySweep},
        {.name = "slices",
         .label = "Slices",
         .help = "vertical slices from the eye on",
         .color = 0x0072b2,
         .settings = kAllSettings,
         .features = slicesFeatures,
         .tiers = slicesTiers,
         .sweep = slicesSweep,
         .knobs = kSlicesKnobs,
         .turned = slicesTurned},
        {.name = "flat",
         .label = "Flat",
         .help = "one slice over the ground everywhere",
         .color = 0xcc79a7,
         .settings = kAllSettings,
         .features = flatFeatures,
         .tiers = flatTiers,
         .sweep = flatSweep,
         .knobs = kFlatKnobs,
         .turned = flatTurned},
    };
    return kRows;
}

}  // namespace sward
