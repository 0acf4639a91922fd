// Light that all surfaces of a view share: from the sky's two halves, from the horizon, through haze. Light is divided
// by pi, as the frame's globals give it.

#ifndef __cplusplus
#include "numerics/glsl.h"
#endif

// From above and below on a surface whose unit normal rises by `up`: a mix of what level ground and a ceiling receive.
FN vec3 halvesLight(vec3 below, vec3 above, real up) { return mix(below, above, real(0.5) + real(0.5) * up); }

// The sky's colour at the horizon along `direction` (x, z; any length), as a polynomial of the chord to the sun, in
// which the sun's glow is smooth: t = (chord - middle) * scale is in [-1, 1]; h0 to h4 are its factors. sun: x, z of
// its unit vector.
FN vec3 horizonLight(vec3 h0, vec3 h1, vec3 h2, vec3 h3, vec3 h4, real middle, real scale, vec2 sun, vec2 direction) {
    real c = dot(sun, direction) / max(sqrt(dot(direction, direction)), real(1e-6));
    real t = clamp((sqrt(max(2.0f - 2.0f * c, real(0.0))) - middle) * scale, real(-1.0), real(1.0));
    return max(h0 + (h1 + (h2 + (h3 + h4 * t) * t) * t) * t, vec3(0.0f, 0.0f, 0.0f));
}

// Share of light that haze of this extinction (1/m, 0 or more) takes away over a distance (m).
FN real hazeTaken(real extinction, real distance) { return 1.0f - exp(-extinction * distance); }

// Distance at which haze of this extinction (1/m) has taken all but 1/256 of the light: what is left of a landscape
// differs from the horizon by less than half a level of 255.
FN real hazeReach(real extinction) { return real(5.5451774) / max(extinction, real(1e-9)); }

// Distance at which a ray leaves the terrain's rectangle of this size (m), from a place in it (x, z, from its corner);
// 0 from outside.
FN real edgeDistance(vec2 place, vec2 size, vec2 way) {
    if (!(min(min(place.x, place.y), min(size.x - place.x, size.y - place.y)) > 0.0f)) return real(0.0);
    real x = (way.x > 0.0f ? size.x - place.x : place.x) / max(abs(way.x), real(1e-9));
    real z = (way.y > 0.0f ? size.y - place.y : place.y) / max(abs(way.y), real(1e-9));
    return min(x, z);
}
// Distance at which a ray along `way` (unit, sinking) reaches the plain beyond the terrain. eye: from the terrain's
// corner (m), counted as half a metre high at least.
FN real plainDistance(vec3 eye, vec2 size, vec3 way) {
    return max(max(eye.y, real(0.5)) / max(-way.y, real(1e-5)),
               edgeDistance(vec2(eye.x, eye.z), size, vec2(way.x, way.z)));
}
// Extinction (1/m) before the plain beyond the terrain where no model of air says it: clear air hides it in 4 km.
FN real clearHaze(real extinction) { return max(extinction, real(0.001)); }
// The plain beyond the terrain: what ground throws back, lost in the horizon's colour by haze.
FN vec3 plainLight(vec3 ground, vec3 horizon, real extinction, real distance) {
    return mix(ground, horizon, hazeTaken(extinction, distance));
}

// How much brighter than its light (divided by pi) the sun's disc is shown, by the cosine to its middle; the edge is
// soft.
FN real sunDisc(real cosine) {
    real s = clamp((cosine - real(0.99996)) / real(0.00003), real(0.0), real(1.0));
    return real(40.0) * s * s * (3.0f - 2.0f * s);
}

// Soil: a tile's colour under a painted one of opacity alpha, which keeps a quarter of the tile's grain (Jahrmann and
// Wimmer 2013, equation 1). mean: of the tile's reflectance.
FN vec3 soilColor(vec3 tile, vec3 mean, vec3 paint, real alpha) {
    vec3 grain = tile / max(mean, vec3(real(1e-3), real(1e-3), real(1e-3)));
    return mix(tile, paint * (vec3(real(0.75), real(0.75), real(0.75)) + grain * real(0.25)), alpha);
}
