// Rays through the slices of a grass shell (Habel, Wimmer, Jeschke 2007, eq 2): in tangent space (u, v, w) slices stand
// at u = k/nu and v = k/nv, the shell is w in [-h, 0], w is up. Integers step from slice to slice, so that nothing
// drifts, and a slice through the entry is seen from both sides.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

const int kRayU = 0;
const int kRayV = 1;
const int kRayGround = 2;
const int kRayNone = -1;
const real kRayNever = real(1e20);  // a parameter beyond every hit

struct SliceRay {
    vec3 entry;
    vec3 direction;
    vec3 inverse;  // 1 / direction, w: of how fast it sinks or rises; finite
    int nextU;     // the next slice of each family
    int nextV;
    int stepU;  // +1 or -1
    int stepV;
    int nu;
    int nv;
    real end;     // where the ray leaves the shell
    bool ground;  // whether it leaves through the ground
};

struct SliceHit {
    int family;  // kRayU, kRayV, kRayGround (the last hit) or kRayNone
    int k;       // slice number; 0 for the ground
    real t;
    vec3 position;
};

// 1 / x for any x; zero and subnormal x, whose reciprocal overflows, give +-1e30, so that their family never comes
// first.
FN real rayInverse(real x) { return 1.0f / (x < 0.0f ? min(x, -kTiny) : max(x, kTiny)); }

// The first slice at or after coordinate e: closed at the entry for either sign of the direction.
FN int firstSlice(real e, real d, int n) {
    real x = e * real(n);
    if (d > 0.0f) return int(ceil(x));
    return d < 0.0f ? int(floor(x)) : int(floor(x)) + 1;
}

// A ray that is at `entry` inside the shell (w in [-h, 0]), direction any length; nu, nv slices per unit, 1 or more.
FN SliceRay sliceRay(vec3 entry, vec3 direction, int nu, int nv, real h) {
    SliceRay r;
    r.entry = entry;
    r.direction = direction;
    r.inverse = vec3(rayInverse(direction.x), rayInverse(direction.y), rayInverse(direction.z));
    r.nu = nu;
    r.nv = nv;
    r.stepU = direction.x < 0.0f ? -1 : 1;
    r.stepV = direction.y < 0.0f ? -1 : 1;
    r.nextU = firstSlice(entry.x, direction.x, nu);
    r.nextV = firstSlice(entry.y, direction.y, nv);
    r.ground = !(direction.z > 0.0f);
    r.end = r.ground ? (h + entry.z) / max(-direction.z, kTiny) : -entry.z * r.inverse.z;
    return r;
}

// How far a ray goes through a shell over ground that bends away under it, or up before it: its height is z + dz t +
// bend t^2 / 2, in [-h, 0] while it is inside. Every root is a quotient by a sum, so that no curvature, however small,
// cancels (H-5); a ray that never leaves ends at kRayNever.
struct ShellEnd {
    real t;
    bool ground;
};
FN ShellEnd shellEnd(real z, real dz, real bend, real h) {
    real down = max(z + h, real(0.0));
    real up = max(-z, real(0.0));
    real low = dz * dz - 2.0f * bend * down;
    real high = dz * dz + 2.0f * bend * up;
    real toGround = low < 0.0f ? real(0.0) : sqrt(low) - dz;
    real tGround = toGround > kTiny ? 2.0f * down / toGround : kRayNever;
    real root = high < 0.0f ? real(0.0) : sqrt(high);
    real tTop = kRayNever;
    if (dz > kTiny && high >= 0.0f) tTop = 2.0f * up / (dz + root);
    if (!(dz > kTiny) && bend > kTiny) tTop = (root - dz) / bend;
    ShellEnd e;
    e.ground = tGround <= tTop;
    e.t = min(min(tGround, tTop), kRayNever);
    return e;
}

// The ray's next hit: ties go to u, then v, then the ground.
FN SliceHit sliceHit(SliceRay r) {
    SliceHit hit;
    real u = real(r.nextU) / real(r.nu);
    real v = real(r.nextV) / real(r.nv);
    real tu = max((u - r.entry.x) * r.inverse.x, real(0.0));
    real tv = max((v - r.entry.y) * r.inverse.y, real(0.0));
    bool isU = tu <= tv;
    real t = isU ? tu : tv;
    bool inside = r.ground ? t <= r.end : t < r.end;
    hit.t = inside ? t : r.end;
    hit.position = r.entry + r.direction * hit.t;
    hit.k = isU ? r.nextU : r.nextV;
    hit.family = isU ? kRayU : kRayV;
    if (inside && isU) hit.position.x = u;
    if (inside && !isU) hit.position.y = v;
    if (!inside) hit.k = 0;
    if (!inside) hit.family = r.ground ? kRayGround : kRayNone;
    if (!(hit.t < kRayNever)) hit.family = kRayNone;
    return hit;
}

// The ray after that hit.
FN SliceRay sliceAfter(SliceRay r, SliceHit hit) {
    SliceRay next = r;
    if (hit.family == kRayU) next.nextU += r.stepU;
    if (hit.family == kRayV) next.nextV += r.stepV;
    return next;
}

// Parameter of the first hit by eq 2 as printed, with floor() and the sign of the direction choosing the plane:
// infinite or NaN wherever the ray is parallel to a family, one slice late where the entry lies on it.
FN real firstHitPublished(vec3 e, vec3 d, int nu, int nv, real h) {
    real pu = (floor(e.x * real(nu)) + (d.x > 0.0f ? real(1.0) : real(0.0))) / real(nu);
    real pv = (floor(e.y * real(nv)) + (d.y > 0.0f ? real(1.0) : real(0.0))) / real(nv);
    real tu = (pu - e.x) / d.x;
    real tv = (pv - e.y) / d.y;
    real t = tu < tv ? tu : tv;
    return e.z + d.z * t < -h ? (-h - e.z) / d.z : t;
}

// Depth (reversed: 1 near, 0 far) of a hit inside a carrier's shell. clip: the hit's clip position; carrier: the
// carrier fragment's depth. Hits nearer than the near plane take the carrier's depth; none is nearer than the carrier.
FN real hitDepth(vec4 clip, real carrier, real near) {
    if (!(clip.w >= max(near, kTiny))) return carrier;
    return min(clamp(clip.z / clip.w, real(0.0), real(1.0)), carrier);
}

// Orthonormal tangents of any unit normal, without a singular direction: signs in place of branches, after Duff et al.,
// "Building an Orthonormal Basis, Revisited", 2017.
struct TangentFrame {
    vec3 tangent;
    vec3 bitangent;
};
FN TangentFrame tangentFrame(vec3 n) {
    real s = n.z < 0.0f ? real(-1.0) : real(1.0);
    real a = -1.0f / (s + n.z);
    real b = n.x * n.y * a;
    TangentFrame f;
    f.tangent = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
    f.bitangent = vec3(b, s + n.y * n.y * a, -n.y);
    return f;
}
// The form with 1 / (1 + n.z): not orthonormal near n.z = -1 and infinite there.
FN TangentFrame tangentFramePublished(vec3 n) {
    real a = 1.0f / (1.0f + n.z);
    real b = -n.x * n.y * a;
    TangentFrame f;
    f.tangent = vec3(1.0f - n.x * n.x * a, b, -n.x);
    f.bitangent = vec3(b, 1.0f - n.y * n.y * a, -n.y);
    return f;
}
