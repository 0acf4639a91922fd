// Flowers among the grass, as instanced billboards: a stem that turns to the eye and a head that faces half upward.
// Source: Jahrmann and Wimmer 2013. Formulas: numerics/flower.h; wind and forces are the grass's own (lib/wind.glsl,
// lib/force.glsl). How: cells in view are listed on the CPU with as many of their flowers as density and distance
// leave, and drawn at once; the vertex stage places, leans and lights them. With distance they shrink one after the
// other, and those left grow: few large ones stand for many where a head is less than half a pixel. Does not: cast
// shadows, show in water (ripples that look past the near shore would find heads there), nor stand in the grass's own
// (the shadow mask is of blades). Cost: 8 vertices a flower; a look at each cell within
// maxDistance, 32 bytes for one in view; an image of 64 x 160.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "grass/flowers" (techniques.cpp): runs in scenes with Flowers and Terrain.
const EffectRow& flowersEffect();
}  // namespace sward
