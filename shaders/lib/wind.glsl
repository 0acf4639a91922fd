// The scene's wind at a place, now and in the frame before. Needs: const bool WIND, GUSTS.
#include "numerics/gust.h"
#include "numerics/wind.h"
#include "shared/bindings.h"
#include "shared/wind.h"

layout(std140, binding = UBO_WIND) uniform WindBlock { WindGlobals winds[2]; };  // both about the eye as it is now
const int NOW = 0, BEFORE = 1;  // of winds: of this frame, and of the one before
layout(binding = TEX_WIND) uniform sampler2D gustMap;

float blowsAt(WindGlobals w, vec2 at) {
    if (GUSTS) {
        vec2 coarse = gustPlace(at, w.way, w.coarseBegin, w.coarseRate),
             fine = gustPlace(at, w.way, w.fineBegin, w.fineRate);
        return gustStrength(textureLod(gustMap, coarse, 0.0).r, textureLod(gustMap, fine, 0.0).r, w.turbulence);
    }
    WindPhase p = WindPhase(w.firstPhase, w.secondPhase, w.acrossPhase);
    return windAt(p, dot(at, w.way), at.y * w.way.x - at.x * w.way.y, w.c1, w.c2, w.c3, w.epsilon);
}
// Lean (m per m) at x, z relative to the eye: of a blade of `grain` in [0, 1]; negative: of none in particular.
// strength: lean of a full gust, wind.strength or, of a species, its gusts in FieldGlobals.
vec2 windLeanOf(WindGlobals w, vec2 at, float grain, float strength) {
    if (!WIND) return vec2(0.0);
    float own = grain < 0.0 ? 0.0 : quiver(w.quiverPhase, grain, gustPlace(at, w.way, w.fineBegin, w.fineRate));
    return windLean(w.way, strength, blowsAt(w, at), w.turbulence, own);
}
vec2 windLeanAt(vec2 at, float grain, float strength) { return windLeanOf(winds[NOW], at, grain, strength); }
vec2 windLeanBefore(vec2 at, float grain, float strength) { return windLeanOf(winds[BEFORE], at, grain, strength); }
