// Water's surface: what it mirrors, what is seen through it, and glints of sun and lamps. Stands wherever the terrain
// is below its level. Sources: Fresnel's equations; Cox and Munk 1954 (slopes, glint); Pope and Fry 1997 (what pure
// water takes). Formulas: numerics/water.h. How: one quad for each water over the parts of the terrain that lie lower
// and are in view, blended by two outputs a fragment, so that what is under water is dimmed where it was drawn and
// nothing is copied. Does not: bend what is seen through it, show itself from below (an eye under water sees none of
// it), write depth. Cost: a fragment a pixel of water, about as dear as an object's; no memory but a uniform buffer a
// water.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "water/surface" (techniques.cpp): runs in scenes with Water and Terrain.
const EffectRow& waterEffect();
}  // namespace sward
