// Frames of a blade made of two quadratic splines (Jahrmann, Wimmer 2013, eqs 7 and 8).

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

struct SplineFrame {
    vec3 position;
    vec3 tangent;    // unit, along the blade
    vec3 bitangent;  // unit, from left to right
    vec3 normal;     // unit, perpendicular to both: tangent x bitangent
};

// A point of the spline with controls 0, h and t, at v in [0, 1].
FN vec3 splinePoint(vec3 h, vec3 t, real v) { return h * (2.0f * v * (1.0f - v)) + t * (v * v); }

// Unit tangent there. A derivative shorter than tiny gives the direction of the tip, and a tip on the root gives up.
FN vec3 splineTangent(vec3 h, vec3 t, real v, real tiny) {
    return unitOr(h * (1.0f - v) + (t - h) * v, tiny, unitOr(t, tiny, vec3(0.0f, 1.0f, 0.0f)));
}

// The frame at u across (0 left, 1 right) and v along. l and r: left and right root, control and tip; `side`: unit, the
// blade's rest direction from left to right. All is computed relative to the left root: in world coordinates 90 km out
// the normal would be off by 2e-2. Vectors shorter than 1e-6 of the blade's size fall back, tangents to tip minus root
// and then up, the bitangent to side; a tangent along the bitangent gives the normal up x side.
FN SplineFrame splineFrame(vec3 lRoot, vec3 lControl, vec3 lTip, vec3 rRoot, vec3 rControl, vec3 rTip, vec3 side,
                           real u, real v) {
    vec3 up = vec3(0.0f, 1.0f, 0.0f);
    vec3 base = rRoot - lRoot;
    vec3 lh = lControl - lRoot;
    vec3 lt = lTip - lRoot;
    vec3 rh = rControl - rRoot;
    vec3 rt = rTip - rRoot;
    real size = max(max(max(maxAbs3(lh), maxAbs3(lt)), max(maxAbs3(rh), maxAbs3(rt))), maxAbs3(base));
    real tiny = max(size * real(1e-6), kTiny);
    vec3 left = splinePoint(lh, lt, v);
    vec3 across = base + splinePoint(rh, rt, v) - left;
    vec3 tangents = splineTangent(lh, lt, v, tiny) * (1.0f - u) + splineTangent(rh, rt, v, tiny) * u;
    SplineFrame f;
    f.position = lRoot + (left + across * u);
    f.tangent = unitOr(tangents, real(1e-6), up);
    f.bitangent = unitOr(across, tiny, side);
    f.normal = unitOr(cross(f.tangent, f.bitangent), real(1e-6), unitOr(cross(up, side), real(1e-6), up));
    return f;
}

// Eqs 7 and 8 as printed (with the second divisor's stray factor left out): NaN wherever a vector vanishes.
FN vec3 splineDirectionPublished(vec3 p, vec3 h, vec3 t, real v) {
    vec3 d = (h + (t - h) * v) - (p + (h - p) * v);
    return d / sqrt(dot(d, d));
}
FN vec3 splinePointPublished(vec3 p, vec3 h, vec3 t, real v) {
    vec3 a = p + (h - p) * v;
    vec3 b = h + (t - h) * v;
    return a + (b - a) * v;
}
FN SplineFrame splineFramePublished(vec3 lRoot, vec3 lControl, vec3 lTip, vec3 rRoot, vec3 rControl, vec3 rTip, real u,
                                    real v) {
    vec3 left = splinePointPublished(lRoot, lControl, lTip, v);
    vec3 right = splinePointPublished(rRoot, rControl, rTip, v);
    vec3 t = splineDirectionPublished(lRoot, lControl, lTip, v) * (1.0f - u) +
             splineDirectionPublished(rRoot, rControl, rTip, v) * u;
    SplineFrame f;
    f.position = left * (1.0f - u) + right * u;
    f.tangent = t / sqrt(dot(t, t));
    f.bitangent = (right - left) / sqrt(dot(right - left, right - left));
    vec3 n = cross(f.tangent, f.bitangent);
    f.normal = n / sqrt(dot(n, n));
    return f;
}
