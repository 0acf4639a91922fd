// What grows, as instances of a mesh a species. For glb_export.cpp. Does not: decide what grows
// (reference/standing.h).
#pragma once
#include <span>

#include "exchange/glb_export.h"
#include "reference/standing.h"
#include "world/ground.h"

namespace tinygltf {
class Model;
}

namespace sward {

// Where an instance of a blade's mesh stands: the mesh is 1 wide along x, its root lies at the origin, its tip at
// (0, 1, 1).
struct GlbInstance {
    glm::vec3 at{0};
    glm::vec4 turn{0, 0, 0, 1};  // unit quaternion, w last
    glm::vec3 scale{1};          // above 0
};
// axes: columns in which the blade stands upright.
GlbInstance instanceOf(const Posed& blade, const glm::mat3& axes = glm::mat3(1));

// Adds them and counts them. origin: of the terrain's corner in the world.
void addBlades(tinygltf::Model& m, const Project& p, std::span<const StandingSpecies> species, const glm::dvec3& origin,
               GlbCounts& counts);
void addBladesOnMeshes(tinygltf::Model& m, const Project& p, std::span<const StandingOnMesh> species,
                       const glm::dvec3& origin, GlbCounts& counts);
// Objects of every Scatter and trees of every Forest, a node for each of its meshes. Unsound: a file that cannot be
// read.
Status addScattered(tinygltf::Model& m, const Project& p, const Ground& ground, GlbCounts& counts);
// In the order in which standingFlowers gives them.
void addFlowers(tinygltf::Model& m, const Project& p, std::span<const StandingFlower> flowers, const glm::dvec3& origin,
                GlbCounts& counts);

}  // namespace sward
