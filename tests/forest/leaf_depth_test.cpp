// Leaves in clumps lie deeper than the middle of the part that holds them, and more of those that are seen from a side
// are lit from there; in even air neither is so.
#include "forest/leaf_depth.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/numerics.h"

namespace sward {
namespace {

constexpr int kFiner = 4;

ForestAir airOf(int side, int layers) {
    ForestAir a{side, layers, 16, 8, {}, 1};
    a.extinction.assign(static_cast<size_t>(side * side * layers), 0);
    return a;
}
// The mean of a fine air's parts over each part of a coarse one.
ForestAir coarser(const ForestAir& fine) {
    ForestAir a = airOf(fine.side / kFiner, fine.layers / kFiner);
    for (int l = 0; l < fine.layers; ++l)
        for (int y = 0; y < fine.side; ++y)
            for (int x = 0; x < fine.side; ++x)
                a.extinction[static_cast<size_t>((l / kFiner * a.side + y / kFiner) * a.side + x / kFiner)] +=
                    fine.extinction[static_cast<size_t>((l * fine.side + y) * fine.side + x)] /
                    (kFiner * kFiner * kFiner);
    return a;
}
float meanOf(const std::vector<float>& v) {
    return std::accumulate(v.begin(), v.end(), 0.0f) / static_cast<float>(v.size());
}

TEST(LeafDepth, AlongAWayIsTheExtinctionTimesTheMetres) {
    ForestAir air = airOf(16, 32);
    air.extinction.assign(air.extinction.size(), 0.3f);
    EXPECT_NEAR(depthAlong(air, {0.3, 0.7}, 2, {0.6, 0.8, 0}, 4), 0.3 * 4, 0.05);
    EXPECT_NEAR(depthAlong(air, {0.3, 0.7}, 2, {0, 1, 0}, 1e9), 0.3 * 6, 0.05) << "nothing lies above the air";
    EXPECT_EQ(depthAlong(air, {0.3, 0.7}, 9, {0, 1, 0}, 4), 0);
    air.extinction.assign(air.extinction.size(), 1e6f);
    EXPECT_EQ(depthAlong(air, {0.3, 0.7}, 2, {0, 1, 0}, 4), kMostLeafDepth);
}

TEST(LeafDepth, OfLeavesInEvenAirIsThatOfTheMiddle) {
    ForestAir fine = airOf(32, 32);
    fine.extinction.assign(fine.extinction.size(), 0.4f);
    const ForestAir air = coarser(fine);
    const LeafDepths d = leafDepths(fine, air);
    ASSERT_EQ(d.deeper.size(), air.extinction.size());
    // Below the uppermost parts, from where ways leave the air.
    const std::vector<float> below(d.deeper.begin(), d.deeper.begin() + 8 * 8 * 4);
    for (const float x : below) EXPECT_NEAR(x, 0, 0.03f);
    EXPECT_LT(d.litSeen, 0.05f);
}

TEST(LeafDepth, OfLeavesInClumpsIsGreaterAndThoseSeenAreLit) {
    ForestAir fine = airOf(32, 32);
    for (int l = 0; l < 32; ++l)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                if (x % 4 < 2 && y % 4 < 2 && l % 4 < 2)
                    fine.extinction[static_cast<size_t>((l * 32 + y) * 32 + x)] = 3.2f;
    const LeafDepths d = leafDepths(fine, coarser(fine));
    EXPECT_GT(meanOf(d.deeper), 0.1f);
    EXPECT_GT(d.litSeen, 0.02f);
}

TEST(LeafDepth, PartsWithoutLeavesHaveTheirNeighbours) {
    ForestAir fine = airOf(32, 32);
    const auto at = [](int x, int y, int l) { return static_cast<size_t>((l * 32 + y) * 32 + x); };
    for (int l = 8; l < 10; ++l)
        for (int y = 8; y < 10; ++y)
            for (int x = 0; x < 2; ++x) fine.extinction[at(x, y, l)] = 8;
    const std::vector<float> deeper = leafDepths(fine, coarser(fine)).deeper;
    const auto part = [&](int x, int y, int l) { return deeper[static_cast<size_t>((l * 8 + y) * 8 + x)]; };
    EXPECT_GT(part(0, 2, 2), 0.05f);
    EXPECT_EQ(part(1, 2, 2), part(0, 2, 2));
    EXPECT_EQ(part(7, 2, 2), part(0, 2, 2)) << "the cells repeat";
    EXPECT_EQ(part(4, 2, 2), 0);
}

TEST(LeafDepth, LitLeavesOfAGrownTreeFaceTheLight) {
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch}) {
        const Mesh tree = growTree({.kind = kind});
        const float faces = litFacing(tree, treeAir(tree));
        EXPECT_GT(faces, 1.0f);
        EXPECT_LT(faces, 1.3f);
    }
    EXPECT_EQ(litFacing(Mesh{}, treeAir(Mesh{})), 1);
}

}  // namespace
}  // namespace sward
