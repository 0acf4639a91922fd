// The land beyond the terrain (world/land.h): how far beyond its edges a place lies, and what stands there for grass
// that is not drawn. Does not: heights.

#ifndef __cplusplus
#include "numerics/glsl.h"
#endif

// Metres from a place (x, z from the terrain's corner) to the terrain's rectangle; 0 on it.
FN real beyondBy(vec2 place, vec2 size) {
    real x = max(max(-place.x, place.x - size.x), real(0.0)), z = max(max(-place.y, place.y - size.y), real(0.0));
    return sqrt(x * x + z * z);
}
// Share that the terrain's mean has so far out. fade: 1 / metres; 0: none.
FN real landMean(real beyond, real fade) {
    real s = clamp(beyond * fade, real(0.0), real(1.0));
    return s * s * (3.0f - 2.0f * s);
}
// Land so far out is of the colour of so much of the terrain's edge to either side, metres: the texels of one place
// would show as streaks.
FN real landSpread(real beyond) { return real(0.3) * beyond; }
// The place of the terrain's edge nearest to one beyond it, then so many metres along the edge.
FN vec2 edgePlace(vec2 place, vec2 size, real along) {
    real x = clamp(place.x, real(0.0), size.x), z = clamp(place.y, real(0.0), size.y), outX = place.x - x,
         outZ = place.y - z, far = sqrt(outX * outX + outZ * outZ), share = far > 0.0f ? along / far : real(0.0);
    return vec2(clamp(x - outZ * share, real(0.0), size.x), clamp(z + outX * share, real(0.0), size.y));
}
// Reflectance: soil under grass that leaves `left` of the light to it and sends `grass`; a share of the mean instead.
FN vec3 landSends(vec3 soil, vec3 grass, real left, vec3 mean, real share) {
    return mix(mix(grass, soil, left), mean, share);
}
