// Grass by tessellation: every blade to a greatest distance, each as finely as its distance or its length on screen
// asks. Source: Jahrmann and Wimmer 2013; J-5 to J-7. The blades are the population's own, posed as every technique
// poses them, so that eqs 2, 3 and 6 (its shapes) and 10 to 12 (its random numbers) have no place here. Two ways to the
// same picture (GrassField.tessellation): the GPU's tessellation stages, one patch a blade; or a compute pass that
// writes posed and lit strips, which software rasterisers run on all cores, where they run vertex work on one.
// Does not: what grows where (field.h), shadows on the ground: grass/far-shadow throws them from the horizontal slice,
// and where there is none (Beyond::Nothing) soil is shaded in the mean. Cost: docs/tessellated.md.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "grass/tessellated" (techniques.cpp): runs in scenes with GrassTessellated, Grass and Terrain.
const EffectRow& tessellatedEffect();
}  // namespace sward
