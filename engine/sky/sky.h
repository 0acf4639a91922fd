// Sun and sky: Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight", 1999 (formulas: numerics/sky.h);
// or by the tables of sky/atmosphere.h. Systems turn the components into the frame's light; the pass "sky/dome" draws
// the sky where nothing else is, and below the horizon the hazy ground that lies beyond the terrain. Does not: clouds,
// night, shadows. Cost: the dome 1 fragment a sky pixel; the light, once a change, 1 ms of CPU.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "sky/sun" (techniques.cpp): runs in scenes with Sun.
const EffectRow& sunEffect();
// Row of the effect "sky/dome" (techniques.cpp): runs in scenes with Sky.
const EffectRow& skyEffect();
// Row of the effect "sky/haze" (techniques.cpp): runs in scenes with Fog.
const EffectRow& hazeEffect();
}  // namespace sward
