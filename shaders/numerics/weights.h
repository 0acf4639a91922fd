// Light weights of the five images of a slice (Boulanger, Pattanaik, Bouatouch 2006, appendix, eqs 8-13): the areas of
// the spherical triangles that the light cuts from its octant, over pi/2.
// Error (full scale 1): eq 13 is NaN with the light on an axis and 2e-4 near a quadrant plane; three atan 1.6e-7; two
// polynomials of degree 13 / 9 / 7 / 5 / 3: 8e-7 / 3.3e-5 / 2.3e-4 / 1.8e-3 / 1.4e-2. Degree 9 lies below a step of 8
// bits and costs a fifth of the atan form.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

const real kFourOverPi = real(1.27323954473516268615);

// The light folded into the first octant and scaled so that its largest component is 1.
struct LightOctant {
    real a;  // |x|
    real b;  // y, 0 if below the horizon: such a light is projected onto the horizon
    real c;  // |z|
    real n;  // length of (a, b, c), at least 1
};

// l: towards the light, any finite length. The zero vector and the nadir count as (0, 1, 0).
FN LightOctant lightOctant(vec3 l) {
    LightOctant o;
    o.a = abs(l.x);
    o.b = max(l.y, real(0.0));
    o.c = abs(l.z);
    real m = max(max(o.a, o.b), o.c);
    bool none = !(m > kTiny);
    real scale = none ? real(1.0) : m;
    o.a = none ? real(0.0) : o.a / scale;
    o.b = none ? real(1.0) : o.b / scale;
    o.c = none ? real(0.0) : o.c / scale;
    o.n = sqrt(o.a * o.a + o.b * o.b + o.c * o.c);
    return o;
}

// (4/pi) atan(t) for t in [0, 1] by odd minimax polynomials that are 1 at t = 1.
FN real atanPoly13(real t) {
    real s = t * t;
    real p = real(-0.04221992911) + s * real(0.008482985547);
    p = real(-0.168145938) + s * (real(0.1007371726) + s * p);
    return t * (real(1.273234301) + s * (real(-0.4242002162) + s * (real(0.2521116241) + s * p)));
}
FN real atanPoly9(real t) {
    real s = t * t;
    real p = real(0.23491773) + s * (real(-0.11536679) + s * real(0.029434174));
    return t * (real(1.2731975) + s * (real(-0.42218268) + s * p));
}
FN real atanPoly7(real t) {
    real s = t * t;
    real p = real(0.183717366) + s * real(-0.04795299561);
    return t * (real(1.272139378) + s * (real(-0.4079037487) + s * p));
}
FN real atanPoly5(real t) {
    real s = t * t;
    return t * (real(1.266575468) + s * (real(-0.3634261122) + s * real(0.09685064381)));
}
FN real atanPoly3(real t) { return t * (real(1.231837029) + t * t * real(-0.2318370295)); }

// The weights (x, y, z) of the octant's three images from those of x and z; they sum to 1 within 6e-8, none is
// negative.
FN vec3 weightsFrom(real x, real z) {
    real wx = min(x, real(1.0));
    real wz = min(z, 1.0f - wx);
    return vec3(wx, (1.0f - wx) - wz, wz);
}

// Exact: van Oosterom and Strackee's formula for a triangle with two orthonormal corners. Keeps the relative accuracy
// of small weights, which a remainder loses.
FN vec3 weightsThreeAtan(LightOctant o) {
    return vec3(kFourOverPi * atan(o.a / (o.n + o.b + o.c)), kFourOverPi * atan(o.b / (o.n + o.a + o.c)),
                kFourOverPi * atan(o.c / (o.n + o.a + o.b)));
}
FN vec3 weightsTwoAtan(LightOctant o) {
    return weightsFrom(kFourOverPi * atan(o.a / (o.n + o.b + o.c)), kFourOverPi * atan(o.c / (o.n + o.a + o.b)));
}
FN vec3 weightsPoly13(LightOctant o) {
    return weightsFrom(atanPoly13(o.a / (o.n + o.b + o.c)), atanPoly13(o.c / (o.n + o.a + o.b)));
}
FN vec3 weightsPoly9(LightOctant o) {
    return weightsFrom(atanPoly9(o.a / (o.n + o.b + o.c)), atanPoly9(o.c / (o.n + o.a + o.b)));
}
FN vec3 weightsPoly7(LightOctant o) {
    return weightsFrom(atanPoly7(o.a / (o.n + o.b + o.c)), atanPoly7(o.c / (o.n + o.a + o.b)));
}
FN vec3 weightsPoly5(LightOctant o) {
    return weightsFrom(atanPoly5(o.a / (o.n + o.b + o.c)), atanPoly5(o.c / (o.n + o.a + o.b)));
}
FN vec3 weightsPoly3(LightOctant o) {
    return weightsFrom(atanPoly3(o.a / (o.n + o.b + o.c)), atanPoly3(o.c / (o.n + o.a + o.b)));
}

// Two crude forms, to show what accuracy costs: errors 5.9e-2 and 1.7e-1.
FN vec3 weightsLinear(LightOctant o) { return vec3(o.a, o.b, o.c) / (o.a + o.b + o.c); }
FN vec3 weightsSquares(LightOctant o) { return vec3(o.a * o.a, o.b * o.b, o.c * o.c) / (o.n * o.n); }

// One triangle of eq 13, as printed, for the corner p with neighbours q and r; l is a unit vector.
FN real weightEq13(real p, real q, real r) {
    real sq = sqrt(p * p + q * q);
    real sr = sqrt(p * p + r * r);
    return (acos(r / sr) + acos(q / sq) + acos(-q * r / (sr * sq)) - kPi) / (kPi / 2.0f);
}
// Eqs 8-13 as printed: nine inverse cosines.
FN vec3 weightsPublished(vec3 l) {
    vec3 u = l / sqrt(dot(l, l));
    real a = abs(u.x);
    real c = abs(u.z);
    return vec3(weightEq13(a, u.y, c), weightEq13(u.y, a, c), weightEq13(c, a, u.y));
}

// The same with sines as sqrt(1 - cos^2), which eq 11 invites: rounding then lifts cosines above 1.
FN real weightEq11(real q, real r) {
    real sq = sqrt(1.0f - r * r);
    real sr = sqrt(1.0f - q * q);
    return (acos(r / sr) + acos(q / sq) + acos(-q * r / (sr * sq)) - kPi) / (kPi / 2.0f);
}
FN vec3 weightsEq11(vec3 l) {
    vec3 u = l / sqrt(dot(l, l));
    real a = abs(u.x);
    real c = abs(u.z);
    return vec3(weightEq11(u.y, c), weightEq11(a, c), weightEq11(a, u.y));
}

// All five weights. Interpolate these over a triangle, never a signed triple: two vertices lit from opposite sides
// would meet at weights that sum to 0. At a quadrant's boundary either image has weight 0.
struct LightWeights {
    real xPos;
    real yPos;
    real zPos;
    real xNeg;
    real zNeg;
};
FN LightWeights spreadWeights(vec3 l, vec3 w) {
    LightWeights five;
    bool left = l.x < 0.0f;
    bool back = l.z < 0.0f;
    five.xPos = left ? real(0.0) : w.x;
    five.yPos = w.y;
    five.zPos = back ? real(0.0) : w.z;
    five.xNeg = left ? w.x : real(0.0);
    five.zNeg = back ? w.z : real(0.0);
    return five;
}

// The weights to use: exact for a light that is the same for the whole frame, polynomials for one that is near.
FN LightWeights lightWeights(vec3 l) { return spreadWeights(l, weightsThreeAtan(lightOctant(l))); }
FN LightWeights lightWeightsFast(vec3 l) { return spreadWeights(l, weightsPoly9(lightOctant(l))); }

// Diffuse light fades out over the last degrees above the horizon; exactly 0 at and below it. sinElevation: of the
// light; sinFade: of the elevation where the fade starts, above 0.
FN real horizonFade(real sinElevation, real sinFade) {
    return clamp(sinElevation / max(sinFade, kTiny), real(0.0), real(1.0));
}

// A point light at `toLight` (metres): direction and 1 / (1 + beta d^2). At the light itself the direction is up.
struct PointLight {
    vec3 direction;
    real attenuation;  // in ]0, 1] for beta >= 0
};
FN PointLight pointLight(vec3 toLight, real beta) {
    PointLight p;
    p.direction = unitOr(toLight, kTiny, vec3(0.0f, 1.0f, 0.0f));
    p.attenuation = 1.0f / (1.0f + beta * dot(toLight, toLight));
    return p;
}

// A light's colour as it may enter a scene: no negative component, none above the largest half float.
FN vec3 soundLight(vec3 color) { return clamp(color, real(0.0), real(65504.0)); }
