// Numbers at vertices from numbers at points of a mesh: against what is known of them in closed form.
#include "reference/vertex_fit.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

// A square of 1 x 1 in x and z, of so many squares a side.
Mesh square(uint32_t side) {
    Mesh m;
    for (uint32_t z = 0; z <= side; ++z)
        for (uint32_t x = 0; x <= side; ++x)
            m.vertices.push_back({{static_cast<float>(x) / static_cast<float>(side), 0,
                                   static_cast<float>(z) / static_cast<float>(side)},
                                  {0, 1, 0},
                                  {0, 0}});
    for (uint32_t z = 0; z < side; ++z)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t a = z * (side + 1) + x, b = a + side + 1;
            m.indices.insert(m.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    m.parts = {{0, static_cast<uint32_t>(m.indices.size())}};
    return m;
}
glm::vec3 placeOf(const Mesh& m, const SurfacePoint& p) {
    glm::vec3 sum(0);
    for (uint32_t k = 0; k < 3; ++k)
        sum += p.weights[static_cast<int>(k)] * m.vertices[m.indices[p.triangle + k]].position;
    return sum;
}
template <class F>
std::vector<FittedRow> fitted(const Mesh& m, size_t count, F value) {
    const std::vector<SurfacePoint> points = pointsOver(m, count, 3);
    std::vector<FittedRow> found;
    for (const SurfacePoint& p : points) {
        FittedRow row{};
        row[0] = value(placeOf(m, p)), row[8] = 2 * row[0];
        found.push_back(row);
    }
    return fitVertices(m, points, found);
}

TEST(VertexFit, PointsLieByAreaAndAreTheSameAgain) {
    Mesh m = square(1);
    m.vertices[3].position = {3, 0, 3};  // the second triangle is five times as large as the first
    const auto points = pointsOver(m, 600, 7), again = pointsOver(m, 600, 7);
    ASSERT_EQ(points.size(), 600u);
    size_t first = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        first += points[i].triangle == 0;
        EXPECT_EQ(points[i].weights, again[i].weights);
        EXPECT_NEAR(points[i].weights.x + points[i].weights.y + points[i].weights.z, 1, 1e-6);
        EXPECT_GE(glm::min(points[i].weights.x, glm::min(points[i].weights.y, points[i].weights.z)), 0);
    }
    EXPECT_NEAR(static_cast<double>(first), 100, 1);
    EXPECT_NEAR(surfaceArea(m), 3, 1e-6);
}

TEST(VertexFit, GivesBackWhatIsLinear) {
    for (const uint32_t side : {1u, 8u}) {
        const Mesh m = square(side);
        const auto rows = fitted(m, 2000, [](const glm::vec3& at) { return 1 + 2 * at.x - at.z; });
        for (size_t i = 0; i < rows.size(); ++i) {
            const float right = 1 + 2 * m.vertices[i].position.x - m.vertices[i].position.z;
            EXPECT_NEAR(rows[i][0], right, 0.03) << side << ", " << i;
            EXPECT_NEAR(rows[i][8], 2 * right, 0.06);
            EXPECT_EQ(rows[i][4], 0);
        }
    }
}

// Four corners of which two lie in a dark edge: what is found at the corners themselves would be half of what the
// surface has.
TEST(VertexFit, AWallIsAsBrightInTheMeanAsItsSurface) {
    const Mesh m = square(1);
    const auto light = [](const glm::vec3& at) { return at.x < 0.9f ? 1.0f : 0.0f; };
    const auto rows = fitted(m, 4000, light);
    double mean = 0, atCorners = 0;
    for (const uint32_t i : m.indices)
        mean += static_cast<double>(rows[i][0]) / 6,
            atCorners += static_cast<double>(light(m.vertices[i].position)) / 6;
    EXPECT_NEAR(mean, 0.9, 0.01);
    EXPECT_NEAR(atCorners, 0.5, 1e-9);
}

TEST(VertexFit, VerticesOfOnePlaceHaveOneRowAndThoseWithoutPointsTheirNeighbours) {
    Mesh m = square(16);
    // Apart in texture coordinates alone: each triangle has corners of its own.
    Mesh apart;
    for (const uint32_t i : m.indices) {
        apart.indices.push_back(static_cast<uint32_t>(apart.vertices.size()));
        apart.vertices.push_back(m.vertices[i]);
        apart.vertices.back().uv = {static_cast<float>(apart.vertices.size()), 0};
    }
    const auto value = [](const glm::vec3& at) { return at.x; };
    const auto one = fitted(m, 60, value), other = fitted(apart, 60, value);
    for (size_t i = 0; i < m.indices.size(); ++i) EXPECT_NEAR(other[i][0], one[m.indices[i]][0], 1e-5);
    double off = 0;
    for (size_t i = 0; i < one.size(); ++i)
        off = std::max(off, static_cast<double>(std::abs(one[i][0] - m.vertices[i].position.x)));
    EXPECT_LT(off, 0.2) << "60 points for 289 vertices";
}

TEST(VertexFit, WithoutAreaOrPointsThereIsNothing) {
    Mesh flat = square(1);
    for (MeshVertex& v : flat.vertices) v.position = {0, 0, 0};
    EXPECT_TRUE(pointsOver(flat, 100, 1).empty());
    EXPECT_TRUE(pointsOver(Mesh{}, 100, 1).empty());
    const Mesh m = square(1);
    EXPECT_TRUE(pointsOver(m, 0, 1).empty());
    for (const FittedRow& row : fitVertices(m, {}, {})) EXPECT_EQ(row, FittedRow{});
}

}  // namespace
}  // namespace sward
