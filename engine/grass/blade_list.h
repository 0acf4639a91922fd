// The blades of the selected cells that can be seen, one by one, and the indices that draw them: for renderers that
// shade vertices on the CPU, where a vertex costs many times what a look at its blade does. Pure. Left out are blades
// outside the view, those that density and distance leave to other tiers (numerics/opacity.h), and those so faded that
// by their own chance they cover no sample (lib/transparency.glsl). The picture is the same, bit for bit. Does not:
// decide exactly. It may keep a blade that the shader drops; it never leaves out one that would be seen. Cost: about 20
// ns a blade of the cells on each of all threads; 24 bytes a quad that is drawn.
#pragma once
#include <span>

#include "grass/cells.h"
#include "grass/drawing.h"

namespace sward {

// How pixels that are covered in part are drawn.
struct PixelCoverage {
    Transparency way = Transparency::Coverage;
    int samples = 1;     // a pixel
    uint32_t shift = 0;  // by how many 256ths this frame moves chances on: FrameGlobals.chanceShift
};
// The opacity, ]0, 1[, from which on a blade may show anything.
float leastShown(const Blade& b, const PixelCoverage& c);

struct BladeListQuery {
    const CellQuery& cells;
    float beyond;  // metres from a root within which all that is drawn of its blade lies
    PixelCoverage shown;
    float share = 1;       // of each cell's blades, the first ones: ]0, 1]
    bool shadows = false;  // of these blades, which end in a point; `shown` is idle: each has its chance, dither
};
struct BladeList {
    std::vector<uint32_t> indices;      // triangles over the 2 (segments + 1) vertices of each blade of the patch
    std::vector<DrawCommand> commands;  // one a cell that has any; the instance is its place among the cells
    uint64_t blades = 0;
    bool tooMany = false;  // more than kMostListed: nothing is listed
};
inline constexpr size_t kMostListed =
    size_t{1} << 28;  // indices; 1 GB: what drivers give in one piece. More are drawn by ranges of the patch
// Adds the indices of a strip of n quads over the first rows of the blade's vertices; pointed: the last is a triangle.
void addStrip(std::vector<uint32_t>& indices, uint32_t blade, int quads, int segments, bool pointed = false);
BladeList listBlades(const BladeListQuery& q, std::span<const CellDraw> cells);

}  // namespace sward
