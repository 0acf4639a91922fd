// The scene's wind at a place. Needs: const bool WIND, GUSTS; frame.glsl; numerics glsl, basics.
#include "numerics/wind.h"
#include "numerics/gust.h"
layout(std140, binding = UBO_WIND) uniform WindBlock { WindGlobals wind; };
layout(binding = TEX_WIND) uniform sampler2D gustMap;

float blowsAt(vec2 at) {
    if (GUSTS) {
        vec2 coarse = gustPlace(at, wind.way.xy, wind.begin.xy, wind.rate.xy),
             fine = gustPlace(at, wind.way.xy, wind.begin.zw, wind.rate.zw);
        return gustStrength(textureLod(gustMap, coarse, 0.0).r, textureLod(gustMap, fine, 0.0).r, wind.way.w);
    }
    WindPhase p = WindPhase(wind.phases.y, wind.phases.z, wind.phases.w);
    return windAt(p, dot(at, wind.way.xy), at.y * wind.way.x - at.x * wind.way.y, wind.waves.x, wind.waves.y,
                  wind.waves.z, wind.waves.w);
}
// Lean (m per m) at x, z relative to the eye: of a blade of `grain` in [0, 1]; negative: of none in particular.
// strength: lean of a full gust, wind.way.z or, of a species, cover.gusts.
vec2 windLeanAt(vec2 at, float grain, float strength) {
    if (!WIND) return vec2(0.0);
    float own =
        grain < 0.0 ? 0.0 : quiver(wind.phases.x, grain, gustPlace(at, wind.way.xy, wind.begin.zw, wind.rate.zw));
    return windLean(wind.way.xy, strength, blowsAt(at), wind.way.w, own);
}
