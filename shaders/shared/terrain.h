// The ground's pieces (terrain/lod.h). Does not: hold heights, which are a texture.
#pragma once
#include "shared/bindings.h"
#include "shared/types.h"
#define NODES_PER_DRAW 256
#ifdef __cplusplus
namespace sward {
#endif

// A piece of ground to draw: 16 x 16 quads.
struct STD140 TerrainNode {
    vec2 corner;      // x, z relative to the eye
    vec2 place;       // of that corner, relative to the terrain's
    float spacing;    // of its vertices (m)
    float morphFrom;  // distance where morphing begins
    float morphInv;   // 1 / (end - begin)
};

#ifdef __cplusplus
}
#endif
