// What moves the grass, about the eye: the wind (world/wind.h) and the map of what presses on it (grass/forces.h).
// Does not: say how blades answer; numerics/gust.h does.
#pragma once
#include "shared/bindings.h"
#include "shared/types.h"
#ifdef __cplusplus
namespace sward {
#endif

struct STD140 WindGlobals {
    vec2 way;           // x, z of the unit vector along which it blows
    float strength;     // lean (m per m) of a full gust at stiffness 1
    float turbulence;   // share of it that changes, in [0, 1]
    vec2 coarseBegin;   // the eye's place in the picture of gusts, in repeats of it: along, across
    vec2 fineBegin;     // the same for finer gusts
    vec2 coarseRate;    // repeats a metre: along, across
    vec2 fineRate;      // the same for finer gusts
    float quiverPhase;  // turns
    float firstPhase;   // WindPhase of the eye (numerics/wind.h)
    float secondPhase;
    float acrossPhase;
    float c1;  // of equation 9
    float c2;
    float c3;
    float epsilon;
};

struct STD140 ForceGlobals {
    vec2 corner;  // of the map: x, z relative to the eye
    float share;  // 1 / its side (1/m)
};

#ifdef __cplusplus
}
#endif
