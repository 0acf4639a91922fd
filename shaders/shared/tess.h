// How a species' blades are tessellated (grass/tessellated.h). Does not: hold what all techniques read of blades
// (grass.h).
#pragma once
#include "shared/types.h"
#ifdef __cplusplus
namespace sward {
#endif

struct STD140 TessGlobals {
    float maxDistance;     // from which no blade is drawn (m)
    float missing;         // as Thinning
    float allTo;           // as Thinning
    float lowerInv;        // 1 / metres over which blades get lower before maxDistance
    float widest;          // how much wider blades become where they are thinned linearly, at most; 1: not
    float widerAMetre;     // at each metre where they are thinned by pixels; 0: not
    float mostLevel;       // greatest level
    float pixelsPerQuad;   // 0: levels by distance
    float near;            // the near plane (m)
    float pixelsPerMetre;  // of a metre at 1 m
    float plainPixels;     // below which a blade of level 1 is a plain triangle
};

// Blades of a chosen cell, one after the other with those of other cells.
struct TessCell {
    ivec2 cell;
    vec2 corner;  // relative to the eye
    vec2 mirror;  // numerics/population.h, CellVersion
    vec2 shift;
    uint first;   // blade of the patch
    uint slot;    // place of its first blade among all cells' blades
    uint level;   // greatest of its blades'; 0: all are plain triangles
    uint vertex;  // of its first blade's strip
};

#ifdef __cplusplus
}
#endif
// Bit of a blade's grain, a number in ]0, 1], that says that it is drawn as one triangle of its image's mean.
#define PLAIN_BLADE (1u << 30)
// Turns round the shadow mask to either side that a vertex can tell: of what leans farther, the shade is that of there.
#define MASK_TURNS 8.0
// Words of the list of chosen cells: pieces, 0, 0, 0; by batch, and for its end, the arguments of
// glDispatchComputeIndirect that take each of its pieces, and its first piece; then the commands of
// glMultiDrawArraysIndirect that draw a point a blade.
#define LIST_PIECES 0
#define LIST_BATCHES 4
#define LIST_GROUP 64  // pieces that one group takes
