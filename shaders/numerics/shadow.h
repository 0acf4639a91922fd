// Shadows of blades on the ground and on one another (Boulanger, Pattanaik, Bouatouch 2006, section 3.5). y is up.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#include "numerics/hash.h"
#endif

// Blades whose shadows on the ground are narrower than half a pixel: how many of them one stands for, [1,
// kMostShadows]. width: of a blade; pixel: at its root, metres.
const real kMostShadows = real(16.0);
const real kShadowPixels = real(0.5);  // that one then covers
FN real shadowsOfOne(real width, real pixel) {
    return clamp(kShadowPixels * pixel / max(width, real(1e-6)), real(1.0), kMostShadows);
}
// Of its own width, how wide the shadow is then of a blade with this chance, [0, 1); 0: it has none. The mean over all
// chances is 1, and shadows narrow before they are gone, so that none goes at once where the eye moves.
FN real shadowWidening(real many, real chance) {
    real narrowing = min(many - real(1.0), real(0.5)), left = 1.0f - many * chance;
    if (!(many > 1.0f)) return real(1.0);
    return many / (1.0f - real(0.5) * narrowing) * clamp(left / narrowing, real(0.0), real(1.0));
}
// The chance of a blade with these bits of its own (Blade.dither) in this cell: patches that all cells repeat hold few
// blades, and chances of the patch's would be as many everywhere.
FN real shadowChance(uint bits, int cellX, int cellZ) { return hashUnit(cellHash(cellX, cellZ, bits)); }

// Where a ray from o along d leaves the vertical cylinder of radius R around the y axis: o + t d, t >= 0. The paper
// looks its mask up there; ours (maskPointOf) asks for no way out, and this is kept beside it for who follows the
// paper. o outside counts as on the cylinder. Rays along the axis get a large finite t, which lies above every mask:
// unshadowed.
FN real cylinderExit(vec3 o, vec3 d, real radius) {
    real a = d.x * d.x + d.z * d.z;
    real b = o.x * d.x + o.z * d.z;
    real e = max(radius * radius - o.x * o.x - o.z * o.z, real(0.0));
    real s = sqrt(b * b + a * e);
    return b > 0.0f || a < real(1e-20) ? e / max(b + s, real(1e-15)) : (s - b) / a;
}
FN real cylinderExitPublished(vec3 o, vec3 d, real radius) {
    real a = d.x * d.x + d.z * d.z;
    real b = o.x * d.x + o.z * d.z;
    return (-b + sqrt(b * b + a * (radius * radius - o.x * o.x - o.z * o.z))) / a;
}

// The mask's horizontal coordinate in turns of (x, z) around the axis, 0 on the axis itself.
FN real maskTurns(real x, real z) {
    if (!(max(abs(x), abs(z)) > kTiny)) return real(0.0);
    return atan(z, x) / kTau;
}
// How steeply light comes in, as a share in [0, 1]: 0 level or from below, 1/2 from 45 degrees, 1 upright.
FN real maskRise(vec3 towards) {
    real up = max(towards.y, real(0.0));
    return up / max(up + sqrt(towards.x * towards.x + towards.z * towards.z), real(1e-20));
}
// Metres that light of such a share rises over one metre of ground.
FN real maskSlope(real rise) { return rise / max(real(1.0) - rise, real(1e-6)); }

// Where a point of a blade lies in its mask for parallel light: across, in turns, from where the blade faces, within
// half a turn of the light's own but for how far the point lies to a side; the point's height as a share of the mask's,
// in [0, 1]; and the light's maskRise. The mask has a layer for each rise, in which neighbours lie where such light
// brings their shadows, so that no way out of a cylinder is asked for, and all but the light's own azimuth is linear
// in the point: vertices interpolate exactly, and points out of the cylinder are no case of their own.
struct MaskPoint {
    real turn;
    real height;
    real rise;
};
// fromRoot: the point relative to the blade's root; facing: unit, where the blade leans; l: towards the light, unit.
// radius, top: of the cylinder, metres.
FN MaskPoint maskPointOf(vec3 fromRoot, vec2 facing, vec3 l, real radius, real top) {
    vec2 light = vec2(l.x * facing.x + l.z * facing.y, l.z * facing.x - l.x * facing.y);
    vec2 at = vec2(fromRoot.x * facing.x + fromRoot.z * facing.y, fromRoot.z * facing.x - fromRoot.x * facing.y);
    real level = max(sqrt(light.x * light.x + light.y * light.y), real(1e-6));
    real aside = (at.y * light.x - at.x * light.y) / level;
    MaskPoint p;
    p.turn = maskTurns(light.x, light.y) + aside / (kTau * max(radius, real(1e-6)));
    p.height = clamp(fromRoot.y / max(top, real(1e-6)), real(0.0), real(1.0));
    p.rise = maskRise(l);
    return p;
}

// What a mask lets through at a density in [0, 1]; quarters: at densities 1/4, 2/4, 3/4 and 1. Nothing grows at 0: all.
FN real maskVisibility(vec4 quarters, real density) {
    real d = 4.0f * clamp(density, real(0.0), real(1.0));
    return max(1.0f - d, real(0.0)) + quarters.x * max(1.0f - abs(d - 1.0f), real(0.0)) +
           quarters.y * max(1.0f - abs(d - 2.0f), real(0.0)) + quarters.z * max(1.0f - abs(d - 3.0f), real(0.0)) +
           quarters.w * max(d - 3.0f, real(0.0));
}

struct GroundShadow {
    vec2 offset;  // (x, z) from the foot of the point to its shadow
    real alpha;   // 1, falling to 0 where the shadow would be longer than the limit
};

// Shadow of a point `height` above the ground by a light in direction l (unit, towards the light): no longer than
// maxLength, on the side away from the light, and gone with the light on the horizon or below.
FN GroundShadow shadowOfSun(real height, vec3 l, real maxLength) {
    GroundShadow g;
    real across = sqrt(l.x * l.x + l.z * l.z);
    real full = max(height, real(0.0)) * across;
    real capped = maxLength * max(l.y, real(0.0));
    bool cut = full > capped;
    real scale = cut ? maxLength / max(across, kTiny) : max(height, real(0.0)) / max(l.y, kTiny);
    g.offset = vec2(-l.x, -l.z) * scale;
    g.alpha = cut ? capped / max(full, kTiny) : real(1.0);
    if (!(l.y > 0.0f)) g.alpha = real(0.0);
    return g;
}

// Shadow of point p (p.y above the ground) by a point light at `light`; same limits. Nothing from a light at or below
// p.
FN GroundShadow shadowOfLamp(vec3 p, vec3 light, real maxLength) {
    return shadowOfSun(p.y, vec3(light.x - p.x, light.y - p.y, light.z - p.z), maxLength);
}

// The projection as printed: infinite on the horizon, towards the light below it.
FN vec2 shadowPublished(real height, vec3 l) { return vec2(-l.x, -l.z) * (height / l.y); }
