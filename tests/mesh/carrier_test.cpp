// Meshes as carriers of grass: frames, curvature, walls, and what is mended or left out.
#include "mesh/carrier.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/mesh_shapes.h"

namespace sward {
namespace {

Mesh meshOfSolid(const Solid& solid) { return makeMesh({&solid, 1}); }
Mesh triangle(std::array<glm::vec3, 3> at, std::array<glm::vec2, 3> uv) {
    Mesh m;
    const glm::vec3 n = glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]));
    for (size_t k = 0; k < 3; ++k) m.vertices.push_back({at[k], n, uv[k]});
    m.indices = {0, 1, 2};
    m.parts = {{0, 3}};
    return m;
}

TEST(Carrier, FramesAreSquareForEveryNormal) {
    std::mt19937 random(3);
    std::normal_distribution<float> bell;
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        glm::vec3 n = glm::normalize(glm::vec3(bell(random), bell(random), bell(random)));
        if (i < 6) n = glm::vec3(0), n[i / 2] = i % 2 ? 1.0f : -1.0f;
        // Without directions of its own: texture coordinates that say nothing at this vertex.
        Mesh m = triangle({glm::vec3(0), {0, 0, 1}, {1, 0, 0}}, {glm::vec2(0), {0, 1}, {1, 0}});
        for (MeshVertex& v : m.vertices) v.normal = n;
        for (const CarrierVertex& v : carrierOf(m).vertices) {
            const CarrierFrame f = carrierFrame(v.normal, v.alongU, v.alongV);
            for (const float off : {glm::dot(f.tangent, n), glm::dot(f.bitangent, n), glm::dot(f.tangent, f.bitangent),
                                    glm::length(f.tangent) - 1, glm::length(f.bitangent) - 1})
                worst = std::max(worst, std::abs(static_cast<double>(off)));
        }
    }
    EXPECT_LT(worst, 1e-6);
}

TEST(Carrier, ABallBendsAsItsRadiusSaysInEveryDirection) {
    const float radius = 0.5f;
    const MeshCarrier c = carrierOf(meshOfSolid({.kind = SolidKind::Ball, .size = glm::vec3(radius), .unwrap = true}));
    EXPECT_NEAR(c.area, 4 * 3.14159265 * 0.25, 0.02 * 3.14);
    EXPECT_EQ(c.unmapped + c.mirrored, 0u);
    // A mean over four edges of 7.5 degrees is taken over surroundings that turn away, and so is 3% less than what it
    // is of; normals, means of the faces around, are least sure where three charts meet (0.94).
    double mean = 0;
    for (const CarrierVertex& v : c.vertices) {
        EXPECT_NEAR(v.bend.x * radius, 0.97, 0.035);
        EXPECT_NEAR(v.bend.y * radius, 0, 0.035);
        EXPECT_NEAR(v.bend.z * radius, 0.97, 0.035);
        mean += static_cast<double>(v.bend.x + v.bend.z) / (2 * static_cast<double>(c.vertices.size()));
    }
    EXPECT_NEAR(mean * static_cast<double>(radius), 0.97, 0.005);
    EXPECT_EQ(c.indices.size(), c.surface) << "a ball goes on everywhere, also over the seams of its charts";
}

TEST(Carrier, ABoxIsFlatAndEveryEdgeHasAWallOnBothSides) {
    const MeshCarrier c = carrierOf(meshOfSolid({.size = {1, 2, 3}, .unwrap = true}));
    EXPECT_NEAR(c.area, 22, 1e-4);
    for (const CarrierVertex& v : c.vertices) EXPECT_LT(glm::length(v.bend), 1e-5);
    EXPECT_EQ(c.surface, 36u);
    EXPECT_EQ(c.indices.size() - c.surface, 6u * 4 * 6) << "two triangles for each side of each face";
    for (size_t i = c.surface; i < c.indices.size(); i += 3) {
        const auto lifted = [&](size_t k) {
            const CarrierVertex& v = c.vertices[c.indices[i + k]];
            return v.position + v.normal * v.lift;
        };
        const glm::vec3 out = glm::cross(lifted(1) - lifted(0), lifted(2) - lifted(0));
        const glm::vec3 middle = c.vertices[c.indices[i]].position + c.vertices[c.indices[i + 1]].position +
                                 c.vertices[c.indices[i + 2]].position;
        EXPECT_GT(glm::dot(out, middle - glm::vec3(0, 3, 0)), 0) << "a wall looks away from its face's middle";
    }
    // One unit of texture coordinates is three charts of the longest side.
    EXPECT_NEAR(lengthOfUv(c), 3 * 3 / 0.96, 1e-3);
}

TEST(Carrier, DirectionsFollowTextureCoordinatesAndMirroredOnesAreSplit) {
    const std::array<glm::vec3, 3> at = {glm::vec3(0), {0, 0, 2}, {4, 0, 0}};  // looks up
    const MeshCarrier plain = carrierOf(triangle(at, {glm::vec2(0), {0, 1}, {1, 0}}));
    ASSERT_EQ(plain.surface, 3u);
    EXPECT_EQ(plain.mirrored, 0u);
    EXPECT_NEAR(glm::length(plain.vertices[0].alongU - glm::vec3(0.25f, 0, 0)), 0, 1e-6);
    EXPECT_NEAR(glm::length(plain.vertices[0].alongV - glm::vec3(0, 0, 0.5f)), 0, 1e-6);
    const MeshCarrier other = carrierOf(triangle(at, {glm::vec2(0), {1, 0}, {0, 1}}));
    EXPECT_EQ(other.mirrored, 1u);

    // Two triangles that share an edge, the second with the first's coordinates turned back.
    Mesh folded = triangle(at, {glm::vec2(0), {0, 1}, {1, 0}});
    folded.vertices.push_back({{4, 0, 2}, {0, 1, 0}, {0, 0}});
    folded.indices = {0, 1, 2, 3, 2, 1};
    const MeshCarrier both = carrierOf(folded);
    EXPECT_EQ(both.mirrored, 1u);
    for (const CarrierVertex& v : both.vertices)
        if (v.lift == 1) EXPECT_GT(glm::length(v.alongU), 0.2f) << "what they share is no mean of both";
}

TEST(Carrier, AChartReachesAsFarAsItsTextureCoordinatesHangTogether) {
    const MeshCarrier c = carrierOf(meshOfSolid({.kind = SolidKind::Ball, .unwrap = true}));
    for (const CarrierVertex& v : c.vertices) {
        const glm::vec2 chart = glm::floor(v.uv * 3.0f);
        EXPECT_NEAR(v.chart.x, (chart.x + 0.02f) / 3, 1e-5);
        EXPECT_NEAR(v.chart.y, (chart.y + 0.02f) / 3, 1e-5);
        EXPECT_NEAR(v.chart.z, (chart.x + 0.98f) / 3, 1e-5);
        EXPECT_NEAR(v.chart.w, (chart.y + 0.98f) / 3, 1e-5);
    }
}

TEST(Carrier, FindsTheNearestOfTheSurfaceFromAnywhere) {
    const MeshCarrier c =
        carrierOf(meshOfSolid({.kind = SolidKind::Ball, .size = {0.7f, 0.4f, 0.5f}, .rough = 0.3f, .unwrap = true}));
    ASSERT_GT(c.boxes.size(), 4u);
    std::mt19937 random(11);
    std::uniform_real_distribution<float> unit(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 p(unit(random), unit(random), unit(random));
        const CarrierVertex found = nearestOn(c, p);
        // No place of the surface, by a grid over each triangle, lies nearer.
        float least = INFINITY;
        for (size_t k = 0; k < c.surface; k += 3)
            for (int a = 0; a <= 4; ++a)
                for (int b = 0; a + b <= 4; ++b) {
                    const float u = 0.25f * static_cast<float>(a), v = 0.25f * static_cast<float>(b);
                    const glm::vec3 at = c.vertices[c.indices[k]].position * (1 - u - v) +
                                         c.vertices[c.indices[k + 1]].position * u +
                                         c.vertices[c.indices[k + 2]].position * v;
                    least = std::min(least, glm::length(at - p));
                }
        const float distance = glm::length(found.position - p);
        EXPECT_LE(distance, least + 1e-6f);
        EXPECT_GT(distance, least - 0.02f);
        EXPECT_NEAR(glm::length(found.normal), 1, 1e-5);
    }
}

TEST(Carrier, PartsGoOnOverSeamsAndEndAtEdges) {
    const MeshCarrier ball = carrierOf(meshOfSolid({.kind = SolidKind::Ball, .size = glm::vec3(0.5f), .unwrap = true}));
    EXPECT_EQ(ball.parts, 1u) << "six charts, one surface";
    for (const CarrierVertex& v : ball.vertices) ASSERT_EQ(v.part, 1) << "without an edge";
    const MeshCarrier box = carrierOf(meshOfSolid({.size = glm::vec3(1), .unwrap = true}));
    EXPECT_EQ(box.parts, 6u);
    for (const CarrierVertex& v : box.vertices) ASSERT_LT(v.part, 0) << "each face ends at its edges";
}

TEST(Carrier, WhatHasNoAreaCarriesNothing) {
    const std::array<glm::vec3, 3> at = {glm::vec3(0), {0, 0, 1}, {1, 0, 0}};
    const MeshCarrier none = carrierOf(triangle(at, {glm::vec2(0.3f), glm::vec2(0.3f), glm::vec2(0.3f)}));
    EXPECT_EQ(none.surface, 0u);
    EXPECT_EQ(none.unmapped, 1u);
    EXPECT_EQ(lengthOfUv(none), 0);
    EXPECT_EQ(carrierOf(triangle(at, {glm::vec2(0), glm::vec2(1), glm::vec2(2)})).unmapped, 1u) << "a line";
    const MeshCarrier thin =
        carrierOf(triangle({glm::vec3(0), {1, 0, 0}, {2, 0, 1e-12f}}, {glm::vec2(0), {0, 1}, {1, 0}}));
    EXPECT_EQ(thin.surface, 0u);
    EXPECT_TRUE(carrierOf(Mesh{}).indices.empty());
}

}  // namespace
}  // namespace sward
