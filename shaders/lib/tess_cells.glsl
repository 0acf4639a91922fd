// The cells of which blades are drawn, in the order of their slots. Needs: tess.glsl or the like for takeCell.
layout(std430, binding = SSBO_CELLS) readonly buffer TessCellBlock { TessCell cells[]; };
layout(location = 0) uniform uvec4 work;  // cells [x, y) with slots [z, w)

// The cell that a slot belongs to: the last one that begins no later.
uint cellOf(uint slot) {
    uint low = work.x, high = work.y - 1u;
    while (low < high) {
        uint middle = (low + high + 1u) / 2u;
        if (cells[middle].slot <= slot) low = middle;
        else high = middle - 1u;
    }
    return low;
}
