// Grass on meshes: in the fragments of a shell over a mesh rays are traced through the slices of a field's species
// (lib/slice_rays.glsl); near the eye of those techniques that draw blades one by one such take over
// (grass/mesh_geometry.h). Source: Habel, Wimmer and Jeschke 2007 (a shell over any surface with texture coordinates);
// frames: H-6.
// The paper's: the surface's tangent space, in which slices stand at equal steps of the texture coordinates. Ours:
//   - the surface bends under the ray as it does where the ray comes in, so that grass stands out against the sky at a
//     ball's edge instead of ending with the shell;
//   - where the shell's far side is drawn, a ray is known to leave there, and how steeply: so it also finds the grass
//     of the next hump of a rock;
//   - where the surface ends the shell has walls (mesh/carrier.h);
//   - for an eye within the shell rays begin at the eye, in the frame of the surface under it;
//   - images, gains and cells are those of the slices over the terrain; light comes in the surface's own axes.
// Does not: bake other images than a field's own, cast shadows on anything but the mesh that carries it, or follow
// forces, which press on the terrain's grass.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "grass/mesh-grass" (effects.cpp): runs in scenes with GrassOnMeshes, Objects, Grass and Terrain.
const EffectRow& meshGrassEffect();
}  // namespace sward
