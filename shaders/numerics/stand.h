// How what stands in the grass leans at its place: what paint, clumps, wind and forces do to it, composed here alone.
// Blades of every technique, slices, the horizontal slice, flowers and the ray-traced truth all come by these lines;
// numerics/population.h then poses a blade by what it gets. Does not: say how strong each is at a place;
// numerics/gust.h, numerics/clump.h and the maps do.

#ifndef __cplusplus
#include "numerics/glsl.h"
#include "numerics/gust.h"
#endif

// What a place has for what stands there. Leans are horizontal metres a metre of height.
struct BladeStand {
    vec2 paint;       // painted direction (x, z), its length the strength in [0, 1]
    real leanAtFull;  // lean at strength 1
    vec2 breeze;      // lean by the wind on many blades at once; slices are such
    vec3 clump;       // three values of clumpValues; 0: no clumps
    real clumpLean;   // lean, share of height and share of lightness that full clump values give
    real clumpHeight;
    real clumpLightness;
    vec2 wind;  // lean by the wind on this blade alone, with its quiver; then there is no breeze
    vec2 push;  // of forceOf
    real press;
    real tall;  // share of its height that the map of heights leaves it
};
// What that makes of it.
struct BladeLean {
    vec2 free;     // lean without forces
    vec2 clump;    // what of that is by clumps
    vec2 lean;     // all of it, as poseBlade takes it
    real scale;    // of its height
    real lighter;  // factor of its colour
};

// A place that has nothing: what stands there is as it is.
FN BladeStand emptyStand() {
    BladeStand s;
    s.paint = vec2(0.0f, 0.0f);
    s.leanAtFull = real(0.0);
    s.breeze = vec2(0.0f, 0.0f);
    s.clump = vec3(0.0f, 0.0f, 0.0f);
    s.clumpLean = real(0.0);
    s.clumpHeight = real(0.0);
    s.clumpLightness = real(0.0);
    s.wind = vec2(0.0f, 0.0f);
    s.push = vec2(0.0f, 0.0f);
    s.press = real(0.0);
    s.tall = real(1.0);
    return s;
}

// facing: unit, to where it lies down under a press, its own mirroring included; of no account where nothing presses.
// Sums are taken in one order, and what a place has not adds nothing, to the last bit.
FN BladeLean leanOf(BladeStand s, vec2 facing) {
    BladeLean l;
    l.clump = vec2(s.clump.x, s.clump.y) * s.clumpLean;
    l.free = s.paint * s.leanAtFull + s.breeze + l.clump + s.wind;
    l.lean = forcedLean(l.free, s.push, s.press, facing);
    l.scale = (1.0f + s.clump.z * s.clumpHeight) * s.tall;
    l.lighter = 1.0f + s.clump.z * s.clumpLightness;
    return l;
}
