// The sky's model "atmosphere" (sky/air_tables.h) for drawing: makes the tables, hands the sky's light to who sums it
// (sky/sky.h), and binds sky and air for shaders (lib/air.glsl). Cost: two reads of small textures a picture's texel;
// 0.1 MB.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "sky/atmosphere" (techniques.cpp): runs in scenes whose Sky has that model.
const EffectRow& atmosphereEffect();
}  // namespace sward
