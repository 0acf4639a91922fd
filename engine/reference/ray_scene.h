// Triangles that rays are cast against, by Embree.
// Does not: know projects (see scene_rays.h), or shade.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/error.h"

namespace sward {

struct Triangles {
    std::vector<glm::vec3> positions;
    std::vector<uint32_t> indices;  // three a triangle, each below positions.size()
};

// Meshes that are shown where they stand, any number of times, without copies.
struct TriangleInstances {
    struct Placed {
        uint32_t mesh;  // of meshes
        glm::vec3 at;
        glm::mat3 turn;  // with the scale
    };
    std::vector<Triangles> meshes;
    std::vector<Placed> placed;
};

struct TriangleHit {
    float t;                  // in lengths of the ray's direction
    uint32_t mesh, triangle;  // mesh: instance i has the number of meshes + i
    float u, v;               // weights of the triangle's second and third corner
    glm::vec3 normal;         // of the triangle; any length; of an instance as its mesh has it, not turned
};

class RayScene {
  public:
    // Takes some 100 bytes a triangle and a second for two million. Failed without memory.
    static Result<RayScene> make(const std::vector<Triangles>& meshes, const TriangleInstances& instances = {});
    RayScene(RayScene&&) = default;
    RayScene& operator=(RayScene&&) = default;
    // Whether anything lies on origin + t way, 0 < t < far. Two-sided. From any thread.
    bool hits(const glm::vec3& origin, const glm::vec3& way, float far = std::numeric_limits<float>::infinity()) const;
    // The first thing on it, near < t < far.
    std::optional<TriangleHit> closest(const glm::vec3& origin, const glm::vec3& way, float near, float far) const;

  private:
    struct Device;
    explicit RayScene(std::shared_ptr<Device> device) : device_(std::move(device)) {}
    std::shared_ptr<Device> device_;
};

}  // namespace sward
