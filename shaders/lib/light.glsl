// The frame's light on surfaces, and haze. Needs: const bool SUN, FOG, ATMOSPHERE.
#include "lib/air.glsl"
#include "lib/frame.glsl"
#include "numerics/light.h"

// Light from above and below on a surface that faces n, divided by pi.
vec3 ambientLight(vec3 n) { return halvesLight(frame.groundLight, frame.skyLight, n.y); }
// The same on an object, where it is known what comes to it from all around: `around`, red below 0: it is not.
vec3 ambientLightOn(vec3 n, vec3 around) { return around.r < 0.0 ? ambientLight(n) : around; }
// Direct light on a surface that faces n; `side` of two-sided surfaces is chosen by the caller.
vec3 sunLight(vec3 n) {
    if (!SUN) return vec3(0.0);
    return frame.sunLight * max(dot(n, frame.sunDirection), 0.0);
}

// The sky's colour at the horizon in a direction.
vec3 horizonColor(vec2 direction) {
    return horizonLight(frame.horizon[0].rgb, frame.horizon[1].rgb, frame.horizon[2].rgb, frame.horizon[3].rgb,
                        frame.horizon[4].rgb, frame.horizonMiddle, frame.horizonScale, frame.skySun.xz, direction);
}
// What haze before a position relative to the eye fades into.
vec3 hazeColor(vec3 position) { return ATMOSPHERE ? airUpTo(position) : horizonColor(position.xz); }
// Share of the light that haze takes away over a distance.
float hazeShare(float distance) {
    if (!FOG && !ATMOSPHERE) return 0.0;
    return hazeTaken(frame.haze, distance);
}
// The light of the haze before a position relative to the eye.
vec3 hazeLight(vec3 position) {
    if (!FOG && !ATMOSPHERE) return vec3(0.0);
    return hazeColor(position) * hazeShare(length(position));
}
