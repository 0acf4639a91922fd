// What shades a blade: pictures of its neighbours on a cylinder around it.
// Source: Boulanger, Pattanaik and Bouatouch 2006, section 3.5; B-21. A section of the patch is drawn from the side,
// black on white, once a species; here on the CPU, where it comes out the same on every machine and needs no context.
// The paper draws one, and looks up where the ray to the light leaves the cylinder: right for what stands there, but
// most of what shades a point in dense grass stands much nearer, and in low light some of it much farther. Ours has a
// layer for each of kMaskLayers rises of the light (numerics/shadow.h, maskRise), drawn as parallel light of that rise
// brings shadows: a point of a blade that stands z metres off lies lower by what the light rises over z. So each layer
// knows all that shades, near and far, and its shadows have edges as sharp as they fall. A section is as long as the
// cylinder's girth, and wraps; a texel is half as wide as a blade is seen in the mean. The mask scales with the
// density: its four channels hold what it lets through at densities 1/4, 2/4, 3/4 and 1, counted from the thresholds of
// the blades that cover a texel, and a look-up blends the two nearest. Neither one picture scaled by the density (too
// light where several blades hide each other) nor a picture of thresholds (B-14: means of them are nonsense) would be
// right. Does not: know other species, the lean that is painted, or wind. Cost: 20 to 60 ms once a species; 221 KB at
// 64 texels.
#pragma once
#include <cstdint>

#include "frame/color_image.h"
#include "grass/appearance.h"
#include "scene/population.h"
#include "scene/rows.h"

namespace sward {

inline constexpr int kMaskLayers = 12;  // even steps of maskRise, the layer's own in the middle of each

struct BladeMask {
    int width = 0, height = 0;    // of a layer, texels
    float radius = 0, top = 0;    // of the cylinder, metres
    float reach = 0;              // how far from a blade stands what shades it, metres: half the mean height, at least
    std::vector<uint8_t> pixels;  // RGBA, layer by layer, each from the ground up; a layer's top row is white
    const uint8_t* at(int layer, int row, int column) const {
        return &pixels[static_cast<size_t>(((layer * height + row) * width + column) * 4)];
    }
};
// `width` texels around, at least 4; as many rows. image: of the species' blades; none: they are opaque and do not
// taper.
BladeMask makeBladeMask(const Species& species, const Patch& patch, float cellSize, int width, const Rgba8& image);

// What means over a mask are told: all but its texture.
BladeShade shadeBy(const BladeMask& mask);

// What shades a species of a field, by the entity's name; nothing where blades do not shade each other.
BladeShade shadeOf(const DrawContext& ctx, const std::string& field, size_t species);

// Row of the effect "grass/mask" (techniques.cpp): runs in scenes with BladeShadows, CastingLights, Grass and Terrain.
const EffectRow& maskEffect();

}  // namespace sward
