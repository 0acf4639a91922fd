// By how much grass is brighter than its local light says, as polynomials fitted to traced rays (grass/traced.h).

#ifndef __cplusplus
#include "numerics/glsl.h"
#endif

// 1, y, y^2. y: sine of the elevation of eye or light; beyond [0, 1] it is clamped.
FN vec3 tracedRise(real y) {
    real up = clamp(y, real(0.0), real(1.0));
    return vec3(real(1.0), up, up * up);
}
// How high a direction above the horizon (unit) lies among those that looks are tabulated for: 0 level, 1 upright. Even
// steps of it are fine where grass changes most: near the ground, and where one begins to look down into it.
FN real lookHeight(vec3 towards) {
    real level = length(vec2(towards.x, towards.z));
    return sqrt(clamp(real(0.5) * (towards.y + real(1.0) - level), real(0.0), real(1.0)));
}
// Where a light of this sine of its elevation lies among the seven for which factors are kept: 0 to 6, straight
// between.
FN real tracedLightAt(real sine) {
    if (sine < real(0.2)) return clamp((sine - real(0.1)) / real(0.1), real(0.0), real(1.0));
    if (sine < real(0.8)) return real(1.0) + (sine - real(0.2)) / real(0.15);
    return real(5.0) + clamp((sine - real(0.8)) / real(0.19), real(0.0), real(1.0));
}
// Share of a factor that holds at a density in [0, 1]; area: of blades towards a level view at density 1, m2 a m2 of
// ground. Grass so deep that one cannot see through it has all of it at any density: only lengths are others there.
FN real tracedShare(real density, real area) {
    real all = max(area, real(1e-3));
    return (real(1.0) - exp(-all * density)) / (real(1.0) - exp(-all));
}
// How much each of three heights, the soil's, half of the mask's and the mask's, counts at a share of it, straight
// between them.
FN vec3 tracedHeights(real share) {
    real at = clamp(share, real(0.0), real(1.0)) * real(2.0);
    return vec3(max(real(1.0) - at, real(0.0)), real(1.0) - abs(at - real(1.0)), max(at - real(1.0), real(0.0)));
}
// What the factor of a direct light is a sum of, for one elevation of the light.
struct TracedTerms {
    vec3 rise;    // of the eye: tracedRise
    vec3 across;  // h, h y, h^2
    real near2;   // square of the cosine between, on the light's side
    real glow;    // tracedGlow
};
// How nearly an eye looks along the light (both unit): 1 where it does, and sees what is lit alone; a third at 3
// degrees to a side, where blades no longer hide their shadows, and at 10 degrees higher or lower: there the shadow
// still falls on the blade itself, or behind it.
FN real tracedGlow(vec3 toEye, vec3 towards) {
    real eye = length(vec2(toEye.x, toEye.z)), light = length(vec2(towards.x, towards.z));
    real aside2 = real(2.0) * max(eye * light - toEye.x * towards.x - toEye.z * towards.z, real(0.0));
    real level = eye - light, up = toEye.y - towards.y;
    return exp(-sqrt(real(400.0) * aside2 + real(36.0) * (level * level + up * up)));
}
// Towards the eye and the light, unit; h is the product of their level parts.
FN TracedTerms tracedTerms(vec3 toEye, vec3 towards) {
    TracedTerms t;
    t.rise = tracedRise(toEye.y);
    real h = toEye.x * towards.x + toEye.z * towards.z;
    t.across = vec3(h, h * t.rise.y, h * h);
    real near = max(h + t.rise.y * towards.y, real(0.0));
    t.near2 = near * near;
    t.glow = tracedGlow(toEye, towards);
    return t;
}
