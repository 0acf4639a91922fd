// The picture in which a forest's slices add up, the nearest first: pixels that they have filled are closed to those
// behind, which are then not shaded, and the whole is laid over the scene at the end. It has one sample a pixel, as
// slices' edges lie within leaves: slices reach as far as the farthest sample of the scene lets them, and samples that
// lie before the nearest slice stay as they are, so that meshes and ridges keep their smooth edges.
// Does not: draw slices (forest/texcells.h). Cost: three full-screen passes, and one more each time that full pixels
// are closed. On a software rasteriser slices took 0.58 of the time that they took with four samples a pixel.
#pragma once
#include "frame/draw_context.h"

namespace sward {

struct Veil {
    Texture color;    // premultiplied; alpha: what is filled
    Texture nearest;  // depth of the nearest slice; 0: none
    Texture depth;    // of the scene's farthest sample, and the nearest where a pixel is full
    Framebuffer target, depthAlone;
    VertexArray noVertices;
};

// Programs of the running pass, by their place in its list.
struct VeilPrograms {
    size_t behind, full, over;  // of forest/behind.frag, forest/full.frag and forest/veil.frag
};
// Whether all of them are there.
bool useVeil(DrawContext& ctx, const VeilPrograms& programs);
// Makes targets of the view's size, empties them and binds them; slices are then drawn under what is there, each with
// its depth as second color.
void beginVeil(DrawContext& ctx, const std::string& owner, Veil& veil, const VeilPrograms& programs);
// Closes pixels that are full.
void closeFull(DrawContext& ctx, const Veil& veil, const VeilPrograms& programs);
// Lays it over the scene, which is bound again.
void endVeil(DrawContext& ctx, const Veil& veil, const VeilPrograms& programs);

}  // namespace sward
