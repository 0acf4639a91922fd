// Light on soil under grass, and what is left of it in the shadow of one light. Needs: const bool SUN, LAMPS,
// GROUND_SHADOWS, CASTING_LIGHTS, GRASS_HEIGHTS.
#include "lib/frame.glsl"
#include "lib/lamps.glsl"
#include "lib/light.glsl"
#include "lib/shadow.glsl"

// Share of light that a species leaves to soil where it has this density and share of its height; shade: at 1 and 1.
// What takes light is leaves' area, and that is in proportion to the height.
float soilLeft(float shade, float density, float tall) {
    return mix(1.0, GRASS_HEIGHTS ? pow(max(shade, 1e-6), tall) : shade, density);
}

// Light of one light that casts shadows: 0 the sun, i lamp i - 1.
vec3 castLight(int i, vec3 at, vec3 n) {
    if (i == 0) return sunLight(n) * sunVisible(at, vec3(0.0));
    LampHere l = lampAt(i - 1, at);
    return l.light * max(dot(n, l.direction), 0.0);
}
// What grass leaves to soil of light from everywhere, of light in the mean, and of light from lights that cast its
// shadows: near the eye the blades' own shadows take that; elsewhere the mean does.
struct SoilShares {
    float ambient, mean, casting;
};
// Of grass that leaves `shades` in the mean. near: 1 where blades are drawn, 0 where they are not; sky: share of the
// sky that the ground sees.
SoilShares soilShares(float shades, float near, float sky) {
    bool drawn = GROUND_SHADOWS && CASTING_LIGHTS;
    return SoilShares(shades * sky, shades, drawn ? mix(shades, 1.0, near) : shades);
}
float directShare(bool casts, SoilShares s) { return GROUND_SHADOWS && CASTING_LIGHTS && casts ? s.casting : s.mean; }

vec3 soilLight(vec3 at, vec3 n, SoilShares s) {
    vec3 sum = ambientLight(n) * s.ambient;
    if (SUN) sum += castLight(0, at, n) * directShare(frame.sunCasts > 0.0, s);
    for (int i = 0; i < lampCount(); ++i) sum += castLight(i + 1, at, n) * directShare(i < castingLamps(), s);
    return sum;
}
// Share of that which the shadow of light i takes away; less than all, since other lights and the sky still reach
// there.
vec3 shadowShare(int i, vec3 at, vec3 n, SoilShares s) {
    return clamp(castLight(i, at, n) * directShare(true, s) / max(soilLight(at, n, s), vec3(1e-6)), vec3(0.0),
                 vec3(1.0));
}
