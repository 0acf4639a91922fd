// The ground as meshes of a .glb. For glb_export.cpp. Does not: images; its colours are its vertices'.
#pragma once
#include "exchange/glb_export.h"
#include "world/ground.h"

namespace tinygltf {
class Model;
}

namespace sward {

// Quads along x and z: one a texel of the height map and of the colour map, whichever has more, at most kGroundQuads;
// one where it has neither.
glm::ivec2 groundQuads(const Terrain& t);
// Chunks in nodes "ENTITY/x,z", each relative to its corner. Nothing without a terrain.
void addGround(tinygltf::Model& m, const Project& p, const Ground& ground, GlbCounts& counts);

}  // namespace sward
