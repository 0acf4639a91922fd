// The ground's pieces (terrain/lod.h), and the size of maps of hills before lamps (terrain/lamp_hills.h). Does not:
// hold heights, which are a texture.
#pragma once
#include "shared/types.h"
#define NODES_PER_DRAW 256
#define LAMP_HILLS_LINES 512  // side by side or around the lamp; whole groups of 32
#define LAMP_HILLS_STEPS 512  // along each
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
