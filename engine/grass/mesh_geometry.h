// Grass on meshes blade by blade, where blades over the terrain are: near the eye by the hybrid, everywhere by the
// technique "geometry". Beyond, rays through slices take over (grass/mesh_grass.h): which of both draws a blade is
// decided as on the terrain (numerics/opacity.h). The blades are those of the ray-traced truth
// (grass/mesh_planting.h): each stands in the axes of the surface at its root, and is lit there.
// Does not: draw more than kMostDrawnOnMesh blades of one mesh (grass/on_mesh.h), which rays then show alone; cast
// shadows; follow forces. Cost: 64 bytes and 1 us a blade once; pieces of 256 blades are drawn or left out together.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "grass/mesh-geometry" (effects.cpp): runs in scenes with GrassMeshGeometry, Objects, Grass,
// Terrain.
const EffectRow& meshGeometryEffect();
}  // namespace sward
