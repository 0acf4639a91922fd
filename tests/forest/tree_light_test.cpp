// What leaves leave of the light from all around at a tree's own vertices, and how full the wood stands around it.
#include "forest/tree_light.h"

#include <gtest/gtest.h>

#include "air.h"

namespace sward {
namespace {

using test::evenAir;

Mesh pointAt(const glm::vec3& place, const glm::vec3& normal) {
    Mesh m;
    m.vertices = {{place, normal, {}}};
    return m;
}
VertexShares sharesAt(const glm::vec3& place, const glm::vec3& normal, float extinction, const WoodAir& wood = {},
                      double verticalScale = 1) {
    return lightOnTree(pointAt(place, normal), evenAir(extinction), wood, verticalScale)[0];
}

TEST(TreeLight, InEvenAirIsWhatBeersLawLeaves) {
    // By a million ways, cosine-weighted, from 5 m up the middle of the block.
    constexpr float kExtinction = 0.5f;
    double above = 0, all = 0;
    for (int k = 0; k < 1000; ++k)
        for (int j = 0; j < 1000; ++j) {
            const double y = (k + 0.5) / 1000, a = 2 * M_PI * (j + 0.5) / 1000, r = std::sqrt(1 - y * y);
            const double out =
                std::min(2 / std::max({std::abs(r * std::cos(a)), std::abs(r * std::sin(a)), 1e-9}), 5 / y);
            above += y * std::exp(-static_cast<double>(kExtinction) * out), all += y;
        }
    const VertexShares s = sharesAt({0, 5, 0}, {0, 1, 0}, kExtinction);
    std::printf("share from above: %.3f, by Beer's law %.3f\n", s.alone[0] / 255.0, above / all);
    EXPECT_NEAR(s.alone[0] / 255.0, above / all, 0.01);
    EXPECT_EQ(s.alone[1], 255) << "none of it comes from below, so that it is as in the open";
    EXPECT_EQ(s.among[0], s.alone[0]) << "where no other tree stands";
    EXPECT_EQ(s.among[3], s.among[0]) << "of the ground it sees as much as of the sky";
}

TEST(TreeLight, IsLessDeepInTheCrownAndOnTheSideThatLooksInwards) {
    const VertexShares edge = sharesAt({1.9f, 5, 0}, {1, 0, 0}, 1), middle = sharesAt({0, 5, 0}, {1, 0, 0}, 1);
    EXPECT_GT(edge.alone[0], 2 * middle.alone[0]);
    EXPECT_GT(edge.alone[0], 2 * edge.alone[2]) << "outwards against inwards";
    EXPECT_EQ(sharesAt({5, 9, 0}, {1, 0, 0}, 1).alone[0], 255) << "beside it, looking away";
    EXPECT_EQ(sharesAt({0, 5, 0}, {1, 0, 0}, 0).alone, glm::u8vec4(255, 255, 255, 255)) << "air without leaves";
}

TEST(TreeLight, TheGroundAtItsFootIsInItsShade) {
    const float clear = 0.05f;
    EXPECT_LT(sharesAt({0, 0.1f, 0}, {0, -1, 0}, clear).alone[1], sharesAt({0, 0.1f, 0}, {0, -1, 0}, clear).among[1])
        << "the wood's shade on the ground is not in it";
}

// Trees like the block, so many in each of eight tiles, of 16 m.
ForestTiles tilesOf(size_t each) {
    ForestTiles t;
    t.inside.resize(4);
    for (auto& cell : t.inside)
        for (auto& tile : cell) tile.resize(each);
    t.asked = t.placed = 8.0 * static_cast<double>(each);
    t.highest = 10;
    return t;
}

TEST(TreeLight, AWoodHoldsTheLeavesOfItsTrees) {
    const std::vector<TreeAir> airs = {evenAir(0.3f)};
    const WoodAir wood = woodAir(tilesOf(3), 400, airs);
    EXPECT_NEAR(wood.between(0, 20), 0.3 * 4 * 4 * 10 * 400 / 10000, 1e-6) << "m² of leaves on a m²";
    EXPECT_NEAR(wood.between(2, 7), 0.5 * wood.between(0, 20), 1e-6);
    EXPECT_EQ(wood.between(12, 20), 0);
    EXPECT_EQ(woodAir({}, 400, airs).between(0, 20), 0) << "without trees";
    const VertexShares low = sharesAt({0, 3, 0}, {1, 0, 0}, 0.3f, wood),
                       high = sharesAt({0, 9.9f, 0}, {1, 0, 0}, 0.3f, wood);
    EXPECT_LT(low.among[0], 0.5 * low.alone[0]) << "others hide the low sky";
    EXPECT_GT(high.among[0], 0.9 * high.alone[0]) << "hardly at the top";
}

// Ways from the middle of a block that is higher leave it through its sides, past fewer leaves.
TEST(TreeLight, StretchedTreesAreAskedAlongWaysThatAreStretched) {
    const auto above = [](double verticalScale) {
        return sharesAt({0, 5, 0}, {0, 1, 0}, 0.3f, {}, verticalScale).alone[0];
    };
    EXPECT_LT(above(0.5), above(1) - 10);
    EXPECT_GT(above(3), above(1) + 10);
}

TEST(TreeLight, AWoodIsFullInItsMiddleAndLeansAtItsEdge) {
    StandingForest f;
    f.tiles = tilesOf(3);
    constexpr double kApart = 2;
    for (int z = -40; z <= 40; ++z)
        for (int x = -40; x <= 0; ++x) f.trees.push_back({{kApart * x, 0, kApart * z}});
    const auto at = [&](double x, double z) {
        for (size_t i = 0; i < f.trees.size(); ++i)
            if (f.trees[i].at.x == x && f.trees[i].at.z == z) return woodAround(f, 10000 / (kApart * kApart))[i];
        return glm::vec3(-1);
    };
    const glm::vec3 middle = at(-40, 0), edge = at(0, 0), corner = at(0, 80);
    EXPECT_NEAR(middle.x, 1, 0.15);
    EXPECT_NEAR(middle.y, 0, 1e-3);
    EXPECT_NEAR(edge.x, 0.5, 0.1);
    EXPECT_NEAR(edge.x - edge.y, middle.x, 0.15) << "the full side";
    EXPECT_NEAR(edge.x + edge.y, 0, 0.15) << "the open one";
    EXPECT_NEAR(corner.x, 0.25, 0.1);
    EXPECT_LT(corner.z, -0.2f);
    f.trees = {{{0, 0, 0}}};
    EXPECT_EQ(woodAround(f, 2500)[0], glm::vec3(0)) << "a tree alone";
    EXPECT_EQ(woodAround(f, 0)[0], glm::vec3(0));
}

}  // namespace
}  // namespace sward
