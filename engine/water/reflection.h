// What water mirrors: the scene seen by the eye's mirror image, drawn coarsely into a picture of its own for each
// water. How: a view within the view (ViewRow) with ViewSettings.coarse, cut at the water by a clipping plane; every
// effect draws itself into it as into any other view. Of Water.reflection of the picture's resolution, and only that
// part of it in which the water is seen, with a margin for ripples that look past its edges; not drawn while the water
// is out of view. Of more than eight waters in view those that take least of the picture mirror the sky alone. Does
// not: mirror what is under water, or any water. Cost: the coarse views; 8 bytes a pixel of them and a third more, and
// 12 a sample.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "water/reflection" (techniques.cpp): runs in scenes with WaterReflection, Water and Terrain.
const EffectRow& reflectionEffect();
}  // namespace sward
