// Objects that a Scatter scatters, drawn as those of objects/mesh are, by instances: one draw for each material of each
// mesh. They are kept in squares of the terrain; those that the view does not touch are not drawn, but may cast
// shadows. Does not: say where they stand (world/scatter.h). Cost: 48 bytes a frame and 20 ns of CPU for each that is
// near.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "objects/scatter" (effects.cpp): runs in scenes with Scatter.
const EffectRow& scatterEffect();
}  // namespace sward
