// Repeating coordinates (Boulanger, Pattanaik, Bouatouch 2006, eqs 6 and 7).
// On the GPU only the formula suite runs this (shaders/formulas).

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

// x modulo 1 in [0, 1), floored; x - floor(x) alone is 1 for x = -1e-9 and would read the neighbouring tile. Above 2^23
// nothing is left of the fraction.
FN real wrapUnit(real x) { return clamp(x - floor(x), real(0.0), real(0.99999994039535522)); }
// "mod 1" as C, HLSL and WGSL have it: negative for negative x.
FN real wrapTruncated(real x) { return x - (x < 0.0f ? ceil(x) : floor(x)); }

// Coordinate in [0, 1) of a patch's texture at `local` in [0, 1] of its cell, mirrored if sign is negative. Cells are
// addressed by integer id and local coordinate: a terrain-wide coordinate is a texel off at 65,536 cells.
FN real patchCoordinate(real local, real sign) { return wrapUnit(sign < 0.0f ? 1.0f - local : local); }
// The fraction of a terrain-wide u in [0, 1] times the number of cells (eq 6).
FN real patchCoordinatePublished(real u, real cells) { return wrapUnit(u * cells); }

// Slice number k of n with x in [k/n, (k+1)/n), x in [0, 1): half open, so that each blade is captured once.
FN int captureSlice(real x, int n) {
    int k = clamp(int(floor(x * real(n))), 0, n - 1);
    if (x < real(k) / real(n)) k = max(k - 1, 0);
    if (x >= real(k + 1) / real(n)) k = min(k + 1, n - 1);
    return k;
}

// Painting: how strongly a brush of `radius` acts at distance d from its stroke, in [0, 1]; falloff 0 is a hard edge, 1
// falls from the centre. A radius of 0 paints nothing.
FN real brushWeight(real d, real radius, real falloff) {
    if (!(d < radius)) return real(0.0);
    return min((1.0f - d / max(radius, kTiny)) / max(falloff, kTiny), real(1.0));
}
// Distance of p from the segment a b; a segment of length 0 is its point.
FN real segmentDistance(vec2 p, vec2 a, vec2 b) {
    vec2 d = b - a;
    real t = clamp(dot(p - a, d) / max(dot(d, d), kTiny), real(0.0), real(1.0));
    vec2 r = p - a - d * t;
    return sqrt(dot(r, r));
}
FN real segmentDistancePublished(vec2 p, vec2 a, vec2 b) {
    vec2 d = b - a;
    vec2 r = p - a - d * clamp(dot(p - a, d) / dot(d, d), real(0.0), real(1.0));
    return sqrt(dot(r, r));
}

// The random values of Jahrmann and Wimmer 2013, eqs 10 to 12, as printed; hashUnit(hash3(...)) replaces them.
FN real randomEq10(real r, real x, real z) { return wrapUnit(r * x / z); }
FN real randomEq11(real r, real x, real dimension) { return r * x / dimension; }
FN real randomEq12(real r, real x, real c) { return r * sin(c * x); }
