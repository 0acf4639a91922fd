// Where the scene's objects stand: for drawing, for shadows, for rays.
// Does not: read their files (mesh/mesh_io.h).
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/project.h"
#include "world/ground.h"

namespace sward {

struct PlacedMesh {
    const StaticMesh* mesh = nullptr;
    glm::dvec3 at{0};    // its origin in the world
    glm::dmat3 turn{1};  // rotation, without the scale
    Entity entity = kNoEntity;
};
// Degrees about x, then z, then y.
glm::dmat3 rotationOf(const glm::dvec3& degrees);
// Degrees of which rotationOf makes this rotation.
glm::dvec3 degreesOf(const glm::dmat3& turn);
// Every StaticMesh with a file, in the order of their entities' names. One that stands on the ground counts its height
// from the terrain below its origin (at the terrain's edge where it stands beyond).
std::vector<PlacedMesh> placedMeshes(const Project& p);
// One of them; `e` must have a StaticMesh.
PlacedMesh placeMesh(const Project& p, Entity e);
// The same with what findGround gave, for who places many.
PlacedMesh placeMesh(const Project& p, const Ground& ground, Entity e);

// Whether light from all around it is traced (reference/object_light.h): it asks for that, and stays where it is.
bool hasTracedLight(const Project& p, const PlacedMesh& m);

// A text that changes with the file's place and time; also for files that are not there. file: relative to dir, the
// project's folder.
std::string fileVersion(const std::filesystem::path& dir, const std::string& file);

}  // namespace sward
