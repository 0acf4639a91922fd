// How cells are chosen, and those that were.
#include "numerics/cells.h"
#include "shared/bindings.h"
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
uint bladesOf(ChosenCell c) { return c.bits & ((1u << CHOSEN_LEVEL) - 1u); }
uint levelOfCell(ChosenCell c) { return (c.bits >> CHOSEN_LEVEL) & 127u; }
bool isSet(ChosenCell c, int bit) { return (c.bits >> bit & 1u) != 0u; }
