// The picture in which a forest's slices add up, the nearest first: pixels that they have filled are closed to those
// behind, which are then not shaded, and the whole is laid over the scene at the end.
// Does not: draw slices (forest/texcells.h). Cost: color and depth of all samples once more, and a full-screen pass
// each time that full pixels are closed. On a software rasteriser slices took 0.91 of their time with it (two pairs).
#pragma once
#include "frame/draw_context.h"

namespace sward {

struct Veil {
    Texture color;    // premultiplied; alpha: what is filled
    DepthCopy depth;  // the scene's, and the nearest where a pixel is full
    Framebuffer target, depthAlone;
    VertexArray noVertices;
    int samples = 0;
};

// Makes targets of the view's size, empties them and binds them; slices are then drawn under what is there.
void beginVeil(DrawContext& ctx, const std::string& owner, Veil& veil);
// Closes pixels that are full. program: of forest/full.frag, of the running pass.
void closeFull(DrawContext& ctx, const Veil& veil, size_t program);
// Lays it over the scene, which is bound again. program: of forest/veil.frag, of the running pass.
void endVeil(DrawContext& ctx, const Veil& veil, size_t program);

}  // namespace sward
