// How cells are chosen, and those that were. Needs: numerics/glsl.h, basics.h, hash.h, lod.h, opacity.h, blade.h,
// population.h, tess.h, cells.h.
#include "shared/cells.h"
layout(std140, binding = UBO_CULL) uniform CullBlock { CullGlobals cull; };

CellGrid cullGrid() {
    CellGrid g;
    g.eyeCell = cull.eyeCell;
    g.inCell = cull.inCell;
    g.edge = cull.edge;
    g.size = cull.cellSize;
    return g;
}
uint bladesOf(ChosenCell c) { return c.look & ((1u << CHOSEN_LEVEL) - 1u); }
uint levelOfCell(ChosenCell c) { return (c.look >> CHOSEN_LEVEL) & 127u; }
bool isSet(ChosenCell c, int bit) { return (c.look >> bit & 1u) != 0u; }
