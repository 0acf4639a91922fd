// What water mirrors: the scene seen by the eye's mirror image, drawn coarsely into a picture of its own.
// How: a view within the view (ViewRow) with ViewSettings.coarse, cut at the water by a clipping plane; every effect
// draws itself into it as into any other view. Of Water.reflection of the picture's
// resolution, with a margin for ripples that look past its edges; not drawn while no water is in view. Does not: mirror
// what is under water, or the water itself. Cost: the coarse view; 8 bytes a pixel of it and a third more, and 12 a
// sample.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "water/reflection" (techniques.cpp): runs in scenes with WaterReflection, Water and Terrain.
const EffectRow& reflectionEffect();
}  // namespace sward
