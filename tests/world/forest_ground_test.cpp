// The ground under a forest's tiles: where it lies, which of it is a cliff, and how many tiles lie on such.
#include "world/forest_ground.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

// Rises by a step (m) in the middle of 160 m.
Terrain stepped(float step) {
    Terrain t;
    t.size = {160, 160};
    Map m({64, 64, 1, PixelType::F32});
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 64; ++x) m.set(x, z, 0, x < 32 ? 0.0f : step);
    t.height = {"maps/height.exr", m};
    return t;
}
Forest forestEverywhere() {
    Forest f;
    f.slopeDeg = {0, 90};
    return f;
}
ForestCount countOn(float step) {
    Project p;
    const Entity land = *addEntity(p, "land"), trees = *addEntity(p, "trees");
    p.registry.add<Terrain>(land, stepped(step));
    p.registry.add<Forest>(trees, forestEverywhere());
    const std::vector<ForestCount> all = countForests(p);
    EXPECT_EQ(all.size(), 1u);
    return all.at(0);
}

TEST(ForestGround, CornersLieOnTheTerrainWhereTheLatticeHasThem) {
    const Terrain t = stepped(30);
    const Forest rule = forestEverywhere();
    const glm::dvec3 origin(1000, 5, -2000);
    const StandingForest f = standingForest(rule, {&t, origin});
    ASSERT_GT(f.triangles.size(), 100u);
    for (const ForestTriangle& tri : f.triangles) {
        const std::array<glm::dvec3, 3> g = groundUnder(f, tri, t);
        for (size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(g[k].y, origin.y + terrainHeight(t, g[k].x - origin.x, g[k].z - origin.z), 1e-9);
            const glm::dvec3 side = g[(k + 1) % 3] - g[k];
            EXPECT_NEAR(std::hypot(side.x, side.z), f.tiles.edge, 1e-6);
        }
    }
}

TEST(ForestGround, CliffsAndTrianglesWithoutAreaCarryNoVolume) {
    EXPECT_TRUE(mayStandOver({glm::dvec3(0, 0, 0), {16, 0, 0}, {8, 0, 14}}));
    EXPECT_TRUE(mayStandOver({glm::dvec3(0, 0, 0), {16, 100, 0}, {8, 0, 14}})) << "81 degrees";
    EXPECT_FALSE(mayStandOver({glm::dvec3(0, 0, 0), {16, 1000, 0}, {8, 0, 14}})) << "89 degrees";
    EXPECT_FALSE(mayStandOver({glm::dvec3(0, 0, 0), {0, 16, 0}, {0, 0, 14}})) << "upright";
    EXPECT_FALSE(mayStandOver({glm::dvec3(3, 1, 2), {3, 1, 2}, {3, 1, 2}}));
    EXPECT_FALSE(mayStandOver({glm::dvec3(0, 0, 0), {16, 0, 0}, {32, 0, 0}}));
}

TEST(ForestGround, CountsTreesTilesAndThoseOnCliffs) {
    const ForestCount flat = countOn(0), steep = countOn(5000);
    EXPECT_EQ(flat.entity, "trees");
    EXPECT_EQ(flat.technique, "texcells");
    EXPECT_GT(flat.trees, 500u);
    EXPECT_GT(flat.tiles, 150u);
    EXPECT_EQ(flat.cliffs, 0u);
    EXPECT_EQ(steep.tiles, flat.tiles);
    EXPECT_GE(steep.cliffs, 8u) << "those across the step";
    EXPECT_LT(steep.cliffs, flat.tiles / 3);
    EXPECT_TRUE(countForests(Project()).empty());
}

}  // namespace
}  // namespace sward
