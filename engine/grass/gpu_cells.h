// A species' cells of which blades are drawn, as buffers of the GPU: chosen by the CPU (cells.h), or by the GPU itself
// from the nodes of the quadtree that the CPU finds in view. Both choose the same cells, in the same order, by the same
// formulas; nothing is read back. The CPU's part is then the nodes: 16 bytes for 64 cells, instead of 16 bytes a cell.
// Source: Jahrmann and Wimmer 2013, section 6.1. Does not: draw.
#pragma once
#include "grass/cells.h"
#include "shared/cells.h"

namespace sward {

struct ChosenCells {
    Buffer nodes, globals, upTo;
    uint64_t upToOf = 0;       // patchKey
    Buffer chosen;             // ChosenCell each, or holes without blades
    uint32_t count = 0;        // of `chosen`, holes included
    uint32_t patchBlades = 0;  // of the patch
    uint32_t blades = 0;       // at most, in a cell
    uint64_t allBlades = 0;    // at most, in all cells
    uint64_t vertices = 0;     // of strips, at most (tessellated)
    uint64_t pieces = 0;       // of at most `pieceBlades`, at most
    bool byGpu = false;
    // How many were chosen, by the GPU in a frame before, of which it is known without waiting.
    ChosenCounts last{};
    Buffer counts;
    uint32_t frame = 0;
    bool counting = false;  // this frame's
    std::unique_ptr<std::remove_pointer_t<GLsync>, void (*)(GLsync)> counted{nullptr,
                                                                             [](GLsync s) { glDeleteSync(s); }};
};
struct CellWish {
    const CellQuery& query;
    uint64_t patchKey;
    float detail;          // share of the blades that is chosen
    float drawn;           // share of those that is drawn, for the statistics
    float plainFrom;       // metres from which blades of one quad are plain triangles
    uint32_t pieceBlades;  // blades at most in a piece
    bool byGpu;            // it chooses
};

// What the shaders know of a query.
CullGlobals cullGlobals(const CellWish& wish);
// What the CPU does: uploads nodes, or cells. Sets the bounds, and adds the counts to the frame's statistics.
void chooseCells(DrawContext& ctx, ChosenCells& c, const CellWish& wish, const char* owner);
// What the GPU does, if it chooses, by the current program of grass/cells.comp.glsl. `density`: the map's texture, or
// 0. Leaves SSBO_CHOSEN and UBO_CULL bound.
void runChoice(ChosenCells& c, GLuint density);
// Whether a frame's counts are to be its own, and are waited for.
bool countsThisFrame(const ViewSettings& settings);
// If so, its own counts instead of those of a frame before.
void recount(DrawContext& ctx, ChosenCells& c);

}  // namespace sward
