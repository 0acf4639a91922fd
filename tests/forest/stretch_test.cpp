// A forest that is stretched upwards: what leaves hide follows from the baked ones, as from a mesh that is stretched.
#include "forest/stretch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "forest/foliage.h"
#include "forest/shade_map.h"
#include "mesh/tree_shapes.h"

namespace sward {
namespace {

constexpr float kScales[] = {0.25f, 0.5f, 1.5f, 2, 4};

Mesh higher(Mesh mesh, float scale) {
    for (MeshVertex& v : mesh.vertices) v.position.y *= scale;
    updateBounds(mesh);
    return mesh;
}
// Calls body(normal as long as its counted area) for each triangle.
template <class F>
void eachTriangle(const Mesh& mesh, F body) {
    const std::vector<float> shares = leafShares(mesh);
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto at = [&](size_t k) { return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position); };
        body(0.5 * static_cast<double>(shares[i / 3]) * glm::cross(at(1) - at(0), at(2) - at(0)));
    }
}
double leafAreaOf(const Mesh& mesh) {
    double sum = 0;
    eachTriangle(mesh, [&](const glm::dvec3& n) { sum += glm::length(n); });
    return sum;
}
// Area that is covered towards a way, were nothing hidden, in the mean of turns about the upright.
double outlineOf(const Mesh& mesh, const glm::dvec3& way) {
    constexpr int kTurns = 32;
    const double across = std::hypot(way.x, way.z);
    double sum = 0;
    eachTriangle(mesh, [&](const glm::dvec3& n) {
        for (int k = 0; k < kTurns; ++k) {
            const double turn = 2 * 3.141592653589793 * (k + 0.5) / kTurns;
            sum += std::abs(glm::dot(n, {across * std::cos(turn), way.y, across * std::sin(turn)})) / kTurns;
        }
    });
    return sum;
}
glm::dvec3 towards(double elevationDeg) {
    const double e = glm::radians(elevationDeg);
    return {std::cos(e) * 0.8, std::sin(e), std::cos(e) * 0.6};
}

TEST(Stretch, AtOneNothingChangesToTheLastBit) {
    const glm::dvec3 way = glm::normalize(glm::dvec3(0.3, 0.7, -0.2));
    EXPECT_EQ(bakedWay(way, 1), way);
    const Facing birch = facingOf(growTree({.kind = TreeKind::Birch}));
    EXPECT_EQ(stretched(birch, 1), birch);
}

TEST(Stretch, WaysAreThoseThatAreStretchedToTheirs) {
    for (const float scale : kScales)
        for (const double elevation : {-90.0, -30.0, 0.0, 10.0, 60.0}) {
            const double by = static_cast<double>(scale);
            const glm::dvec3 way = towards(elevation), baked = bakedWay(way, by);
            EXPECT_NEAR(glm::length(baked), 1, 1e-12);
            EXPECT_LT(glm::distance(glm::normalize(baked * glm::dvec3(1, by, 1)), way), 1e-12);
        }
}

TEST(Stretch, LeavesFaceAsThoseOfAMeshThatIsStretched) {
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch}) {
        const Mesh tree = growTree({.kind = kind});
        for (const float scale : kScales) {
            const Facing ours = stretched(facingOf(tree), scale), mesh = facingOf(higher(tree, scale));
            float sum = 0;
            for (const float share : ours) sum += share;
            EXPECT_NEAR(sum, 1, 1e-5f);
            for (const float y : {0.0f, 0.4f, 0.8f, 1.0f})
                EXPECT_NEAR(seenFrom(ours, y) / seenFrom(mesh, y), 1, 0.03f) << scale << " from " << y;
        }
    }
}

// Depth along a metre of a way is the outline that a cubic metre's leaves have towards it. Along the baked way it is
// the same, over the length that the metre has there.
TEST(Stretch, DepthAlongTheBakedWayIsThatOfAMeshThatIsStretched) {
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Birch}) {
        const Mesh tree = growTree({.kind = kind});
        const Facing facing = facingOf(tree);
        for (const float scale : kScales) {
            const double by = static_cast<double>(scale);
            const Mesh tall = higher(tree, scale);
            const FoliageTable table(facing, {0, 1, 0}, scale);
            for (const double elevation : {-80.0, 0.0, 5.0, 35.0, 90.0}) {
                const glm::dvec3 way = towards(elevation);
                const double metre = glm::length(way / glm::dvec3(1, by, 1));
                const double seen = static_cast<double>(table.from(glm::vec3(way)).seen);
                const double ours = 0.5 * leafAreaOf(tree) * metre * seen, truth = outlineOf(tall, way) / by;
                EXPECT_NEAR(ours / truth, 1, 0.03) << scale << " at " << elevation;
            }
        }
    }
}

TEST(Stretch, TablesLightLeavesAsTheyFaceThen) {
    const Facing spruce = facingOf(growTree({.kind = TreeKind::Conifer})), drawn = stretched(spruce, 2);
    const glm::vec3 sun(towards(38));
    const FoliageTable table(spruce, sun, 2);
    for (const double elevation : {-40.0, 3.0, 70.0}) {
        const glm::vec3 way(towards(elevation));
        const FoliageLook look = table.from(way);
        EXPECT_NEAR(look.sky, 0.5f + 0.5f * seenRise(drawn, way.y), 0.01f);
        EXPECT_NEAR(look.sun, sentTo(drawn, sun.y, way.y, glm::dot(sun, way)), 0.02f);
        EXPECT_NEAR(look.passed, passedTo(drawn, sun.y, way.y, glm::dot(sun, way)), 0.02f);
    }
}

// An even block 4 m wide and 10 m high, of 0.2 a metre.
TreeAir block() {
    TreeAir a{8, 20, 0.5, 10, {}};
    a.extinction.assign(8 * 8 * 20, 0.2f);
    return a;
}

TEST(Stretch, ShadeIsAsDeepBelowAndReachesAsFarAsTheTreeIsHigh) {
    EXPECT_NEAR(shadeTowards(block(), {0, 1, 0}, 2).at({0, 0}), 2, 0.05) << "as many leaves lie above each other";
    const double c = std::sqrt(0.5);
    const TreeShade once = shadeTowards(block(), {c, c, 0}), twice = shadeTowards(block(), {c, c, 0}, 2),
                    half = shadeTowards(block(), {c, c, 0}, 0.5);
    EXPECT_NEAR(twice.at({-5, 0}), 0.2 * 4 * std::sqrt(1.25), 0.15) << "4 m aside rise by 2 m of what was baked";
    EXPECT_GT(twice.at({-19, 0}), 0.3f);
    EXPECT_EQ(once.at({-19, 0}), 0);
    EXPECT_GT(once.at({-9, 0}), 0.3f);
    EXPECT_EQ(half.at({-9, 0}), 0);
    EXPECT_GT(shadeOfSky(block(), 2).at({6, 0}), shadeOfSky(block()).at({6, 0}));
    EXPECT_NEAR(shadeOfSky(block(), 1e-3).at({6, 0}), 0, 1e-3) << "what lies flat hides no sky beside it";
}

}  // namespace
}  // namespace sward
