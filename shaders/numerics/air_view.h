// Where the tables of sky and air (sky/air_tables.h) hold what is seen in a direction, and over a distance: shares of
// their width and height. Both are alike on either side of the sun's plane. Source of the squeeze towards the horizon:
// Hillaire 2020, section 5.3. Does not: hold light.

#ifndef __cplusplus
#include "numerics/glsl.h"
#endif

const real kAirFar = real(256e3);  // metres to which the air is tabled

// By the angle between two level directions (x, z; any length): half the chord, 0 to 1, which needs no arc and is
// finest towards the sun.
FN real airAcross(vec2 sun, vec2 way) {
    real c = dot(sun, way) / max(sqrt(dot(sun, sun) * dot(way, way)), real(1e-9));
    return sqrt(clamp(real(0.5) - real(0.5) * c, real(0.0), real(1.0)));
}
// By the height over the horizon, of a unit vector that rises by `up`; below the horizon as there.
FN real skyUp(real up) {
    real y = clamp(up, real(0.0), real(1.0));
    return sqrt(atan(y, sqrt(1.0f - y * y)) * real(0.63661977236758138));
}
// The sine of the height over the horizon for a share.
FN real skySine(real share) { return sin(share * share * real(1.5707963267948966)); }
// By distance (m); and back.
FN real airAlong(real distance) { return sqrt(clamp(distance / kAirFar, real(0.0), real(1.0))); }
FN real airDistance(real share) { return share * share * kAirFar; }

// A share as a texture's coordinate, n texels across, of which the outer ones' middles are 0 and 1.
FN real airTexel(real share, int n) { return (share * real(n - 1) + 0.5f) / real(n); }
