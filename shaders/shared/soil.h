// What the ground reads of what grows on it, over all fields (lib/soil.glsl). Does not: hold what a field's own shaders
// read (grass.h).
#pragma once
#include "shared/grass.h"
#include "shared/types.h"
#define MAX_FIELDS 8
#define MAX_SOIL_SPECIES 64  // of all fields together
#define MAX_SOIL_MAPS 20     // likewise: densities, blade heights and ambient occlusion
#ifdef __cplusplus
namespace sward {
#endif

// Tilings are as in FieldGlobals.
struct STD140 SoilField {
    float shadeFrom;        // distance from which soil is shaded in the mean (m)
    float shadeInv;         // lodInverse to where it is so alone
    float heightTiling;     // of the map of blades' heights
    float occlusionTiling;  // of the map of ambient occlusion
};
struct STD140 SoilSpecies {
    vec2 area;                     // as SliceGlobals
    float tiling;                  // of the density map
    float skyLeft;                 // as SpeciesInField
    float scattered;               // likewise
    float height;                  // mean (m)
    float maskHeight;              // of its blades' shadow mask (m)
    float spare;                   // 0
    vec4 sunFill[TRACED_HEIGHTS];  // of the sun's light, as SpeciesGlobals has it of light from all elevations
};
struct STD140 SoilGlobals {
    SoilField fields[MAX_FIELDS];
    SoilSpecies species[MAX_SOIL_SPECIES];
};

#ifdef __cplusplus
}
#endif
