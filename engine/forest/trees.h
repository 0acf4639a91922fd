// Trees drawn as meshes: those that stand nearer than Forest.meshesTo, by instances, with fewer and larger leaves the
// farther they are. Those that the view does not touch are not drawn, but may cast shadows.
// Does not: say which trees stand (forest/stand.h), draw the others (forest/texcells.h). Cost: 48 bytes and 40 ns of
// CPU a frame for each near tree; one draw for each part of each species and level.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "forest/trees" (effects.cpp): runs in scenes with ForestMeshes.
const EffectRow& treesEffect();
}  // namespace sward
