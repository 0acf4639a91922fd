// Light on soil under grass, and what is left of it in the shadow of one light. Needs: const bool SUN, LAMPS,
// GROUND_SHADOWS, CASTING_LIGHTS, GRASS_HEIGHTS; light.glsl, lamps.glsl, density.glsl, shadow.glsl.

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
// Share of direct light left to soil under grass: near the eye the blades' own shadows take it from lights that cast
// them; elsewhere `shades`, the mean. near: 1 where blades are drawn, 0 where they are not.
float directShare(bool casts, float shades, float near) {
    return GROUND_SHADOWS && CASTING_LIGHTS && casts ? mix(shades, 1.0, near) : shades;
}

vec3 soilLight(vec3 at, vec2 uv, vec3 n, float shades, float near) {
    vec3 sum = ambientLight(n) * (shades * skyShare(uv));
    if (SUN) sum += castLight(0, at, n) * directShare(frame.sunCasts > 0.0, shades, near);
    for (int i = 0; i < lampCount(); ++i)
        sum += castLight(i + 1, at, n) * directShare(i < castingLamps(), shades, near);
    return sum;
}
// Share of that which the shadow of light i takes away; less than all, since other lights and the sky still reach
// there.
vec3 shadowShare(int i, vec3 at, vec2 uv, vec3 n, float shades, float near) {
    return clamp(
        castLight(i, at, n) * directShare(true, shades, near) / max(soilLight(at, uv, n, shades, near), vec3(1e-6)),
        vec3(0.0), vec3(1.0));
}
