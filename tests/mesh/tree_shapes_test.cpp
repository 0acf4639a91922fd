// Grown trees: the same from the same numbers, within their bounds, and with as many leaves as were asked for; thinned
// ones keep their leaves' area.
#include "mesh/tree_shapes.h"

#include <gtest/gtest.h>

#include "mesh/mesh_io.h"

namespace sward {
namespace {

double areaOf(const Mesh& m, size_t fromPart) {
    double sum = 0;
    for (size_t k = fromPart; k < m.parts.size(); ++k)
        for (uint32_t i = m.parts[k].first; i < m.parts[k].first + m.parts[k].count; i += 3) {
            const auto at = [&](uint32_t n) { return glm::dvec3(m.vertices[m.indices[i + n]].position); };
            sum += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
        }
    return sum;
}

TEST(TreeShapes, StayWithinTheirCrownAndHeight) {
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch})
        for (const float height : {0.5f, 12.0f, 60.0f}) {
            const TreeShape shape{.kind = kind, .height = height, .crown = 0.4f};
            const Mesh m = growTree(shape);
            const float reach = 0.5f * shape.crown * height * 1.0001f;
            for (const MeshVertex& v : m.vertices) {
                EXPECT_LE(std::hypot(v.position.x, v.position.z), reach);
                EXPECT_GE(v.position.y, 0);
                EXPECT_LE(v.position.y, height);
                EXPECT_NEAR(glm::length(v.normal), 1, 1e-4);
            }
            EXPECT_GT(m.high.y, 0.85f * height) << "it is as tall as it says";
            EXPECT_GT(m.high.x - m.low.x, 1.2f * reach) << "and its crown as wide";
        }
}

TEST(TreeShapes, HaveTheLeavesThatAreAskedFor) {
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch})
        for (const int leaves : {200, 2400, 20000}) {
            const Mesh m = growTree({.kind = kind, .leaves = leaves});
            size_t triangles = 0;
            for (size_t k = 1; k < m.parts.size(); ++k) triangles += m.parts[k].count / 3;
            EXPECT_NEAR(static_cast<double>(triangles), 2.0 * leaves, 0.02 * leaves);
        }
}

TEST(TreeShapes, AreTheSameFromTheSameNumbersAndOthersFromOthers) {
    const auto bytes = [](const Mesh& m) {
        return std::string(reinterpret_cast<const char*>(m.vertices.data()), m.vertices.size() * sizeof(MeshVertex));
    };
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch}) {
        EXPECT_EQ(bytes(growTree({.kind = kind, .seed = 7})), bytes(growTree({.kind = kind, .seed = 7})));
        EXPECT_NE(bytes(growTree({.kind = kind, .seed = 7})), bytes(growTree({.kind = kind, .seed = 8})));
    }
}

TEST(TreeShapes, CanBeWrittenAndReadAgain) {
    const Mesh m = growTree({});
    const Result<std::string> glb = encodeGlb(m);
    ASSERT_TRUE(glb) << glb.error().text();
    const Result<Mesh> back = readMeshBytes(*glb, ".", "tree.glb");
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->indices.size(), m.indices.size());
    EXPECT_EQ(back->parts.size(), m.parts.size());
}

TEST(TreeShapes, ThinnedKeepTheirLeavesArea) {
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch}) {
        const Mesh m = growTree({.kind = kind, .leaves = 6000});
        for (const float keep : {0.5f, 0.1f}) {
            const Mesh few = thinned(m, keep);
            const auto leaves = [](const Mesh& t) { return static_cast<double>(t.indices.size() - t.parts[0].count); };
            EXPECT_NEAR(leaves(few) / leaves(m), keep, 0.03);
            // Leaves differ in size, and those at the crown's edge are kept within it.
            EXPECT_NEAR(areaOf(few, 1) / areaOf(m, 1), 1, 0.12) << keep;
            EXPECT_EQ(few.parts[0].count, m.parts[0].count) << "the trunk and its branches stay";
            EXPECT_LE(few.high.y, m.high.y);
        }
        // A coarser one is a part of a finer one: nothing appears as one goes away.
        EXPECT_EQ(thinned(m, 1).indices, m.indices);
    }
}

// A cloud of small triangles, far from the edges of their bounds when they grow.
Mesh cloud() {
    Mesh m;
    for (uint32_t i = 0; i < 1000; ++i) {
        const glm::vec3 at =
            0.8f * glm::vec3(static_cast<float>(i % 10), static_cast<float>(i / 10 % 10), static_cast<float>(i / 100)) +
            1.0f;
        for (const glm::vec3& corner : {glm::vec3(0), glm::vec3(0.1f, 0, 0), glm::vec3(0, 0.1f, 0)}) {
            m.indices.push_back(static_cast<uint32_t>(m.vertices.size()));
            m.vertices.push_back(
                {i == 0 || i == 999 ? (i == 0 ? corner * 100.0f : glm::vec3(10) - corner * 100.0f) : at + corner,
                 {0, 0, 1},
                 {}});
        }
    }
    m.parts = {{0, 3000, glm::vec3(0.1f), -1, 0}};
    updateBounds(m);
    return m;
}

TEST(TreeShapes, ThinningIsNested) {
    const Mesh m = cloud(), some = thinned(m, 0.5f), few = thinned(m, 0.2f);
    const auto middles = [](const Mesh& t) {
        std::vector<glm::vec3> out;
        for (size_t i = 0; i < t.indices.size(); i += 3)
            out.push_back((t.vertices[t.indices[i]].position + t.vertices[t.indices[i + 1]].position +
                           t.vertices[t.indices[i + 2]].position) /
                          3.0f);
        return out;
    };
    const std::vector<glm::vec3> known = middles(some), kept = middles(few);
    EXPECT_GT(kept.size(), 150u);
    for (const glm::vec3& leaf : kept)
        EXPECT_TRUE(std::any_of(known.begin(), known.end(),
                                [&](const glm::vec3& k) { return glm::distance(k, leaf) < 1e-3f; }));
}

}  // namespace
}  // namespace sward
