// How cells that draw blades are chosen (grass/gpu_cells.h), and which were. Does not: say by which formulas;
// numerics/cells.h does.
#pragma once
#include "shared/types.h"
#ifdef __cplusplus
namespace sward {
#endif

struct STD140 CullGlobals {
    vec4 planes[6];     // of the view, inwards: normal and distance
    vec2 eyeCell;       // as CellGrid: the cell that the eye is over
    vec2 inCell;        // where in it (m)
    vec2 edge;          // where the terrain ends, x, z (m)
    float cellSize;     // m
    float reach;        // how far blades reach beyond their cell (m)
    ivec2 cells;        // along x and z
    float farthest2;    // square of the distance from which none is drawn (m2)
    float shadowReach;  // how far shadows reach (m)
    float fade;         // as CellRule
    float missing;      // as Thinning
    float allTo;        // as Thinning
    float rangeMin;
    float rangeInv;
    float smoothness;  // as tessMost takes it; 0: blades are not tessellated
    float maxDistance;
    float quadsAtOneMetre;
    float levelReach;
    float sagittaPixels;  // of a blade's sagitta at 1 m
    int mostQuads;
    float detail;     // share of the blades drawn
    vec2 texels;      // of the density map, a cell
    float plainFrom;  // distance from which blades of one quad are plain triangles (m)
    uint seed;
    uint pieceBlades;  // at most in a piece
    float drawn;       // share of the chosen blades that is drawn
    int counts;        // 1 if they are to be counted
    int unique;        // 1 if each cell has blades of its own
    float unspread;    // as CellRule
    float unstep;
    uint sowSeed;  // of cells' chances
};

// Of the cells that were chosen, without those of which only shadows are seen.
struct ChosenCounts {
    uint cells;
    uint blades;  // drawn
};

// Cells of which some may be chosen, and the heights between which their ground lies, relative to the eye.
struct NodeOfCells {
    ivec2 cell;  // the first of kNodeSide x kNodeSide (numerics/cells.h)
    vec2 heights;
};

// A cell whose blades are drawn; none: no such cell.
struct ChosenCell {
    ivec2 cell;
    uint first;  // blade of the patch
    uint bits;   // from the lowest bit: 22 bits, how many blades; 7, its greatest level; then the flags below
};

#ifdef __cplusplus
}
#endif
#define CHOSEN_LEVEL 22
#define CHOSEN_WHOLE 29  // all of it is in view
#define CHOSEN_SEEN 30   // its blades may be, not just their shadows
#define CHOSEN_PLAIN 31  // its blades are all plain triangles
