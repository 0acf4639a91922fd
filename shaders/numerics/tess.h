// Levels: of a blade's tessellation (Jahrmann, Wimmer 2013, eqs 4 and 5) and of the terrain's macro-cells (Boulanger,
// Pattanaik, Bouatouch 2006, section 4.1).

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

// Eq 4: s at distance 0, 0 at dmax and beyond, never increasing. s: the smoothness, at least 0; 64 is OpenGL's limit.
// An exact integer does not land a level high, for which a level may be lost within 1e-4 above an integer.
FN int tessLevel(real s, real d, real dmax) {
    if (!(d < dmax)) return 0;
    real level = ceil(s * (dmax - d) / max(dmax, kTiny) - real(1e-4));
    return int(clamp(level, real(0.0), min(s, real(64.0))));
}
FN real tessLevelPublished(real s, real d, real dmax) { return ceil(s * (1.0f - d / dmax)); }

// By the blade's length on screen: at least 1 for every blade with a visible end, s if one end is nearer than the near
// plane, 0 only if both are. root, tip: clip positions (w = distance along the view); size: the image in pixels.
FN int tessLevelOnScreen(vec4 root, vec4 tip, vec2 size, real near, real pixelsPerQuad, real s) {
    real most = clamp(s, real(1.0), real(64.0));
    bool rootIn = root.w >= near;
    bool tipIn = tip.w >= near;
    if (!rootIn && !tipIn) return 0;
    if (!rootIn || !tipIn) return int(most);
    real dx = (tip.x / tip.w - root.x / root.w) * 0.5f * size.x;
    real dy = (tip.y / tip.w - root.y / root.w) * 0.5f * size.y;
    real pixels = sqrt(min(dx * dx + dy * dy, real(1e12)));
    return int(clamp(ceil(pixels / max(pixelsPerQuad, kTiny) - real(1e-4)), real(1.0), most));
}
// Eq 5 as printed: a signed difference of one coordinate.
FN real tessLevelOnScreenPublished(vec4 root, vec4 tip, vec2 size, real pixelsPerQuad, real s) {
    real upper = tip.y / tip.w * 0.5f + 0.5f;
    real lower = root.y / root.w * 0.5f + 0.5f;
    return min((upper - lower) * size.y / pixelsPerQuad, s);
}

// The level that no blade needs more than whose root is at least so far away. quadsAtOneMetre: of the tallest blade in
// the middle of the picture at 1 m; 0: the distance decides. reach: of a blade from its root.
FN int tessMost(real s, real d, real dmax, real quadsAtOneMetre, real reach) {
    if (!(quadsAtOneMetre > 0.0f)) return max(tessLevel(s, d, dmax), 1);
    real nearest = d - reach;
    return nearest > real(0.05) ? int(clamp(ceil(quadsAtOneMetre / nearest), real(1.0), max(s, real(1.0)))) : int(s);
}

// How blades are thinned by their distance: linearly (section 6.3), and so that those that are left, as wide as all
// were, are at least some pixels wide (the stochastic simplification of Cook, Halstead, Planck and Ryu, ACM TOG 26(3),
// 2007).
struct Thinning {
    real missing;  // share of the blades that is gone at each metre, >= 0
    real allTo;    // metres up to which each is as wide as that by itself; huge: pixels thin none
};
// Of the density at a distance d >= 0, what is left.
FN real densityKept(real density, real d, Thinning t) {
    real linear = clamp(1.0f - d * t.missing, real(0.0), real(1.0));
    return density * (d > t.allTo ? min(linear, t.allTo / d) : linear);
}
// How high a blade stands there, as a share of its height, if blades are low from `dmax` on; inv: 1 over the metres in
// which they get so, at least kTiny of them.
FN real heightKept(real d, real dmax, real inv) { return clamp((dmax - d) * inv, real(0.0), real(1.0)); }

// Level of a macro-cell: 0 while the distance to its bounding sphere is below 2 base, one more with each doubling, at
// most `most` (<= 24). 0 for an eye inside the sphere. Exact comparisons: CPU and GPU agree on every cell.
FN int macroLevel(real distance, real radius, real base, int most) {
    real q = distance - radius;
    real reach = 2.0f * base;
    int level = 0;
    for (int i = 0; i < 24; i++) {
        if (i >= most || !(q >= reach)) break;
        reach *= 2.0f;
        level = i + 1;
    }
    return level;
}
FN real macroLevelPublished(real distance, real radius, real base) { return floor(log2((distance - radius) / base)); }
