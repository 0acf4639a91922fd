// Constants and vector guards that the other formulas share.

#ifndef __cplusplus
#include "numerics/glsl.h"
#endif

const real kPi = real(3.14159265358979323846);
const real kTau = real(6.28318530717958647693);
const real kTiny = real(1e-30);  // a divisor that is never 0, far above the subnormals that GPUs flush

// The largest absolute component of v.
FN real maxAbs3(vec3 v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

// v / |v|; `fallback` if no component of v exceeds `tiny`. Right for any finite size, because v is divided by its
// largest component before it is squared: (3e-19, 4e-19, 1e-19) is a direction like any other.
FN vec3 unitOr(vec3 v, real tiny, vec3 fallback) {
    real m = maxAbs3(v);
    if (!(m > tiny)) return fallback;
    vec3 s = v / m;
    return s / sqrt(dot(s, s));
}
