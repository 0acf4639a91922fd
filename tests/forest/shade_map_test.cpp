// Shade of trees on the ground: where the tree stands between it and the sun, as deep as its air is, shifted by slopes.
#include "forest/shade_map.h"

#include <gtest/gtest.h>

#include "air.h"

namespace sward {
namespace {

using test::evenAir;

TEST(ShadeMap, FollowsBeersLawBelowATree) {
    const TreeShade s = shadeTowards(evenAir(0.2f), {0, 1, 0});
    EXPECT_NEAR(s.at({0, 0}), 2, 0.05) << "10 m of 0.2";
    EXPECT_EQ(s.at({3, 0}), 0);
    const double c = std::sqrt(0.5);
    const TreeShade low = shadeTowards(evenAir(0.2f), {c, c, 0});
    EXPECT_NEAR(low.at({-5, 0}), 0.2 * 4 / c, 0.15) << "straight through the block's width";
    EXPECT_EQ(low.at({5, 0}), 0) << "on the sun's side";
}

TEST(ShadeMap, ALowSunThrowsNoEndlessShade) {
    const TreeShade s = shadeTowards(evenAir(0.2f), glm::normalize(glm::dvec3(1, 1e-9, 0)));
    EXPECT_LT(s.size.x, 220);
    for (const float d : s.depth) EXPECT_TRUE(std::isfinite(d));
}

TEST(ShadeMap, TheSkyIsHiddenMostAtTheFoot) {
    const TreeShade s = shadeOfSky(evenAir(1));
    EXPECT_GT(s.at({0, 0}), s.at({4, 0}));
    EXPECT_GT(s.at({4, 0}), s.at({8, 0}));
    EXPECT_GT(s.at({4, 0}), 0.05f);
    EXPECT_EQ(s.at({40, 0}), 0);
}

struct Wood {
    Terrain terrain;
    StandingForest forest;
    Wood() {
        terrain.size = {100, 60};
        forest.trees = {{{30, 0, 30}, 0, 1, 0, {}, 0}};
    }
    ShadeMap map(const glm::dvec3& sun) const {
        ShadeSum sum(terrain, {0, 0, 0}, sun);
        sum.add(forest, {evenAir(0.2f)});
        return sum.map();
    }
    static uint8_t at(const ShadeMap& m, double x, double z, size_t channel = 0) {
        return m.shares[3 * static_cast<size_t>(static_cast<int>(z / 60 * m.size.y) * m.size.x +
                                                static_cast<int>(x / 100 * m.size.x)) +
                        channel];
    }
};

TEST(ShadeMap, IsOpenWhereNoTreeStands) {
    const ShadeMap m = Wood().map(glm::normalize(glm::dvec3(1, 1, 0)));
    EXPECT_EQ(m.size, glm::ivec2(200, 120));
    EXPECT_LT(Wood::at(m, 25, 30), 140) << "behind the tree";
    EXPECT_EQ(Wood::at(m, 38, 30), 255) << "before it";
    EXPECT_EQ(Wood::at(m, 80, 10), 255);
    EXPECT_EQ(Wood::at(m, 80, 10, 1), 255);
    EXPECT_LT(Wood::at(m, 30, 30, 1), 200);
}

TEST(ShadeMap, GroundThatRisesCutsTheShadeShort) {
    Wood w;
    Map m({64, 64, 1, PixelType::F32});
    // It rises away from the sun, 1 m a metre: the shade of a sun at 45 degrees is half as long.
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 64; ++x) m.set(x, z, 0, 100 * (1 - (static_cast<float>(x) + 0.5f) / 64));
    w.terrain.height = {"h", m};
    w.forest.trees[0].at.y = 70;
    const ShadeMap slope = w.map(glm::normalize(glm::dvec3(1, 1, 0))),
                   flat = Wood().map(glm::normalize(glm::dvec3(1, 1, 0)));
    EXPECT_LT(Wood::at(flat, 21, 30), 200);
    EXPECT_EQ(Wood::at(slope, 21, 30), 255) << "9 m up it lies in the sun";
    EXPECT_LT(Wood::at(slope, 27, 30), 200);
}

TEST(ShadeMap, DepthsOfSeveralTreesAddUp) {
    Wood w;
    const double one = Wood::at(w.map({0, 1, 0}), 30, 30) / 255.0;
    w.forest.trees.push_back(w.forest.trees[0]);
    EXPECT_NEAR(Wood::at(w.map({0, 1, 0}), 30, 30) / 255.0, one * one, 0.02);
}

TEST(ShadeMap, TheAirOfAMeshHoldsHalfItsLeavesArea) {
    Mesh mesh;
    mesh.vertices = {{{-1, 2, -1}, {0, 1, 0}, {}}, {{1, 2, -1}, {0, 1, 0}, {}}, {{1, 2, 1}, {0, 1, 0}, {}}};
    mesh.indices = {0, 1, 2};
    mesh.parts = {{0, 3, {0.5f, 0.5f, 0.5f}, -1, 0}};
    mesh.low = {-1, 0, -1}, mesh.high = {1, 2, 1};
    const TreeAir a = treeAir(mesh);
    double sum = 0;
    for (const float e : a.extinction) sum += double(e) * std::pow(a.part, 3);
    EXPECT_NEAR(sum, 0.5 * 2, 1e-3);
    EXPECT_EQ(treeAir({}).side, 0);
}

}  // namespace
}  // namespace sward
