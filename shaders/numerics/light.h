// Light that all surfaces of a view share: from the sky's two halves, from the horizon, through haze. Light is divided by pi,
// as the frame's globals give it.

// From above and below on a surface whose unit normal rises by `up`: a mix of what level ground and a ceiling receive.
FN vec3 halvesLight(vec3 below, vec3 above, real up) { return mix(below, above, real(0.5) + real(0.5) * up); }

// The sky's colour at the horizon along `direction` (x, z; any length): exact towards, across and away from the sun (x, z of
// its unit vector), smooth between. A sun at the zenith has no side: then it is the one across.
FN vec3 horizonLight(vec3 towards, vec3 across, vec3 away, vec2 sun, vec2 direction) {
    real size = max(sqrt(dot(sun, sun)) * sqrt(dot(direction, direction)), real(1e-6));
    real c = clamp(dot(sun, direction) / size, real(-1.0), real(1.0));
    return mix(across, c > 0.0f ? towards : away, c * c);
}

// Share of light that haze of this extinction (1/m, 0 or more) takes away over a distance (m).
FN real hazeTaken(real extinction, real distance) { return 1.0f - exp(-extinction * distance); }

// Distance at which a ray that sinks by `down` (unit, above 0) from a height above the plain reaches it; never less than half
// a metre of height.
FN real plainDistance(real height, real down) { return max(height, real(0.5)) / max(down, real(1e-5)); }
// The plain beyond the terrain: what ground throws back, lost in the horizon's colour by haze, or in 4 km of clear air.
FN vec3 plainLight(vec3 ground, vec3 horizon, real extinction, real distance) {
    return mix(ground, horizon, hazeTaken(max(extinction, real(0.001)), distance));
}

// How much brighter than its light (divided by pi) the sun's disc is shown, by the cosine to its middle; the edge is soft.
FN real sunDisc(real cosine) {
    real s = clamp((cosine - real(0.99996)) / real(0.00003), real(0.0), real(1.0));
    return real(40.0) * s * s * (3.0f - 2.0f * s);
}

// Soil: a tile's colour under a painted one of opacity alpha, which keeps a quarter of the tile's grain (Jahrmann and Wimmer
// 2013, equation 1). mean: of the tile's reflectance.
FN vec3 soilColor(vec3 tile, vec3 mean, vec3 paint, real alpha) {
    vec3 grain = tile / max(mean, vec3(real(1e-3), real(1e-3), real(1e-3)));
    return mix(tile, paint * (vec3(real(0.75), real(0.75), real(0.75)) + grain * real(0.25)), alpha);
}
