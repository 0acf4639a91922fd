// A map of what presses on the grass, around the eye: one texture of 512 x 512 whatever the world's size, drawn anew
// each frame from the list of forces (world/forces.h). Source: Jahrmann and Wimmer 2013, section 5.2; J-8. Its square
// is 32 m wide, or as wide as eight of the largest force; its texels stay where they are in the world while the eye
// moves. Long and round ones are its own; outlines are drawn into it by grass/force_outlines.h. And the painted map of
// forces, for who draws blades. Does not: bend blades (lib/force.glsl does), walk. Cost: 4 MB; 28 bytes and a small
// square a force.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "grass/forces" (techniques.cpp): runs in scenes with Forces, Grass and Terrain.
const EffectRow& forcesEffect();
}  // namespace sward
