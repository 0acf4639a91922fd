// Light on soil under grass, and what is left of it in the shadow of one light. Needs: const bool SUN, LAMPS,
// GROUND_SHADOWS, CASTING_LIGHTS, OBJECT_LIGHT, GRASS_HEIGHTS, GRASS_TRACED; what lib/lamp_shadow.glsl and
// lib/shadow.glsl need.
#include "lib/frame.glsl"
#include "lib/ground_around.glsl"
#include "lib/lamp_shadow.glsl"
#include "lib/lamps.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"
#include "numerics/slope.h"

// The slope of ground of this upward normal, as lib/heights.glsl has it.
vec2 slopeOf(vec3 n) { return -n.xz / max(n.y, 0.05); }
// Share of light that a species leaves to soil where it has this density and share of its height; shade: at 1 and 1.
// What takes light is leaves' area, and that is in proportion to both (Beer's law).
vec3 soilLeft(vec3 shade, float density, float tall) {
    return pow(max(shade, vec3(1e-6)), vec3(GRASS_HEIGHTS ? density * tall : density));
}
float soilLeft(float shade, float density, float tall) { return soilLeft(vec3(shade), density, tall).x; }
// The share of the sun's light that is left, and of a lamp's that stands so high (sine: kLampSines); of the sky's; and
// of the sun's what comes from blade to blade.
struct SoilLeft {
    float sun;
    vec3 lamps;
    float sky, scattered;
};
const SoilLeft kAllLeft = SoilLeft(1.0, vec3(1.0), 1.0, 0.0);
const vec3 kLampSines = vec3(0.2, 0.5, 1.0);
SoilLeft times(SoilLeft a, SoilLeft b) {
    return SoilLeft(a.sun * b.sun, a.lamps * b.lamps, a.sky * b.sky, a.scattered * b.sky + b.scattered * a.sky);
}
// By Beer's law through leaves of so much area (SliceGlobals), as `shade` is for the sun.
vec3 lampShades(vec2 area) {
    vec3 across = area.x * sqrt(vec3(1.0) - kLampSines * kLampSines), above = area.y * kLampSines;
    return exp(-sqrt(across * across + above * above) / kLampSines);
}
// Likewise for the sun over ground of this slope.
float sunShade(vec2 area, vec2 slope) {
    return exp(-leafDepth(area, frame.sunDirection, max(riseOver(frame.sunDirection, slope), kLeastRise)));
}
// indirect: shares of the sky's light that is left, and of the sun's that comes from blade to blade (SpeciesInField),
// which is as much more as more of its light comes in; before: density of what stands before the sun.
SoilLeft soilLeft(vec2 area, vec2 indirect, vec2 slope, float density, float before, float tall) {
    vec3 sun = frame.sunDirection;
    float more = max(riseOver(sun, slope), 0.0) / max(sun.y, kLeastRise);
    return SoilLeft(SUN ? soilLeft(sunShade(area, slope), before, tall) : 1.0,
                    LAMPS ? soilLeft(lampShades(area), density, tall) : vec3(1.0), soilLeft(indirect.x, density, tall),
                    indirect.y * more * density * (GRASS_HEIGHTS ? tall : 1.0));
}
float lampLeft(SoilLeft left, float sine) {
    vec2 steps = clamp((sine - kLampSines.xy) / (kLampSines.yz - kLampSines.xy), 0.0, 1.0);
    return mix(mix(left.lamps.x, left.lamps.y, steps.x), left.lamps.z, steps.y);
}

// Light of the sun, and of lamp i, past what stands in its way.
vec3 sunCast(vec3 at, vec3 n) { return sunLight(n) * sunVisible(at, vec3(0.0)); }
vec3 lampCast(int i, vec3 at, vec3 n) {
    LampHere l = lampReaching(i, at, vec3(0.0));
    return l.light * max(dot(n, l.direction), 0.0);
}
// What grass leaves to soil of light from everywhere, of light in the mean, and of light from lights that cast its
// shadows: near the eye the blades' own shadows take that; elsewhere the mean does.
struct SoilShares {
    float ambient;
    SoilLeft mean, casting;
};
// Of grass that leaves `shades` in the mean. near: 1 where blades are drawn, 0 where they are not; sky: share of the
// sky that the ground sees.
SoilShares soilShares(SoilLeft shades, float near, float sky) {
    SoilLeft casting =
        SoilLeft(mix(shades.sun, 1.0, near), mix(shades.lamps, vec3(1.0), near), shades.sky, shades.scattered);
    return SoilShares(shades.sky * sky, shades, GROUND_SHADOWS && CASTING_LIGHTS ? casting : shades);
}
// Light of the sun, and of lamp i, on soil. A lamp has an index of its own, never the sun's less one: an index that is
// known to lie below its array is an error to some compilers, even where it is never reached.
vec3 sunOnSoil(vec3 at, vec3 n, SoilLeft left) { return sunCast(at, n) * left.sun; }
vec3 lampOnSoil(int i, vec3 at, vec3 n, SoilLeft left) {
    return lampCast(i, at, n) * lampLeft(left, normalize(overLevel(lampAt(i, at).direction, slopeOf(n))).y);
}

vec3 soilLight(vec3 at, vec3 n, SoilShares s) {
    vec3 sum = ambientLight(n) * groundAround(at) * (s.ambient * skyPastTrees(at));
    if (SUN) sum += sunOnSoil(at, n, frame.sunCasts > 0.0 ? s.casting : s.mean);
    if (SUN && GRASS_TRACED) sum += frame.sunLight * (frame.sunIsUp * s.mean.scattered * sunVisible(at, vec3(0.0)));
    for (int i = 0; i < lampCount(); ++i) sum += lampOnSoil(i, at, n, i < castingLamps() ? s.casting : s.mean);
    return sum;
}
// Share of that which the shadow of one light takes away (0: the sun; i: lamp i - 1); less than all, since other lights
// and the sky still reach there.
vec3 shadowShare(int light, vec3 at, vec3 n, SoilShares s) {
    vec3 taken = light == 0 ? sunOnSoil(at, n, s.casting) : lampOnSoil(light - 1, at, n, s.casting);
    return clamp(taken / max(soilLight(at, n, s), vec3(1e-6)), vec3(0.0), vec3(1.0));
}
