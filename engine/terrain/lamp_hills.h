// Shadows of hills in lamps' light: for each lamp that casts shadows a map of lines along its light, of how high one
// must stand to see it past the ground before (lib/lamp_hills.glsl; horizons after Max 1988, along rays from the lamp).
// Made on the GPU, anew only where the lamp or the ground changed. Does not: shadows in the sun's light
// (terrain/shade.h), or of the land beyond the terrain. Cost: 1 MiB a lamp; 262,144 heights a lamp that moves.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "terrain/lamp-hills" (techniques.cpp): runs in scenes with LampHills and Terrain.
const EffectRow& lampHillsEffect();
}  // namespace sward
