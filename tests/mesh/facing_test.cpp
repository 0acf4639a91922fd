// What a mesh shows of its area from a side: leaves and closed bodies by Cauchy's theorem, leaves in all directions by
// Lambert's law over a sphere, level leaves by their cosine.
#include "mesh/facing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics.h"
#include "mesh/tree_shapes.h"

namespace sward {
namespace {

Mesh meshOf(std::vector<glm::vec3> corners, std::vector<uint32_t> indices) {
    Mesh m;
    for (const glm::vec3& c : corners) m.vertices.push_back({c, {0, 1, 0}, {}});
    m.indices = std::move(indices);
    m.parts = {{0, static_cast<uint32_t>(m.indices.size())}};
    updateBounds(m);
    return m;
}
Mesh leaf() { return meshOf({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {0, 2, 1, 0, 3, 2}); }
// Of vertices that are its own at each face, as files have them.
Mesh box() {
    std::vector<glm::vec3> corners;
    std::vector<uint32_t> indices;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {0.0f, 1.0f}) {
            const uint32_t first = static_cast<uint32_t>(corners.size());
            for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
                glm::vec3 c(side);
                c[(axis + 1) % 3] = at.x, c[(axis + 2) % 3] = at.y;
                corners.push_back(c);
            }
            const bool out = side > 0;
            for (const uint32_t k : {0, out ? 1 : 2, out ? 2 : 1, 0, out ? 2 : 3, out ? 3 : 2})
                indices.push_back(first + k);
        }
    return meshOf(std::move(corners), std::move(indices));
}

TEST(Facing, ALeafCountsWholeAndAClosedBodyHalf) {
    for (const float s : leafShares(leaf())) EXPECT_FLOAT_EQ(s, 1);
    for (const float s : leafShares(box())) EXPECT_NEAR(s, 0.5f, 1e-6f);
}

TEST(Facing, TrunksOfGrownTreesCountHalfAndTheirLeavesWhole) {
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch}) {
        const Mesh tree = growTree({.kind = kind});
        const std::vector<float> shares = leafShares(tree);
        double bark = 0, leaves = 0;
        const size_t barkEnd = tree.parts[0].count / 3;
        for (size_t i = 0; i < shares.size(); ++i) (i < barkEnd ? bark : leaves) += static_cast<double>(shares[i]);
        EXPECT_NEAR(bark / static_cast<double>(barkEnd), 0.5, 0.05);
        EXPECT_GT(leaves / static_cast<double>(shares.size() - barkEnd), 0.95);
    }
}

TEST(Facing, LightShinesThroughLeavesAndThroughNothingThatIsClosed) {
    EXPECT_NEAR(leafPart(leaf()), 1, 1e-6f);
    EXPECT_NEAR(leafPart(box()), 0, 1e-6f);
    EXPECT_EQ(leafPart(Mesh{}), 0);
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch}) {
        const Mesh tree = growTree({.kind = kind});
        const std::vector<float> parts = leafParts(tree);
        ASSERT_EQ(parts.size(), tree.parts.size());
        EXPECT_LT(parts[0], 0.1f) << "bark";
        for (size_t i = 1; i < parts.size(); ++i) EXPECT_GT(parts[i], 0.9f) << "leaves";
        EXPECT_GT(leafPart(tree), parts[0]);
        EXPECT_LT(leafPart(tree), parts[1]);
    }
}

TEST(Facing, WhatShinesThroughIsWhatWouldBeSentBackFromTheOtherSide) {
    for (const float eye : {-0.7f, 0.1f, 0.9f})
        for (const float light : {0.2f, 0.8f})
            for (const float turn : {-1.0f, 0.0f, 1.0f}) {
                const float level = std::sqrt((1 - eye * eye) * (1 - light * light)),
                            cosine = eye * light + turn * level;
                const Facing even = evenFacing();
                EXPECT_NEAR(passedTo(even, light, eye, cosine), f32::foliagePhase(-cosine), 0.012f);
                EXPECT_NEAR(passedTo(even, light, eye, cosine), sentTo(even, -light, eye, -cosine), 1e-4f);
            }
}

TEST(Facing, LeavesInAllDirectionsLookAlikeFromEverywhere) {
    const Facing even = evenFacing();
    for (int i = -8; i <= 8; ++i) {
        const float eye = static_cast<float>(i) / 8;
        EXPECT_NEAR(seenFrom(even, eye), 1, 0.01f);
        EXPECT_NEAR(seenRise(even, eye), eye * 2 / 3, 0.01f);
        for (int k = -8; k <= 8; ++k) {
            const float light = static_cast<float>(k) / 8;
            const float across = std::sqrt((1 - eye * eye) * (1 - light * light));
            for (const float turn : {0.0f, 1.0f, 2.0f, 3.1f}) {
                const float cosine = eye * light + across * std::cos(turn);
                EXPECT_NEAR(sentTo(even, light, eye, cosine), f32::foliagePhase(cosine), 0.012f) << eye << " " << light;
            }
        }
    }
}

TEST(Facing, LevelLeavesAreSeenByTheirCosine) {
    const Facing level = facingOf(leaf());
    EXPECT_FLOAT_EQ(level.back(), 1);
    EXPECT_NEAR(seenFrom(level, 1), 2, 0.07f);
    EXPECT_LT(seenFrom(level, 0), 0.35f) << "a bin of normals is not one normal";
    EXPECT_NEAR(sentTo(level, 0.6f, 0.8f, 0.6f * 0.8f), 0.6f, 0.08f);
    EXPECT_LT(sentTo(level, 0.6f, -0.8f, -0.48f), 0.03f) << "from below their dark side is seen";
    EXPECT_GT(seenRise(level, 0.7f), 0.9f);
    EXPECT_LT(seenRise(level, -0.7f), -0.9f);
}

TEST(Facing, WithoutAreaItIsEven) { EXPECT_EQ(facingOf(meshOf({{1, 1, 1}}, {0, 0, 0})), evenFacing()); }

TEST(Facing, OddDirectionsGiveFiniteShares) {
    for (const float light : {-1.0f, 0.0f, 1.0f})
        for (const float eye : {-1.0f, 0.0f, 1.0f})
            for (const float cosine : {-1.0f, 0.0f, 1.0f}) {
                const float s = sentTo(evenFacing(), light, eye, cosine);
                EXPECT_TRUE(s >= 0 && s <= 1) << light << " " << eye << " " << cosine;
            }
}

}  // namespace
}  // namespace sward
