// Hands the scene's wind to every shader that bends what grows (lib/wind.glsl): a block of numbers, and a picture of
// gusts. Does not: say how hard it blows (world/wind.h), bend anything. Cost: 96 bytes a frame; 64 KB for the picture
// that is made.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "sky/wind" (techniques.cpp): runs in scenes with Wind.
const EffectRow& windEffect();
// Row of the effect "sky/gusts" (techniques.cpp): runs in scenes with Gusts and Wind.
const EffectRow& gustsEffect();
}  // namespace sward
