// Blurs what is far, so that blades thinner than pixels do not sparkle: two passes, across and down, weighted by
// distance. Source: Jahrmann and Wimmer 2013, section 6.4; J-10; numerics/blur.h. What is near does not bleed into what
// is far behind it. A pixel that is not finite is taken for black before it can spread. Does not: know grass:
// everything far is blurred, the sky with it. Cost: a second picture of halves; ten reads a pixel.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "post/far-blur" (techniques.cpp): runs in scenes with FarBlur.
const EffectRow& farBlurEffect();
}  // namespace sward
