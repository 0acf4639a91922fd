// Scenes of a few quads, for tests of rays.
#pragma once
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "reference/ray_scene.h"

namespace sward {

inline Triangles quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    return {{a, b, c, d}, {0, 1, 2, 0, 2, 3}};
}
inline RayScene sceneOf(std::vector<Triangles> meshes) {
    auto made = RayScene::make(meshes);
    EXPECT_TRUE(made);
    return std::move(*made);
}

}  // namespace sward
