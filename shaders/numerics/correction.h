// Opacity of a layer seen along a longer or shorter path: 1 - (1 - A)^k (Decaudin, Neyret 2004, section 5), A the
// opacity of the layer's own thickness, k = dl / delta the ratio of path to thickness. Error for A in [1/255, 1], k in
// [1, 16]: Taylor 0.35, hyperbola 0.19, pow 3e-7 (but 0.4 relative for thin layers), series 3e-7 and 2e-7 relative down
// to A = 1e-7.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

// The paper's series, cut after its first term: opaque voxels stay opaque only for k >= 1.
FN real correctionTaylor(real a, real k) { return min(k * a, real(1.0)); }
// The rational form with the right limits.
FN real correctionHyperbola(real a, real k) { return k * a / (1.0f + (k - 1.0f) * a); }
// Enough for 8-bit opacities.
FN real correctionPow(real a, real k) {
    real base = clamp(1.0f - a, real(0.0), real(1.0));
    if (!(k > 0.0f)) return real(0.0);
    return base > 0.0f ? 1.0f - pow(base, min(k, real(1e6))) : real(1.0);
}

// log(1 - a) for a in [0, 1): by its own series where a is small, since 1 - a has then lost a.
FN real logOneMinus(real a) {
    if (!(a < 0.25f)) return log(max(1.0f - a, kTiny));
    real s = a / (2.0f - a);
    real q = s * s;
    return -2.0f * s * (1.0f + q * (real(1.0 / 3.0) + q * (real(0.2) + q * real(1.0 / 7.0))));
}

// 1 - exp(y) for y <= 0, with the relative accuracy of small y. No compensated arithmetic: it would be optimised away.
FN real oneMinusExp(real y) {
    if (!(y > -0.25f)) return 1.0f - exp(y);
    return -y * (1.0f + y * (0.5f + y * (real(1.0 / 6.0) + y * (real(1.0 / 24.0) + y * real(1.0 / 120.0)))));
}

// The correction to use. a is clamped to [0, 1] and k to [0, 1e6]; 0 at a = 0 for every k; 1 at a = 1 for every k > 0.
FN real opacityCorrected(real a, real k) {
    real ratio = clamp(k, real(0.0), real(1e6));
    if (!(a > 0.0f) || !(ratio > 0.0f)) return real(0.0);
    if (!(a < 1.0f)) return real(1.0);
    return oneMinusExp(ratio * logOneMinus(a));
}

// Premultiplied colour of the corrected layer: scaled by A'/A (k where A is 0), so that colour / alpha keeps its hue,
// where clamping channels one by one would shift it.
FN vec4 colorCorrected(vec4 c, real k) {
    real alpha = clamp(c.w, real(0.0), real(1.0));
    real corrected = opacityCorrected(alpha, k);
    real scale = alpha > kTiny ? corrected / alpha : clamp(k, real(0.0), real(1e6));
    return vec4(min(c.x * scale, corrected), min(c.y * scale, corrected), min(c.z * scale, corrected), corrected);
}
FN vec4 colorCorrectedPublished(vec4 c, real k) {
    return vec4(min(c.x * k, real(1.0)), min(c.y * k, real(1.0)), min(c.z * k, real(1.0)), min(c.w * k, real(1.0)));
}

// k of a slice over ground of unit normal n seen along v (unit, z up): evaluated per fragment, from interpolated n and
// v.
FN real slantFactor(vec3 n, vec3 v) { return abs(n.z) / max(abs(dot(n, v)), real(1e-6)); }

// Front-to-back compositing of premultiplied layers (Habel, Wimmer, Jeschke 2007, eq 3) that carries the transmittance,
// so that many thin layers do not lose what is left.
struct Layers {
    vec3 color;
    real transmittance;  // 1 before the first layer; never increases, never negative
};
FN Layers layersUnder(Layers front, vec3 color, real alpha) {
    real a = clamp(alpha, real(0.0), real(1.0));
    Layers l;
    l.color = front.color + clamp(color, real(0.0), a) * front.transmittance;
    l.transmittance = front.transmittance * (1.0f - a);
    return l;
}

// Level of detail of a pyramid of levels 0..last from texels per pixel; 0 and infinite sizes stay inside the pyramid.
FN real pyramidLevel(real texelsPerPixel, int last) {
    return clamp(log2(clamp(texelsPerPixel, real(1.0), real(1e9))), real(0.0), real(last));
}
