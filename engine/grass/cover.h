// How a species looks where its blades are too far to be drawn: mean reflectance, ambient light, and how much of its blades
// stands upright or lies level, of what is seen of them. Averages the poses and the gradient that blades are drawn with.
// Where blades shade each other, their direct light is what the mask lets through on average, instead of the darkening
// towards the root that stands in for it.
// Does not: depend on the view; the ground's shader integrates the sun over the azimuths that face the eye. Cost: 0.05 ms.
#pragma once
#include "frame/draw_context.h"
#include "scene/population.h"

namespace sward {
CoverSpecies meanCover(const Species& species, const Patch& patch, const FrameGlobals& frame, const BladeShade& shade);
}  // namespace sward
