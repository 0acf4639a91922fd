#include "scene/features.h"

#include "core/error.h"

namespace sward {
namespace {
struct FeatureNames {
    const char* name;
    const char* constant;
};
// In the order of Feature.
constexpr FeatureNames kNames[] = {
    {"terrain", "TERRAIN"},
    {"terrain-heights", "TERRAIN_HEIGHTS"},
    {"terrain-map", "TERRAIN_MAP"},
    {"grass", "GRASS"},
    {"grass-geometry", "GRASS_GEOMETRY"},
    {"grass-slices", "GRASS_SLICES"},
    {"grass-far", "GRASS_FAR"},
    {"grass-tessellated", "GRASS_TESSELLATED"},
    {"grass-density", "GRASS_DENSITY"},
    {"grass-heights", "GRASS_HEIGHTS"},
    {"grass-unique", "GRASS_UNIQUE"},
    {"grass-orientation", "GRASS_ORIENTATION"},
    {"grass-vegetation", "GRASS_VEGETATION"},
    {"grass-occlusion", "GRASS_OCCLUSION"},
    {"grass-blended", "GRASS_BLENDED"},
    {"grass-clumps", "GRASS_CLUMPS"},
    {"translucency", "TRANSLUCENCY"},
    {"gloss", "GLOSS"},
    {"blade-shadows", "BLADE_SHADOWS"},
    {"ground-shadows", "GROUND_SHADOWS"},
    {"objects", "OBJECTS"},
    {"object-shadows", "OBJECT_SHADOWS"},
    {"terrain-shadows", "TERRAIN_SHADOWS"},
    {"sun", "SUN"},
    {"lamps", "LAMPS"},
    {"casting-lights", "CASTING_LIGHTS"},
    {"wind", "WIND"},
    {"gusts", "GUSTS"},
    {"forces", "FORCES"},
    {"force-outlines", "FORCE_OUTLINES"},
    {"force-map", "FORCE_MAP"},
    {"far-darkening", "FAR_DARKENING"},
    {"far-blur", "FAR_BLUR"},
    {"sky", "SKY"},
    {"fog", "FOG"},
    {"water", "WATER"},
    {"water-reflection", "WATER_REFLECTION"},
    {"flowers", "FLOWERS"},
    {"flower-density", "FLOWER_DENSITY"},
};
static_assert(std::size(kNames) == static_cast<size_t>(Feature::Count));

const FeatureNames& namesOf(Feature f) {
    CHECK(f < Feature::Count);
    return kNames[static_cast<size_t>(f)];
}
}  // namespace

const char* featureName(Feature f) { return namesOf(f).name; }
const char* featureConstant(Feature f) { return namesOf(f).constant; }

}  // namespace sward
