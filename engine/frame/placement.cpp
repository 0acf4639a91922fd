#include "frame/placement.h"

#include <glm/gtc/matrix_transform.hpp>

#include "frame/ground.h"

namespace sward {
namespace {

// About x, then z, then y.
glm::dmat3 rotationOf(const glm::dvec3& degrees) {
    const glm::dvec3 r = glm::radians(degrees);
    glm::dmat4 m = glm::rotate(glm::dmat4(1), r.y, glm::dvec3(0, 1, 0));
    m = glm::rotate(m, r.z, glm::dvec3(0, 0, 1));
    return glm::dmat3(glm::rotate(m, r.x, glm::dvec3(1, 0, 0)));
}

}  // namespace

std::vector<PlacedMesh> placedMeshes(const Project& p) {
    const Ground ground = findGround(p);
    std::vector<PlacedMesh> out;
    for (const auto& [name, e] : p.entities) {
        const StaticMesh* mesh = p.registry.get<StaticMesh>(e);
        if (!mesh || mesh->file.empty()) continue;
        const Transform* transform = p.registry.get<Transform>(e);
        PlacedMesh placed{mesh, transform ? transform->position : glm::dvec3(0), rotationOf(mesh->rotationDeg)};
        if (mesh->onGround && ground.terrain)
            placed.at.y += ground.origin.y + terrainHeight(*ground.terrain, placed.at.x - ground.origin.x, placed.at.z - ground.origin.z);
        out.push_back(placed);
    }
    return out;
}

}  // namespace sward
