// A forest's tiles as volumes (forest/texcells.h). Does not: hold the volumes, which are textures.
#pragma once
#include "shared/types.h"
#define FOREST_SLOTS 32
#define FOREST_MOST_SLICES 512  // of a tile
#define FOREST_CHUNK 64         // slices of an instance
#define LEAST_LIGHT 0.002       // what 8 bits store as 0
// Slopes for which the sun's light is stored: how steeply it comes down against the ground there, as a factor of what
// it does on level ground (forest/volume.h, kRises), which is the third.
#define FOREST_RISES 4
#define FOREST_LEVEL 2
#ifdef __cplusplus
namespace sward {
#endif

struct STD140 ForestGlobals {
    float height;         // metres that all slabs reach
    float voxel;          // metres of a texel of the finest image
    float slabs;          // of the finest level; the next has half as many, and its images follow
    float sway;           // lean (m per m) of a full gust of wind
    float pixel;          // metres that a pixel covers at a distance of 1 m
    float edge;           // metres of the lattice's edges
    float cells;          // of the lattice along each side of what repeats
    float floor;          // share of the light from above that a full forest leaves of it on the ground
    float verticalScale;  // how many times as high as baked it stands; `height` has it
};

// A tree that is drawn as a volume, in a view: one for each slot of each tile.
struct TreeInView {
    float foot;     // its height relative to the eye
    float seen;     // factor of the path through its leaves, as they are seen from the eye
    float sun;      // share of the sun's light that they send to the eye
    float passed;   // share that shines through them to the eye, of what they would send back of it
    float sky;      // share of the light from all around that they take from above
    float through;  // of all light on their other sides, what shines through: a share of what is sent back
    float sunward;  // factor of the odds that what is seen of its leaves is in the sun
    float skyward;  // likewise, in the sky's light
    float facing;   // of the sky's light that reaches its leaves, how much more they take since those face it
    float red;      // share of the light on them that they scatter, to both sides, by colour
    float green;
    float blue;
    float level;    // factor of a lamp's light that comes level, by how leaves face once they are stretched
    float upright;  // likewise, from straight above or below
};

// A triangle of the lattice in a view: corners of its ground relative to the eye, in the order of the tile's.
struct TileInView {
    vec4 corner[3];  // x, y, z; w: metres from the ground there up to where slices begin
    vec2 stored;     // its cell among those that repeat
    vec2 canopy;     // shares of the forest that stand: towards the sun, and all around
    float spacing;   // metres from slice to slice, upwards
    float path;      // what a slice stands for: slabs' heights that lie between two slices
    float coarser;   // share of the next level: 0 to 1
    int up;          // 1 where it points up
    int slices;      // it has
    int below;       // how many of them lie below the eye
    int level;       // the finer of the two levels
    int rise;        // which of FOREST_RISES the sun's light comes by
};

#ifdef __cplusplus
}
#endif
