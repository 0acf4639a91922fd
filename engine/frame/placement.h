// Where the scene's objects stand: for drawing, for shadows, for rays.
// Does not: read their files.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/project.h"

namespace sward {

struct PlacedMesh {
    const StaticMesh* mesh = nullptr;
    glm::dvec3 at{0};     // its origin in the world
    glm::dmat3 turn{1};   // rotation, without the scale
};
// Every StaticMesh with a file, in the order of their entities' names. One that stands on the ground counts its height
// from the terrain below its origin (at the terrain's edge where it stands beyond).
std::vector<PlacedMesh> placedMeshes(const Project& p);

}  // namespace sward
