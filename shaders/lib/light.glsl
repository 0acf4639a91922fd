// The frame's light on surfaces, and haze. Needs: const bool SUN, SKY, FOG; frame.glsl.

// Light from above and below on a surface that faces n, divided by pi.
vec3 ambientLight(vec3 n) {
    return mix(frame.groundLight.rgb, frame.skyLight.rgb, 0.5 + 0.5 * n.y);
}
// Direct light on a surface that faces n; `side` of two-sided surfaces is chosen by the caller.
vec3 sunLight(vec3 n) {
    if (!SUN) return vec3(0.0);
    return frame.sunLight.rgb * max(dot(n, frame.sunDirection.xyz), 0.0);
}

// The sky's colour at the horizon in a direction: exact towards, across and away from the sun, smooth between.
vec3 horizonColor(vec2 direction) {
    vec2 sun = frame.skySun.xz;
    float across = max(length(sun) * length(direction), 1e-6);
    float c = clamp(dot(sun, direction) / across, -1.0, 1.0);
    return c > 0.0 ? mix(frame.horizon[1].rgb, frame.horizon[0].rgb, c * c) : mix(frame.horizon[1].rgb, frame.horizon[2].rgb, c * c);
}
// Share of the light that haze takes away over a distance.
float hazeShare(float distance) {
    if (!FOG) return 0.0;
    return 1.0 - exp(-frame.haze.x * distance);
}
