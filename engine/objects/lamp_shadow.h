// Shadows of objects in lamps' light: depths as each lamp that casts shadows sees them, for
// shaders/lib/lamp_shadow.glsl to look up. Of a lamp that stands somewhere: the six faces of a cube around it (Williams
// 1978, of all directions), in which what is nearer than LAMP_SHADOW_NEAR shades nothing. Of a directional one: six
// cascades around the eye, as the sun has three (objects/shadow.h). A map is drawn anew only when objects or its lamp
// move, or, of a cascade, the eye by a tenth of its reach. Objects beyond where a lamp's light can be seen are left
// out. Does not: shadows of hills (terrain/lamp_hills.h) or of blades, or of far trees, which are no meshes. Cost: 6
// MiB a lamp; six times the triangles of the objects around a lamp that moves.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "objects/lamp-shadow" (techniques.cpp): runs in scenes with LampShadows.
const EffectRow& lampShadowEffect();
}  // namespace sward
