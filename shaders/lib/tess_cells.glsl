// The cells of which blades are drawn, in the order of their slots.
#include "shared/tess.h"
layout(std430, binding = SSBO_CELLS) readonly buffer TessCellBlock { TessCell cells[]; };
layout(std430, binding = SSBO_LIST) readonly buffer ListBlock { uint list[]; };

// The cell that a slot belongs to: the last one that begins no later.
uint cellOf(uint slot) {
    uint low = 0u, high = list[LIST_PIECES] - 1u;
    while (low < high) {
        uint middle = (low + high + 1u) / 2u;
        if (cells[middle].slot <= slot)
            low = middle;
        else
            high = middle - 1u;
    }
    return low;
}
