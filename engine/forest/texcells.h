// A forest's far trees as volumes: tiles are prisms over the ground, filled with slices that show what the eight stored
// tiles hold there (Decaudin and Neyret 2004, sections 4, 5 and 7). Slices are as many as the distance asks, and merge
// by pairs without a step. Which tree a texel belongs to is stored, too: each stands on the ground at its own foot, and
// none is drawn that is drawn as a mesh, or that the density leaves out.
// Beyond the paper: leaves are stored unlit, and lit by the sun as it stands, through the air that the same volume
// fills, and so are the ground and the grass below; by lamps through the leaves within five metres on the way. Does
// not: shade lamps' light on anything else. Cost: 208 bytes a frame for each tile in view; fragments: the slices.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "forest/texcells" (effects.cpp): runs in scenes with ForestVolumes.
const EffectRow& texcellsEffect();
}  // namespace sward
