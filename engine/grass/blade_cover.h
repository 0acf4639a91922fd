// What a blade's image leaves of the blade: the moments of its alpha along the blade, and what follows for blades that
// are drawn as one quad or one triangle, far away, so that they show as much, as high and as bright as whole ones. Does
// not: know splines or light (lib/straight.glsl).
#pragma once
#include <array>

#include "frame/color_image.h"
#include "shared/grass.h"

namespace sward {

// Means of v^0 to v^3 times the image's alpha over its rows, from the root (v = 0) to the tip (1); of no image, of a
// whole rectangle.
using AlphaMoments = std::array<double, 4>;
AlphaMoments alphaMoments(const Rgba8& image);
// Mean colour (linear, 0 to 1) of what the image leaves of a blade, weighted as what is seen among other blades is:
// from a fourth at the root to all at the tip. Of an image that is missing or clear, 0.5, at which blades keep their
// colour.
glm::vec3 meanColor(const Rgba8& image);
// Means of the image's alpha over so many even parts of its length, at least 1, from the root; of no image, 1.
std::vector<float> alphaAlong(const Rgba8& image, int parts);
// Writes what shaders need of the moments: SpeciesGlobals from `middle` to `lightRow`.
void setCover(SpeciesGlobals& g, const AlphaMoments& m);

}  // namespace sward
