// How a species looks where its blades are too far to be drawn: mean reflectance and mean light of what is seen of them.
// Averages the same poses, gradient and two-sided Lambert light that blades are drawn with, over some of the patch's blades.
// Does not: depend on the view (the ground's shader adds the lean's part). Cost: 0.05 ms.
#pragma once
#include "frame/draw_context.h"
#include "scene/population.h"

namespace sward {
CoverSpecies meanCover(const Species& species, const Patch& patch, const FrameGlobals& frame);
}  // namespace sward
