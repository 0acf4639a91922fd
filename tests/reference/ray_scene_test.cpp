// Rays against triangles.
#include "reference/ray_scene.h"

#include <gtest/gtest.h>

#include "tests/reference/ray_scenes.h"

namespace sward {
namespace {

TEST(RayScene, HitsWhatLiesAheadWithinReach) {
    const RayScene rays = sceneOf({quad({-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1})});
    EXPECT_TRUE(rays.hits({0, 0, 0}, {0, 1, 0}));
    EXPECT_TRUE(rays.hits({0, 2, 0}, {0, -1, 0})) << "from either side";
    EXPECT_FALSE(rays.hits({0, 0, 0}, {0, 1, 0}, 0.9f));
    EXPECT_FALSE(rays.hits({0, 0, 0}, {0, -1, 0}));
    EXPECT_FALSE(rays.hits({3, 0, 0}, {0, 1, 0}));
    EXPECT_FALSE(sceneOf({}).hits({0, 0, 0}, {0, 1, 0})) << "nothing is there";
}

TEST(RayScene, InstancesAreMetWhereTheyStand) {
    const Triangles floor = quad({-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1});
    TriangleInstances shown;
    shown.meshes = {floor};
    shown.placed = {{0, {10, 3, 0}, glm::mat3(2)}, {0, {20, 5, 0}, glm::mat3(1)}};
    auto made = RayScene::make({floor}, shown);
    ASSERT_TRUE(made);
    const auto down = [&](float x) { return made->closest({x, 10, 0}, {0, -1, 0}, 0, 100); };
    EXPECT_EQ(down(0)->mesh, 0u);
    EXPECT_EQ(down(11.9f)->mesh, 1u) << "twice as large";
    EXPECT_NEAR(down(11.9f)->t, 7, 1e-5f);
    EXPECT_EQ(down(20)->mesh, 2u);
    EXPECT_FALSE(down(21.5f));
    EXPECT_TRUE(made->hits({20, 10, 0}, {0, -1, 0}));
}

}  // namespace
}  // namespace sward
