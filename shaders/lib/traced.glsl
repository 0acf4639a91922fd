// By how much blades are brighter than their local light says, since what is seen of them is lit, and what light comes
// to them from blade to blade, into the shade, too (grass/traced.h). No fragment shaders. Needs: const bool
// GRASS_TRACED.
#include "lib/frame.glsl"
#include "numerics/light.h"
#include "lib/species.glsl"
#include "numerics/traced.h"

// Factor of a direct light at a density. Both ways over level ground, that to the eye unit.
vec3 tracedDirect(vec3 toEye, vec3 way, float density) {
    if (!GRASS_TRACED) return vec3(1.0);
    vec3 towards = normalize(way);
    TracedTerms t = tracedTerms(toEye, towards);
    vec3 sum = vec3(0.0);
    float at = tracedLightAt(towards.y);
    int low = min(int(at), TRACED_LIGHTS - 2);
    for (int k = 0; k < 2; ++k) {
        int from = TRACED_TERMS * (low + k);
        vec3 here = t.near2 * species.traced[from + 6].rgb + t.glow * species.traced[from + 7].rgb;
        for (int i = 0; i < 3; ++i)
            here += species.traced[from + i].rgb * t.rise[i] + species.traced[from + 3 + i].rgb * t.across[i];
        sum += here * (k == 0 ? float(low + 1) - at : at - float(low));
    }
    return mix(vec3(1.0), max(sum, vec3(0.0)), tracedShare(density, species.area.x));
}
vec3 fillAt(vec3 heights, int from) {
    return species.tracedFill[from].rgb * heights.x + species.tracedFill[from + 1].rgb * heights.y +
           species.tracedFill[from + 2].rgb * heights.z;
}
// What comes from blade to blade of a light that lights what faces it by 1: on a blade of any direction, so high, in
// full grass. way: over level ground; as long as it is there: so much more of the light comes in. share: of the mask's
// height.
vec3 directFill(vec3 way, float share) {
    if (!GRASS_TRACED) return vec3(0.0);
    vec3 heights = tracedHeights(share);
    float length_ = max(length(way), 1e-6), at = tracedLightAt(way.y / length_);
    int low = min(int(at), TRACED_LIGHTS - 2);
    return length_ *
           mix(fillAt(heights, TRACED_HEIGHTS * low), fillAt(heights, TRACED_HEIGHTS * (low + 1)), at - float(low));
}
// Light from above and below on a side of a blade that faces n, divided by pi. At any density: local light takes the
// share of the sky for that of full grass everywhere.
vec3 tracedAmbient(vec3 n, vec3 toEye) {
    if (!GRASS_TRACED) return halvesLight(frame.groundLight, frame.skyLight, n.y);
    vec3 rise = tracedRise(toEye.y), sky = vec3(0.0), ground = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        sky += species.tracedSky[i].rgb * rise[i];
        ground += species.tracedGround[i].rgb * rise[i];
    }
    return halvesLight(frame.groundLight * max(ground, vec3(0.0)), frame.skyLight * max(sky, vec3(0.0)), n.y);
}
