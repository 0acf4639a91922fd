// Resolves the view's samples and brings linear light to the screen: exposure, Khronos PBR Neutral tone mapping, sRGB.
// Does not: blur, grade. False-colour views pass through unmapped. Cost: one full-screen fragment each pixel.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "post/tonemap" (techniques.cpp): runs in every scene.
const EffectRow& tonemapEffect();
// The brush's ring and disc, drawn over whatever the depth buffer shows; nothing without a brush.
const EffectRow& decalEffect();
}  // namespace sward
