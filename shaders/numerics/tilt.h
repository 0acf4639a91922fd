// Slices of a forest prism tilted towards the eye (Decaudin, Neyret 2004, section 6). z is up here, as in the paper; V
// is the direction from the eye to the scene, P1..P3 the ground triangle, h the height of the prism, kM the largest
// slant. On the GPU only the formula suite runs this (shaders/formulas); forest/texcells.cpp tilts slices by it.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

struct Tilt {
    vec3 offset;  // (dh'/dh) (k_i - k_max) of the three corners, in [-kM, 0]
    real rise;    // dh', in [0, kM]
    real count;   // slices needed, before rounding; 0 where the triangle has no area on the ground
};

// Half the normal times the area: zero for triangles without area, whatever their position.
FN vec3 triangleNormal(vec3 p1, vec3 p2, vec3 p3) { return cross(p2 - p1, p3 - p1); }

// Whether forest may grow here: false for triangles without area and for cliffs (unit normal's z below 0.05). Edges of
// 1e-20 underflow in the cross product, so they are scaled first.
FN bool groundUsable(vec3 p1, vec3 p2, vec3 p3) {
    real size = max(maxAbs3(p2 - p1), maxAbs3(p3 - p1));
    if (!(size > real(1e-6))) return false;
    vec3 n = cross((p2 - p1) / size, (p3 - p1) / size);
    real area = sqrt(dot(n, n));
    return area > real(1e-6) && abs(n.z) >= real(0.05) * area;
}

// GP_i . V of the three corners, from differences so that a triangle at 90 km is as good as one at the origin.
FN vec3 tiltSlopes(vec3 p1, vec3 p2, vec3 p3, vec3 v) {
    vec3 a = p1 - p2;
    vec3 b = p1 - p3;
    vec3 c = p2 - p3;
    return vec3(dot(a + b, v), dot(c - a, v), dot(-b - c, v)) / real(3.0);
}

// Slices along the true slice normal: spacing equals the voxel size at every elevation, where the paper's |z.V| thins
// out below the elevation at which the slant limit starts. Equal to the paper's count above it.
FN real tiltCount(vec3 n, vec3 v, real s, real thickness, real voxels) {
    if (!(abs(n.z) > kTiny)) return real(0.0);
    real down = v.z < 0.0f ? real(1.0) : real(-1.0);
    real keep = 1.0f - abs(v.z) * s;
    vec2 g = vec2(-n.x, -n.y) * (keep / n.z) + vec2(v.x, v.y) * (down * s);
    return 1.0f + voxels * thickness / sqrt(1.0f + dot(g, g));
}

// Offsets, rise and count. voxels: slices per metre, L / 2^l. Finite for every direction, straight down and horizontal
// included. Crossing the horizontal plane the offsets jump by 2 kM h: a property of the method.
FN Tilt tiltOf(vec3 p1, vec3 p2, vec3 p3, vec3 view, real kM, real h, real voxels) {
    vec3 v = unitOr(view, kTiny, vec3(0.0f, 0.0f, -1.0f));
    real towards = v.z < 0.0f ? real(1.0) : real(-1.0);
    vec3 q = tiltSlopes(p1, p2, p3, v) * towards;
    real low = min(q.x, min(q.y, q.z));
    real high = max(q.x, max(q.y, q.z));
    real s = 1.0f / max(max(abs(v.z), (high - low) / kM), real(1e-20));
    Tilt t;
    t.offset = (q - vec3(high, high, high)) * s;
    t.rise = (high - low) * s;
    t.count = tiltCount(triangleNormal(p1, p2, p3), v, s, h + t.rise, voxels);
    return t;
}

// The number of slices to draw, in [2, most].
FN int sliceCount(real count, int most) { return int(clamp(ceil(count - real(1.0 / 1024.0)), real(2.0), real(most))); }

// The paper's formulas as printed: 0/0 straight down, infinity times 0 in horizontal views, a signed count.
FN Tilt tiltPublished(vec3 p1, vec3 p2, vec3 p3, vec3 view, real kM, real h, real voxels) {
    vec3 v = view / sqrt(dot(view, view));
    vec3 g = (p1 + p2 + p3) / real(3.0);
    vec3 k = vec3(-dot(p1 - g, v) / v.z, -dot(p2 - g, v) / v.z, -dot(p3 - g, v) / v.z);
    real low = min(k.x, min(k.y, k.z));
    real high = max(k.x, max(k.y, k.z));
    Tilt t;
    t.rise = min(high - low, kM);
    t.offset = (k - vec3(high, high, high)) * (t.rise / (high - low));
    t.count = 1.0f + voxels * (h + t.rise) * v.z;
    return t;
}
