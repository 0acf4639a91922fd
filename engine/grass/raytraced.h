// Grass as a material: in the fragments of a carrier over the ground, rays are traced through the vertical slices that
// the hybrid draws as quads, front to back. Source: Habel, Wimmer and Jeschke 2007; H-1 to H-9.
// The paper's: the shell, its slices and the ray's steps (section 3, numerics/rays.h), the depth where a share of the
// opacity is reached, look-ups sheared by the wind (section 4). Ours:
//   - the carrier is the terrain lifted by the tallest blade; slices, patches, mirrors and shifts of cells, densities,
//     light and gains are those of the hybrid's slices (lib/slices.glsl), so that tiers agree and no grid shows;
//   - the shear is of the ray, both ways, and not of each look-up: slices then stand, and the ray leans;
//   - below the vertical slices lies the horizontal one (grass/far), for what they leave of a steep view;
//   - what is beyond the last step is filled with the mean of the slices there, as opaque as they would be;
//   - over bare ground rays look ahead to where something grows, and steps there do not count, so that grass beyond a
//     path or a mown bed is seen across it;
//   - an eye inside the shell has its rays begin at the eye (H-5).
// Does not: bake (slice_bake.h), shade the ground (grass/far-shadow), know a ground that bends within a ray's way: it
// is taken for level or sloping as it is where the ray comes in.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "grass/raytraced" (effects.cpp): runs in scenes with GrassRaytraced, Grass and Terrain.
const EffectRow& raytracedEffect();
}  // namespace sward
