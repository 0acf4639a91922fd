// Lights beside the sun. Does not: hold the sun (frame.h) or its shadows (objects.h).
#pragma once
#include "shared/bindings.h"
#include "shared/types.h"
#define MAX_LIGHTS 8
#ifdef __cplusplus
namespace sward {
#endif

struct STD140 LightGlobals {
    vec3 place;     // of a lamp: relative to the eye; of a directional light: unit vector towards it
    float isPoint;  // 1: a lamp that stands somewhere; 0: directional
    vec3 color;     // irradiance on a surface that faces it, divided by pi, before attenuation
    float beta;     // attenuation by 1 / (1 + beta d2) (1/m2)
};

struct STD140 LightsGlobals {
    LightGlobals lights[MAX_LIGHTS];
    int count;    // lights
    int casting;  // how many of them, the first ones, cast shadows
};

#ifdef __cplusplus
}
#endif
