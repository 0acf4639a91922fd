// Rays against triangles.
#include "reference/ray_scene.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

Triangles quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    return {{a, b, c, d}, {0, 1, 2, 0, 2, 3}};
}
RayScene sceneOf(std::vector<Triangles> meshes) {
    auto made = RayScene::make(meshes);
    EXPECT_TRUE(made);
    return std::move(*made);
}

TEST(RayScene, HitsWhatLiesAheadWithinReach) {
    const RayScene rays = sceneOf({quad({-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1})});
    EXPECT_TRUE(rays.hits({0, 0, 0}, {0, 1, 0}));
    EXPECT_TRUE(rays.hits({0, 2, 0}, {0, -1, 0})) << "from either side";
    EXPECT_FALSE(rays.hits({0, 0, 0}, {0, 1, 0}, 0.9f));
    EXPECT_FALSE(rays.hits({0, 0, 0}, {0, -1, 0}));
    EXPECT_FALSE(rays.hits({3, 0, 0}, {0, 1, 0}));
    EXPECT_FALSE(sceneOf({}).hits({0, 0, 0}, {0, 1, 0})) << "nothing is there";
}

}  // namespace
}  // namespace sward
