// Water, about the eye (world/water.h). Does not: hold what it mirrors, which is a texture.
#pragma once
#include "shared/types.h"
#define WATER_WAVES 10
#define WATER_COVERS 32
#ifdef __cplusplus
namespace sward {
#endif

// A ripple of full strength.
struct STD140 WaterWave {
    vec2 turns;   // a metre, along x and z
    float phase;  // at the eye (turns)
    float slope;  // at its steepest
};

struct STD140 WaterGlobals {
    vec3 color;        // of deep water
    float height;      // relative to the eye
    vec3 extinction;   // 1/m
    float mirroredAt;  // metres from the surface at which mirrored things are taken to be
    vec2 low;          // x, z of what may be seen of it, relative to the eye: from
    vec2 high;         // to
    vec2 mirrorScale;  // texture coordinates of the picture of what it mirrors, a clip unit,
    vec2 mirrorAt;     // and those at the middle of the view
    vec2 middle;       // x, z of the place over which it stands, relative to the eye
    float radius;      // of that place (m)
    float mirrors;     // 1: there is such a picture; 0: it mirrors only the sky
    vec4 land;         // x, z of the terrain, relative to the eye: from, to
    WaterWave waves[WATER_WAVES];
    // Waters whose surface hides its own where both stand: x, z of the middle, relative to the eye, radius (m) and
    // height relative to the eye. The first of radius 0 ends them.
    vec4 covers[WATER_COVERS];
};

#ifdef __cplusplus
}
#endif
