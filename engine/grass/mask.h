// What shades a blade: a picture of its neighbours on a cylinder around it.
// Source: Boulanger, Pattanaik and Bouatouch 2006, section 3.5; B-21. A section of the patch is drawn from the side,
// black on white, once a species; here on the CPU, where it comes out the same on every machine and needs no context.
// The cylinder's radius is half the mean height of the blades, or one and a half times their spacing where they stand
// wider: then the foot of a blade in light from 45 degrees is shaded by what stands half-way up its neighbours. The
// section is as long as the cylinder's girth, and wraps; it is as thick as the cylinder is wide, because the ray to the
// light passes about as many blades behind the cylinder as before it. The mask scales with the density: its four
// channels hold what it lets through at densities 1/4, 2/4, 3/4 and 1, counted from the thresholds of the blades that
// cover a texel, and a look-up blends the two nearest. Neither one picture scaled by the density (too light where
// several blades hide each other) nor a picture of thresholds (B-14: mipmaps average them into nonsense) would be right
// both near and far. Does not: know other species, the lean that is painted, or wind. Cost: 1 to 5 ms once a species;
// 25 KB at 64 texels.
#pragma once
#include <cstdint>

#include "grass/appearance.h"
#include "scene/population.h"
#include "scene/rows.h"

namespace sward {

struct BladeMask {
    int width = 0, height = 0;
    float radius = 0, top = 0;    // of the cylinder, metres
    std::vector<uint8_t> pixels;  // RGBA, row 0 at the ground; the top row is white
};
// `width` texels around, at least 4; as many rows as make them square.
BladeMask makeBladeMask(const Species& species, const Patch& patch, float cellSize, int width);

// Mean of each row at density 1, from the ground up: BladeShade::rows.
std::vector<float> maskRows(const BladeMask& mask);

// What shades a species of a field, by the entity's name; nothing where blades do not shade each other.
BladeShade shadeOf(const DrawContext& ctx, const std::string& field, size_t species);

// Row of the effect "grass/mask" (techniques.cpp): runs in scenes with BladeShadows, CastingLights, Grass and Terrain.
const EffectRow& maskEffect();

}  // namespace sward
