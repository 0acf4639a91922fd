#include "world/placement.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/save_folder.h"

namespace sward {

glm::dmat3 rotationOf(const glm::dvec3& degrees) {
    const glm::dvec3 r = glm::radians(degrees);
    glm::dmat4 m = glm::rotate(glm::dmat4(1), r.y, glm::dvec3(0, 1, 0));
    m = glm::rotate(m, r.z, glm::dvec3(0, 0, 1));
    return glm::dmat3(glm::rotate(m, r.x, glm::dvec3(1, 0, 0)));
}

glm::dvec3 degreesOf(const glm::dmat3& m) {
    const double z = std::asin(std::clamp(m[0][1], -1.0, 1.0));
    if (std::abs(m[0][1]) > 1 - 1e-12) return glm::degrees(glm::dvec3(0, std::atan2(m[2][0], m[2][2]), z));
    return glm::degrees(glm::dvec3(std::atan2(-m[2][1], m[1][1]), std::atan2(-m[0][2], m[0][0]), z));
}

PlacedMesh placeMesh(const Project& p, Entity e) { return placeMesh(p, findGround(p), e); }

PlacedMesh placeMesh(const Project& p, const Ground& ground, Entity e) {
    const StaticMesh* mesh = p.registry.get<StaticMesh>(e);
    const Transform* transform = p.registry.get<Transform>(e);
    PlacedMesh placed{mesh, transform ? transform->position : glm::dvec3(0), rotationOf(mesh->rotationDeg), e};
    if (mesh->onGround && ground.terrain)
        placed.at.y += ground.origin.y +
                       terrainHeight(*ground.terrain, placed.at.x - ground.origin.x, placed.at.z - ground.origin.z);
    return placed;
}

std::vector<PlacedMesh> placedMeshes(const Project& p) {
    std::vector<PlacedMesh> out;
    const Ground ground = findGround(p);
    for (const auto& [name, e] : p.entities)
        if (const StaticMesh* mesh = p.registry.get<StaticMesh>(e); mesh && !mesh->file.empty())
            out.push_back(placeMesh(p, ground, e));
    return out;
}

bool hasTracedLight(const Project& p, const PlacedMesh& m) {
    return m.mesh->bakeLight == BakeLight::Traced && !p.registry.get<Rolling>(m.entity);
}

std::string fileVersion(const std::filesystem::path& dir, const std::string& file) {
    const auto place = currentFile(dir, file);
    std::error_code fault;
    const auto time = place ? std::filesystem::last_write_time(*place, fault) : std::filesystem::file_time_type{};
    return fmt::format("{}/{} {}", dir.string(), file, fault || !place ? 0 : time.time_since_epoch().count());
}

}  // namespace sward
