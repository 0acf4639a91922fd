// What a leaf sends back of light that falls on it, beside the two-sided Lambert reflection of the papers: light that
// shines through, and a waxy highlight. Factors are of (irradiance on a surface that faces the light) / pi, as lights
// are given.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

// Reflectance of normal incidence of leaf wax, refractive index 1.5.
const real kLeafFresnel = real(0.04);

// Colour of light that has passed a leaf which reflects `color`: about as much, a little yellower, because chlorophyll
// takes blue and red twice on the longer way (leaves measured by Woolley, "Reflectance and Transmittance of Light by
// Leaves", 1971).
FN vec3 leafThrough(vec3 color) { return vec3(color.x * real(1.1), color.y * real(1.05), color.z * real(0.55)); }

// What a leaf that would send `lit` of a light that falls straight on it sends of light from a direction. facing:
// cosine between that and the normal of the side that is seen, below 0 where the light falls on the other.
FN vec3 leafSent(vec3 lit, real facing, real translucency) {
    return lit * max(facing, real(0.0)) + leafThrough(lit) * (translucency * max(-facing, real(0.0)));
}

// No leaf sends back and on more than this of what falls on it: bright paint on blades that shine through would make
// light, ever more from blade to blade.
const real kLeafSendsAtMost = real(0.95);
// What of light shines through a leaf of reflectance c: translucency's share of leafThrough, within that bound.
FN vec3 leafPasses(vec3 c, real translucency) {
    vec3 t = leafThrough(c) * translucency;
    return vec3(min(t.x, max(kLeafSendsAtMost - c.x, real(0.0))), min(t.y, max(kLeafSendsAtMost - c.y, real(0.0))),
                min(t.z, max(kLeafSendsAtMost - c.z, real(0.0))));
}

// What leaves of reflectance c send once over all that they send: light from blade to blade is a geometric series,
// whose terms fall by what a leaf sends on (back and through) and by the share `again` of that which meets another (the
// recollision probability of Smolander and Stenberg 2005). translucency: as above; again: in [0, 0.95].
FN vec3 leafOnce(vec3 c, real translucency, real again) {
    return vec3(real(1.0), real(1.0), real(1.0)) - again * (c + leafPasses(c, translucency));
}
// By how much brighter grass is that is painted, of reflectance `painted` where its own is `own`, than by that alone:
// at most 20.
FN vec3 paintScatters(vec3 own, vec3 painted, real translucency, real again) {
    return leafOnce(own, translucency, again) / leafOnce(painted, translucency, again);
}

// Fresnel's reflectance by Schlick 1994; cosine: between light and half vector, in [0, 1].
FN real leafFresnel(real cosine) {
    real m = 1.0f - clamp(cosine, real(0.0), real(1.0));
    real m2 = m * m;
    return kLeafFresnel + (1.0f - kLeafFresnel) * (m2 * m2 * m);
}

// Highlight of a leaf that faces n, seen along v (unit, towards the eye) in light from l (unit): the GGX lobe of
// Walter, Marschner, Li and Torrance 2007 (equation 33) with alpha = roughness^2 and Smith's shadowing as approximated
// by Hammon 2017, times n.l and pi. 0 where light or eye lie behind the leaf. roughness below 0.05 counts as 0.05; at
// most 3.2e5.
FN real waxyLobe(vec3 n, vec3 l, vec3 v, real roughness) {
    real nl = dot(n, l);
    real nv = dot(n, v);
    if (!(nl > 0.0f) || !(nv > 0.0f)) return real(0.0);
    vec3 h = unitOr(l + v, real(1e-6), n);
    real r = max(roughness, real(0.05));
    real a = r * r;
    real nh = clamp(dot(n, h), real(0.0), real(1.0));
    real spread = nh * nh * (a * a - 1.0f) + 1.0f;
    real peak = a / max(spread, a * a);
    real visible = real(0.5) / max(mix(2.0f * nl * nv, nl + nv, a), real(1e-4));
    return peak * peak * leafFresnel(dot(l, h)) * visible * nl;
}

// Its mean over leaves that face all ways, weighted by how much of each is seen: such leaves are mirrors of every
// direction, so that only Fresnel's part is left. lv: cosine between light and eye. A grass field far away sends this.
FN real waxyMean(real lv) { return real(0.25) * leafFresnel(sqrt(max(real(0.5) + real(0.5) * lv, real(0.0)))); }

// All that a leaf of reflectance c sends to the eye of light (irradiance on what faces it, divided by pi, 1) from l: it
// faces n, the side towards the eye, unit; v: towards the eye. looks: translucency, gloss, roughness; 0 costs nothing.
FN vec3 leafSends(vec3 c, vec3 looks, vec3 n, vec3 v, vec3 l) {
    real facing = dot(n, l);
    vec3 sent = c * max(facing, real(0.0));
    if (looks.x > 0.0f) sent += leafPasses(c, looks.x) * max(-facing, real(0.0));
    if (looks.y > 0.0f) {
        real wax = looks.y * waxyLobe(n, l, v, looks.z);
        sent += vec3(wax, wax, wax);
    }
    return sent;
}
