// Shadows of the horizontal slice on the ground, by each light that casts shadows: what grass shades where its blades
// are not drawn as geometry, which throws its own (ground_shadow.h). Source: Boulanger, Pattanaik and Bouatouch 2006,
// section 3.5, with looks at as many places as hide the light from each other (docs/raytraced.md). Does not: make
// slices or choose the ground below them (slices.h).
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "grass/far-shadow" (effects.cpp): runs in scenes with GrassFar, Grass, Terrain, GroundShadows and
// CastingLights.
const EffectRow& farShadowEffect();
}  // namespace sward
