// Level-of-detail weights by distance, finite for every range (Boulanger, Pattanaik, Bouatouch 2006, eqs 2-4).
// Cost: one multiplication, one clamp and one select a ramp; the division is made once, on the CPU.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

// What lodRamp wants to know of the range from a to b (metres, a >= 0), beside a itself:
//   1 / (b - a); 0 if b is at least 1e30 ("never fades", infinity included); -1 ("a step at a") if b <= a, because
//   swapped distances count as equal ones.
FN real lodInverse(real a, real b) {
    if (!(b < real(1e30))) return real(0.0);
    if (!(b > a)) return real(-1.0);
    return 1.0f / max(b - a, kTiny);
}

// 0 nearer than `near`, 1 farther than the range's end, linear between. inv comes from lodInverse(near, far).
// At a step d < near is near. A distance that is not a number or overflows counts as far.
FN real lodRamp(real d, real near, real inv) {
    if (inv < 0.0f) return d < near ? real(0.0) : real(1.0);
    if (inv == 0.0f) return real(0.0);
    real s = (d - near) * inv;
    return s < 1.0f ? max(s, real(0.0)) : real(1.0);
}

struct LodWeights {
    real geometry;    // eq 2
    real vertical;    // eq 3
    real horizontal;  // eq 4; geometry + horizontal is 1, bit for bit
};

// The three weights at distance d; geomInv and btfInv are lodInverse of (minGeom, maxGeom) and (minBtf, maxBtf).
FN LodWeights lodWeights(real d, real minGeom, real geomInv, real minBtf, real btfInv) {
    LodWeights w;
    w.horizontal = lodRamp(d, minGeom, geomInv);
    w.geometry = 1.0f - w.horizontal;
    w.vertical = w.horizontal * (1.0f - lodRamp(d, minBtf, btfInv));
    return w;
}

// Eqs 2-4 as printed: nothing near, everything twice far and NaN between where a pair of distances is equal.
FN LodWeights lodWeightsPublished(real d, real minGeom, real maxGeom, real minBtf, real maxBtf) {
    LodWeights w;
    w.geometry = clamp((d - maxGeom) / (minGeom - maxGeom), real(0.0), real(1.0));
    w.horizontal = clamp((d - minGeom) / (maxGeom - minGeom), real(0.0), real(1.0));
    w.vertical = w.horizontal * clamp((d - maxBtf) / (minBtf - maxBtf), real(0.0), real(1.0));
    return w;
}
