// Slices as textures. Sizes at the paper's resolution (20 slices of 512 x 64, one of 512 x 512), mips included:
// factored 19.6 MB, compressed 8.6 MB, full 60 MB. Does not: make slices (slice_bake.h).
#pragma once
#include "gpu/resources.h"
#include "grass/image_light.h"
#include "grass/slice_bake.h"
#include "grass/slice_settings.h"

namespace sward {

// Arrays of layers. Vertical: layers 0..slices-1 cut x, then, where they have images of their own, those that cut z.
// Light: the numbers of the front view, layer by layer, then those of the back view. Full storage: colours, layers
// [view][light][slice].
struct SliceTextures {
    Texture reflectance, threshold, light;           // vertical
    Texture farReflectance, farThreshold, farLight;  // horizontal, one layer
    int slices = 0, layers = 0;                      // along an axis; of the vertical images
    float top = 0, reflectScale = 1;
    float farDepth = 0;  // optical depth of the horizontal slice: what its mean opacity is 1 - exp of
    DrawnImages means;   // for gains
    // Bytes of the textures, levels included, as the GPU's ledger counts them.
    size_t bytes() const;
};
// An empty owner: those textures are not wanted.
SliceTextures uploadSlices(Gpu& gpu, const std::string& owner, const std::string& farOwner, const SliceImages& images,
                           Storage storage, SliceSets sets = SliceSets::Each, const SliceStand& stand = {});

}  // namespace sward
