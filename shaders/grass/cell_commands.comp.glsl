// Makes a draw command of each chosen cell, in their order: of its blades, and of those that shade the soil. Holes draw
// nothing.
#include "lib/cull.glsl"
#include "numerics/cells.h"
#include "numerics/population.h"
#include "shared/bindings.h"
#include "shared/cells.h"
#include "shared/grass.h"

layout(local_size_x = 64) in;
layout(std430, binding = SSBO_CHOSEN) readonly buffer ChosenBlock { ChosenCell chosen[]; };
layout(std430, binding = SSBO_CELLS) writeonly buffer CellBlock { CellInstance cells[]; };
layout(std430, binding = SSBO_COMMANDS) writeonly buffer CommandBlock {
    uint commands[];
};  // five words a cell; then those of shadows
layout(location = 0) uniform uint chosenCount;
layout(location = 1) uniform uint patchBlades;
layout(location = 2) uniform float drawnShare;  // of a cell's blades
layout(location = 3) uniform float shadeShare;  // of them, those that shade
layout(location = 4) uniform uint shadowQuads;  // of a blade; 0: none shades

void command(uint at, uint i, ChosenCell c, uint quads, float share) {
    precise float drawn = float(bladesOf(c)) * share;
    uint w = 5u * at, each = 6u * quads;
    commands[w] = uint(ceil(drawn)) * each;
    commands[w + 1u] = 1u;
    commands[w + 2u] = 3u * quads * (quads - 1u) * patchBlades + c.first * each;
    commands[w + 3u] = 0u;
    commands[w + 4u] = i;
}
void nothing(uint at) {
    for (uint k = 0u; k < 5u; ++k) commands[5u * at + k] = 0u;
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= chosenCount) return;
    ChosenCell c = chosen[i];
    CellVersion v = cellVersion(c.cell.x, c.cell.y, cull.seed);
    cells[i] = CellInstance(c.cell, cellCorner(cullGrid(), c.cell.x, c.cell.y), v.mirror, v.shift,
                            max(int(levelOfCell(c)), 1), 0.0);
    bool any = bladesOf(c) > 0u;
    if (any && isSet(c, CHOSEN_SEEN))
        command(i, i, c, levelOfCell(c), drawnShare);
    else
        nothing(i);
    if (shadowQuads == 0u) return;
    if (any)
        command(chosenCount + i, i, c, shadowQuads, shadeShare);
    else
        nothing(chosenCount + i);
}
