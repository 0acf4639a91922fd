// A forest's tiles as volumes (forest/texcells.h). Does not: hold the volumes, which are textures.
#pragma once
#include "shared/types.h"
#define FOREST_SLOTS 32
#define LEAST_LIGHT 0.002  // what 8 bits store as 0
#ifdef __cplusplus
namespace sward {
#endif

struct STD140 ForestGlobals {
    float height;     // metres that all slabs reach
    float voxel;      // metres of a texel of the finest image
    float fineSlabs;  // slabs of the level that is drawn, and of the next
    float coarseSlabs;
    float pixel;       // metres that a pixel covers at a distance of 1 m
    float lightSlabs;  // parts of the light's image upwards
    ivec2 firstCell;   // of the lattice: the canopies' first column and row
    float edge;        // metres of the lattice's edges
    uint seed;         // of the lattice's colours
    float shadeFrom;   // metres from the eye over which the shade on the ground sets in
    float shadeTo;
};

// A triangle of the lattice in a view: corners of its ground relative to the eye, in the order of the tile's.
struct TileInView {
    vec4 corner[3];  // x, y, z; w: metres from the ground there up to where slices begin
    vec2 stored;     // its cell among the 2 x 2 that repeat
    vec2 canopy;     // shares of the forest that stand: towards the sun, and all around
    float spacing;   // metres from slice to slice, upwards
    float path;      // what a slice stands for: slabs' heights that lie between two slices
    float coarser;   // share of the next level: 0 to 1
    int up;          // 1 where it points up
    int slices;      // that are drawn
    int under;       // how many of them come from below upwards; the others from above downwards
    ivec2 padding;   // to 16 bytes, as arrays of buffers stride
};

#ifdef __cplusplus
}
#endif
