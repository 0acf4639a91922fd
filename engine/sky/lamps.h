// Lights beside the sun: every frame, where they are and how bright, in the uniform block that shaders/lib/lamps.glsl
// reads. A point light gives intensity / (1 + beta d^2) (Boulanger, Pattanaik and Bouatouch 2006, appendix; B-22, T-8).
// Directional ones carry the weights of the five images of a slice (equations 8-13, exact form), computed here once a
// frame. The first MAX_LIGHTS by name shine; of them, those that cast shadows come first. White stays white: lamps are
// seen in the camera's balance, unlike the sun. Does not: lift the sky or what the ground throws back. Cost: 400 bytes
// a frame; a loop over the lights a vertex.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "sky/lamps" (techniques.cpp): runs in scenes with Lamps.
const EffectRow& lampsEffect();
}  // namespace sward
