#include "grass/raytraced_settings.h"

#include "core/json.h"
#include "scene/field_rows.h"

namespace sward {
namespace {

constexpr float kFadeFrom = 0.7f;  // share of maxDistance from which the horizontal slice takes over

FeatureSet featuresOfRays(const FieldEntity&) { return featureSet(Feature::GrassRaytraced, Feature::GrassFar); }

FieldTiers rayTiers(const FieldEntity& field, float) {
    const float far = field.settings<RaytracedGrass>().maxDistance;
    FieldTiers t;
    t.flat = std::isinf(far) ? FadeRange{0, 0, INFINITY} : fadeRange(kFadeFrom * far, far);
    t.soil = fadeRange(kFadeFrom * far, far);
    t.slicesTo = far;
    t.shadowsTo = far;
    return t;
}

std::vector<SettingValues> sweepRays(const FieldEntity&) {
    std::vector<SettingValues> out;
    for (const char* steps : {"steps=4", "steps=8", "steps=16", "steps=32"})
        for (const char* msaa : {"msaa=1", "msaa=4"}) out.push_back({steps, msaa});
    for (const char* one :
         {"rest=opaque", "rest=nothing", "sliceCover=published", "sets=shared", "visibility=scene", "footprint=0"})
        out.push_back({one, "msaa=4"});
    out.push_back({kTemporalSetting});
    return out;
}

constexpr KnobRow kKnobs[] = {{"steps", true, 1, 0, 1e30, true}, {"far", true, 1, 0, 1e30, true}};
// steps: slices that a ray looks at; far: how far rays are traced.
SettingValues raysTurned(const FieldEntity& field, std::span<const double> k) {
    const auto& own = field.settings<RaytracedGrass>();
    const double steps = std::clamp(std::round(own.steps * k[0]), 1.0, 64.0),
                 far = std::clamp(static_cast<double>(own.maxDistance) * k[1], 0.1, 1e6);
    return {fmt::format("steps={}", static_cast<int>(steps)),
            "maxDistance=" + shortestText(static_cast<float>(std::round(far * 1000) / 1000))};
}

constexpr const char* kSettings[] = {"RaytracedGrass", "GrassSlices", "GrassDrawing", "FarLook"};

}  // namespace

ComponentRow raytracedGrassRow() {
    static constexpr FieldRow kFields[] = {
        whole("steps", offsetof(RaytracedGrass, steps), "", {1, 64, 4, 48}, "slices that a ray crosses, at most"),
        titled("All steps from",
               real("footprint", offsetof(RaytracedGrass, footprint), "px", {0, 64, 0, 8},
                    "where slices lie nearer to each other than this, rays take fewer steps; 0: all steps everywhere")),
        titled("Rays end at opacity",
               real("cutOff", offsetof(RaytracedGrass, cutOff), "", {0.5, 1, 0.8, 1}, "opacity at which a ray ends")),
        titled("Depth taken at",
               real("depthAt", offsetof(RaytracedGrass, depthAt), "", kShare,
                    "share of its opacity at which a ray's depth is taken, which decides what hides it")),
        titled(
            "Beyond the last step",
            choice(
                "rest", &RaytracedGrass::rest, offsetof(RaytracedGrass, rest), kRayRests,
                "what stands for slices beyond the last step: their mean, the next one as if opaque (as published), or "
                "nothing")),
        choice("visibility", &RaytracedGrass::visibility, offsetof(RaytracedGrass, visibility), kRayVisibilities,
               "how grass and what stands in it hide each other: by one depth a pixel, or each ray ends at the scene"),
        real("maxDistance", offsetof(RaytracedGrass, maxDistance), "m", {0.1, 1e6, 5, 200},
             "from here the horizontal slice alone is drawn; inf: never"),
    };
    return settingsRow<RaytracedGrass>("RaytracedGrass", "How rays are traced through slices, and how far.", kFields,
                                       "GrassField");
}

TechniqueRow raytracedTechnique() {
    return {.name = "raytraced",
            .label = "Ray-traced",
            .help = "rays through vertical slices, pixel by pixel (Habel 2007)",
            .color = 0xf0e442,
            .settings = kSettings,
            .features = featuresOfRays,
            .tiers = rayTiers,
            .sweep = sweepRays,
            .knobs = kKnobs,
            .turned = raysTurned};
}

}  // namespace sward
