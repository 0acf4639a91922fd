// Where meshes stand on the ground: known shapes, cuts, tilts, and what is not finite.
#include "mesh/footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "mesh/mesh_shapes.h"

namespace sward {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

// An L whose arms are 3 and 2 m long and 1 m wide; the notch is at x, z in [1, 3] x [1, 2].
Mesh letterL() {
    const Solid arms[] = {{.size = {3, 0.5f, 1}, .at = {1.5f, 0, 0.5f}}, {.size = {1, 0.5f, 2}, .at = {0.5f, 0, 1}}};
    return makeMesh(arms);
}
float distanceOf(const Footprint& f, float x, float z) { return outlineAt(f, {x, z}).x; }

// The distance to the union of the L's two rectangles, below 0 inside; exact outside, and inside where one rectangle
// alone is near.
float boxDistance(glm::vec2 p, glm::vec2 low, glm::vec2 high) {
    const glm::vec2 d = glm::max(low - p, p - high);
    return glm::length(glm::max(d, glm::vec2(0))) + std::min(std::max(d.x, d.y), 0.0f);
}
float exactL(glm::vec2 p) { return std::min(boxDistance(p, {0, 0}, {3, 1}), boxDistance(p, {0, 0}, {1, 2})); }

TEST(Footprint, OfAnLIsInsideItsArmsAndNotInTheNotch) {
    const Footprint f = makeFootprint(letterL(), glm::mat3(1), kInf);
    EXPECT_LT(distanceOf(f, 2.5f, 0.5f), -0.4f);
    EXPECT_LT(distanceOf(f, 0.5f, 1.5f), -0.4f);
    EXPECT_GT(distanceOf(f, 2, 1.5f), 0.4f) << "the notch";
    EXPECT_NEAR(distanceOf(f, 4, 0.5f), 1, 1.5f * f.texel);
    EXPECT_NEAR(f.texel, 3.0f / 128, 1e-6f);
}

TEST(Footprint, IsAsExactAsTheHeaderSays) {
    const Footprint f = makeFootprint(letterL(), glm::mat3(1), kInf);
    for (float z = -1.2f; z < 3.2f; z += 0.037f)
        for (float x = -1.4f; x < 4.4f; x += 0.037f) {
            const float exact = exactL({x, z});
            if (exact > 0) EXPECT_NEAR(distanceOf(f, x, z), exact, 1.5f * f.texel) << x << ' ' << z;
            if (exact < -1.5f * f.texel) EXPECT_LT(distanceOf(f, x, z), 0) << x << ' ' << z;
        }
}

TEST(Footprint, SlopesPointAwayFromTheEdge) {
    const Footprint f = makeFootprint(letterL(), glm::mat3(1), kInf);
    const auto slope = [&](float x, float z) { return glm::vec2(outlineAt(f, {x, z}).y, outlineAt(f, {x, z}).z); };
    EXPECT_LT(glm::distance(slope(3.5f, 0.5f), {1, 0}), 0.1f);
    EXPECT_LT(glm::distance(slope(1.5f, -0.3f), {0, -1}), 0.1f);
    EXPECT_LT(glm::distance(slope(2.5f, 1.4f), {0, 1}), 0.1f) << "in the notch: off the long arm";
    EXPECT_LT(glm::length(slope(0.5f, 1.3f)), 0.3f) << "midway between two edges there is no way out";
    EXPECT_LT(glm::distance(slope(20, 0.5f), {1, 0}), 0.1f) << "beyond the raster";
}

TEST(Footprint, OnlyWhatIsLowCounts) {
    // A table: a top of 2 x 1 m at a height of 0.7 m on four thin legs.
    std::vector<Solid> table = {{.size = {2, 0.05f, 1}, .at = {0, 0.7f, 0}}};
    for (const float x : {-0.9f, 0.9f})
        for (const float z : {-0.4f, 0.4f}) table.push_back({.size = {0.06f, 0.7f, 0.06f}, .at = {x, 0, z}});
    const Mesh mesh = makeMesh(table);
    const Footprint legs = makeFootprint(mesh, glm::mat3(1), 0.3f), all = makeFootprint(mesh, glm::mat3(1), kInf);
    EXPECT_LT(distanceOf(legs, 0.9f, 0.4f), 0);
    EXPECT_GT(distanceOf(legs, 0, 0), 0.5f) << "nothing presses between the legs";
    EXPECT_LT(distanceOf(all, 0, 0), -0.4f);
    EXPECT_TRUE(makeFootprint(mesh, glm::mat3(1), -0.01f).empty()) << "all of it is higher";
    EXPECT_TRUE(makeFootprint(Mesh{}, glm::mat3(1), kInf).empty());
}

TEST(Footprint, AThinSheetStandingUprightLeavesALine) {
    Mesh sheet;
    for (const glm::vec3& p : {glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(-1, 1, 0)})
        sheet.vertices.push_back({p, {0, 0, 1}, {0, 0}});
    sheet.indices = {0, 1, 2, 0, 2, 3};
    const Footprint f = makeFootprint(sheet, glm::mat3(1), 0.4f);
    ASSERT_FALSE(f.empty());
    EXPECT_LT(distanceOf(f, 0.3f, 0), f.texel);
    EXPECT_NEAR(distanceOf(f, 0.3f, 0.5f), 0.5f, 1.5f * f.texel);
}

TEST(Footprint, TurnsWithTheMesh) {
    const glm::mat3 lying(glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0),
                          glm::vec3(0, 0, 1));  // a quarter about z: x becomes up
    const Solid post{.size = {0.2f, 3, 0.2f}};
    const Footprint upright = makeFootprint(makeMesh({&post, 1}), glm::mat3(1), kInf),
                    fallen = makeFootprint(makeMesh({&post, 1}), lying, kInf);
    EXPECT_GT(distanceOf(upright, -1.5f, 0), 1.3f);
    EXPECT_LT(distanceOf(fallen, -1.5f, 0), 0);
    EXPECT_GT(distanceOf(fallen, 0.5f, 0), 0.4f);
}

TEST(Footprint, WhatIsNotFiniteIsLeftOut) {
    Mesh mesh = letterL();
    const size_t n = mesh.vertices.size();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float broken : {nan, kInf, -kInf}) mesh.vertices.push_back({{broken, 0, 0}, {0, 1, 0}, {0, 0}});
    for (uint32_t i = 0; i < 3; ++i) mesh.indices.insert(mesh.indices.end(), {static_cast<uint32_t>(n) + i, 0, 1});
    const Footprint f = makeFootprint(mesh, glm::mat3(1), kInf), sound = makeFootprint(letterL(), glm::mat3(1), kInf);
    EXPECT_EQ(f.distances, sound.distances);
    for (const float d : f.distances) ASSERT_TRUE(std::isfinite(d));
}

TEST(Footprint, APointHasOneToo) {
    Mesh point;
    for (int i = 0; i < 3; ++i) point.vertices.push_back({{5, 0, 5}, {0, 1, 0}, {0, 0}});
    point.indices = {0, 1, 2};
    const Footprint f = makeFootprint(point, glm::mat3(1), kInf);
    ASSERT_FALSE(f.empty());
    EXPECT_NEAR(distanceOf(f, 6, 5), 1, 0.01f);
}

}  // namespace
}  // namespace sward
