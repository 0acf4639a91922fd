// A ray against a blade: the surface that a level line of width w, perpendicular to where the blade faces, sweeps along
// the blade's curve (numerics/blade.h). Along that line nothing bends, so that the ray meets the surface where its
// shadow on the plane of up and `facing` meets a quadratic Bezier: a quadratic equation in v, exact for any curve, in
// that plane or, where a place leans the blade aside, out of it.
// On the GPU only the formula suite runs this (shaders/formulas).

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

struct RibbonHit {
    real t;       // along the ray, in lengths of its direction
    real v;       // along the blade, 0 root, 1 tip
    real across;  // -1/2 to 1/2 of the width, along the blade frame's side
};

// The smaller and the larger root of a v^2 + b v + c = 0 without cancellation (the larger in size is found first, the
// other by their product); 2 and 2, outside every blade, where there is none.
FN vec2 ribbonRoots(real a, real b, real c) {
    real d = b * b - 4.0f * a * c;
    if (d < 0.0f) return vec2(real(2.0), real(2.0));
    real q = real(-0.5) * (b + (b < 0.0f ? -sqrt(d) : sqrt(d)));
    real far = abs(a) > abs(q) * real(1e-12) ? q / a : real(2.0);
    real near = abs(q) > real(0.0) ? c / q : far;
    return vec2(min(near, far), max(near, far));
}

// Where the ray o + t d (o relative to the blade's root) is at v of the blade. t is meaningless where d runs along the
// side.
FN RibbonHit ribbonAt(vec3 o, vec3 d, vec3 control, vec3 tip, vec2 facing, real width, real v) {
    vec3 p = control * (2.0f * v * (1.0f - v)) + tip * (v * v);
    vec2 flatD = vec2(d.x * facing.x + d.z * facing.y, d.y);
    vec3 way = p - o;
    RibbonHit h;
    h.v = v;
    h.t = (flatD.x * (way.x * facing.x + way.z * facing.y) + flatD.y * way.y) / max(dot(flatD, flatD), kTiny);
    h.across = ((o.z + d.z * h.t - p.z) * facing.x - (o.x + d.x * h.t - p.x) * facing.y) / max(width, kTiny);
    return h;
}

// The values of v at which the ray's shadow meets the blade's curve; outside [0, 1]: no meeting. facing: unit.
FN vec2 ribbonMeetings(vec3 o, vec3 d, vec3 control, vec3 tip, vec2 facing) {
    real dx = d.x * facing.x + d.z * facing.y;
    real ox = o.x * facing.x + o.z * facing.y;
    vec2 c = vec2(control.x * facing.x + control.z * facing.y, control.y) * real(2.0);
    vec2 q = vec2(tip.x * facing.x + tip.z * facing.y, tip.y) - c;
    return ribbonRoots(dx * q.y - d.y * q.x, dx * c.y - d.y * c.x, d.y * ox - dx * o.y);
}
