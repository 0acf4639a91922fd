// Shadows of objects: depth maps as the sun sees them, three around the eye, for shaders/lib/shadow.glsl to look up.
// Williams 1978, in cascades (Engel 2006) of balls around the eye, so that turning the view changes nothing; each map's
// texels stay where they are in the world while the eye moves, so that edges do not swim. Does not: shadows of hills
// (terrain/shade.h) or blades. A map is drawn anew only when objects or the sun move, or the eye by a tenth of the
// map's reach; never with the sun on the horizon or below. Cost: 48 MiB; the triangles of the objects near each ball's
// column of light.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "objects/shadow" (techniques.cpp): runs in scenes with ObjectShadows.
const EffectRow& shadowEffect();
}  // namespace sward
