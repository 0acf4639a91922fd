// The scene's wind at a place. Needs: const bool WIND, GUSTS.
#include "numerics/gust.h"
#include "numerics/wind.h"
#include "shared/bindings.h"
#include "shared/wind.h"

layout(std140, binding = UBO_WIND) uniform WindBlock { WindGlobals wind; };
layout(binding = TEX_WIND) uniform sampler2D gustMap;

float blowsAt(vec2 at) {
    if (GUSTS) {
        vec2 coarse = gustPlace(at, wind.way, wind.coarseBegin, wind.coarseRate),
             fine = gustPlace(at, wind.way, wind.fineBegin, wind.fineRate);
        return gustStrength(textureLod(gustMap, coarse, 0.0).r, textureLod(gustMap, fine, 0.0).r, wind.turbulence);
    }
    WindPhase p = WindPhase(wind.firstPhase, wind.secondPhase, wind.acrossPhase);
    return windAt(p, dot(at, wind.way), at.y * wind.way.x - at.x * wind.way.y, wind.c1, wind.c2, wind.c3, wind.epsilon);
}
// Lean (m per m) at x, z relative to the eye: of a blade of `grain` in [0, 1]; negative: of none in particular.
// strength: lean of a full gust, wind.strength or, of a species, its gusts in FieldGlobals.
vec2 windLeanAt(vec2 at, float grain, float strength) {
    if (!WIND) return vec2(0.0);
    float own =
        grain < 0.0 ? 0.0 : quiver(wind.quiverPhase, grain, gustPlace(at, wind.way, wind.fineBegin, wind.fineRate));
    return windLean(wind.way, strength, blowsAt(at), wind.turbulence, own);
}
