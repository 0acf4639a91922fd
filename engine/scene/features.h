// Features: the bits that a scene's components ask for, and all that runs (see frame/plan.h).
// sceneFeatures is the one pure function from components to bits. A shader sees feature F as `const bool NAME`.
// Does not: decide what a feature makes run; effect rows do.
#pragma once
#include <bitset>
#include <cstdint>

namespace sward {

enum class Feature : uint8_t {
    Terrain,           // ground is drawn
    TerrainHeights,    // the ground is not flat: a height map
    TerrainMap,        // 004 equation 1: a colour map blended over the ground's tile texture
    Grass,             // blades grow
    GrassGeometry,     // blades are drawn one by one, near the eye or everywhere
    GrassSlices,       // vertical slices are drawn, at middle distance or everywhere
    GrassFar,          // the horizontal slice is drawn
    GrassTessellated,  // blades are drawn one by one, each as finely as its distance asks
    GrassDensity,      // a density map decides where
    GrassHeights,      // a blade-height map lowers blades
    GrassUnique,       // each cell has blades of its own, instead of the patch's
    GrassOrientation,  // a painted direction turns the lean
    GrassVegetation,   // a colour map tints blades
    GrassOcclusion,    // an ambient-occlusion map darkens ambient light
    GrassBlended,      // part-covered pixels are blended with what was drawn before
    GrassClumps,       // a slow field shares lean, height and tint among neighbours
    Translucency,      // light shines through leaves
    Gloss,             // leaves have a waxy highlight
    BladeShadows,      // blades shade blades
    GroundShadows,     // blades shade the ground
    Objects,           // meshes stand in the scene
    ObjectShadows,     // objects shade what lies behind them, and there is a sun
    TerrainShadows,    // hills shade what lies behind them, and there is a sun
    Sun,               // the first directional light
    Lamps,             // any other light
    CastingLights,     // a light casts shadows
    Wind,              // wind blows
    Gusts,             // in gusts, from a picture; else in waves
    Forces,            // something presses on the grass
    ForceOutlines,     // in the shape of an object's outline
    ForceMap,          // painted forces do
    FarDarkening,      // far blades are darker
    FarBlur,           // what is far is blurred
    Sky,               // a sky drawn and lighting by a published model
    Fog,               // haze with distance
    Water,             // water stands where the ground is below its level
    WaterReflection,   // the water mirrors the scene
    Flowers,           // flowers stand among the grass
    FlowerDensity,     // a density map decides where
    Count
};
using FeatureSet = std::bitset<static_cast<size_t>(Feature::Count)>;

// "terrain-heights" and so on, for explain and statistics.
const char* featureName(Feature f);
// "TERRAIN_HEIGHTS", for shaders.
const char* featureConstant(Feature f);

// The set of the features named.
template <class... F>
FeatureSet featureSet(F... f) {
    FeatureSet s;
    (s.set(static_cast<size_t>(f)), ...);
    return s;
}
// Whether `s` has feature `f`.
inline bool has(const FeatureSet& s, Feature f) { return s.test(static_cast<size_t>(f)); }

}  // namespace sward
