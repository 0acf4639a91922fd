// What must hold of blades, clumps, wind, hashes and levels between their hard points.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/numerics.h"

namespace sward {
namespace {

using namespace f32;

struct Random {
    std::mt19937 bits{2013};
    float in(float a, float b) { return a + (b - a) * hashUnit(bits()); }
};

TEST(Blade, NoPointLiesBelowTheRootPlaneAndFramesAreOrthonormal) {
    Random r;
    for (int i = 0; i < 50000; ++i) {
        const float height = i % 50 ? r.in(0.01f, 0.6f) : 0, azimuth = r.in(-3.1f, 3.1f),
                    v = i % 3 ? r.in(0, 1) : float(i % 2);
        const BladeShape s = bladeShape(height, i % 7 ? r.in(-2, 2) : 0, i % 4 ? r.in(0, 2) : 0.5f, azimuth);
        const BladeFrame f = bladeFrame(s.control, s.tip, azimuth, v);
        ASSERT_GE(f.position.y, 0.0f);
        ASSERT_NEAR(glm::length(f.tangent), 1, 1e-6f);
        ASSERT_NEAR(glm::length(f.normal), 1, 1e-6f);
        ASSERT_NEAR(glm::length(f.side), 1, 1e-6f);
        ASSERT_NEAR(glm::dot(f.tangent, f.normal), 0, 1e-6f);
        ASSERT_NEAR(glm::dot(f.tangent, f.side), 0, 1e-6f);
        ASSERT_NEAR(glm::dot(f.normal, f.side), 0, 1e-6f);
    }
}

TEST(Blade, FollowsItsConvention) {
    const BladeShape upright = bladeShape(0.5f, 0, 0, 0.7f);
    EXPECT_EQ(upright.tip, vec3(0, 0.5f, 0));
    const BladeFrame f = bladeFrame(upright.control, upright.tip, 0, 0.5f);
    EXPECT_EQ(f.position, vec3(0, 0.25f, 0));
    EXPECT_EQ(f.tangent, vec3(0, 1, 0));
    EXPECT_EQ(f.side, vec3(0, 0, 1));
    EXPECT_EQ(f.normal, vec3(-1, 0, 0));
    // Bent flat over, the upper face looks up; the tip has dropped by the share asked for.
    const BladeShape bent = bladeShape(1, 0.5f, 0.3f, 0);
    EXPECT_NEAR(bent.tip.y, std::cos(0.5f) - 0.3f, 1e-6f);
    EXPECT_GT(bent.tip.x, 0.4f);
    EXPECT_GT(bladeFrame(bent.control, bent.tip, 0, 1).normal.y, 0.5f);
}

TEST(Blade, FramesSurviveWindOutOfTheirPlane) {
    Random r;
    for (int i = 0; i < 5000; ++i) {
        const float azimuth = r.in(-3, 3);
        const vec3 control(r.in(-1, 1), r.in(0, 1), r.in(-1, 1)), tip(r.in(-1, 1), r.in(0, 1), r.in(-1, 1));
        const BladeFrame f = bladeFrame(control, tip, azimuth, r.in(0, 1));
        ASSERT_NEAR(glm::dot(f.tangent, f.normal), 0, 2e-6f);
        ASSERT_NEAR(glm::dot(f.side, f.normal), 0, 1e-6f);
        ASSERT_NEAR(glm::length(f.normal), 1, 1e-6f);
    }
}

TEST(Spline, FramesAreUnitAndPerpendicularForDegenerateBladesToo) {
    Random r;
    for (int i = 0; i < 20000; ++i) {
        vec3 p[6];
        for (vec3& q : p) q = i % 11 == 0 ? vec3(0) : vec3(r.in(-1, 1), r.in(0, 1), r.in(-1, 1));
        if (i % 3 == 0) p[1] = p[2];
        if (i % 5 == 0) p[3] = p[0], p[4] = p[1], p[5] = p[2];
        const SplineFrame f = splineFrame(p[0], p[1], p[2], p[3], p[4], p[5], {1, 0, 0}, r.in(0, 1), r.in(0, 1));
        ASSERT_NEAR(glm::length(f.tangent), 1, 1e-6f);
        ASSERT_NEAR(glm::length(f.bitangent), 1, 1e-6f);
        ASSERT_NEAR(glm::length(f.normal), 1, 1e-6f);
        const float sine = glm::length(glm::cross(f.tangent, f.bitangent));
        if (sine > 0.05f) {
            ASSERT_NEAR(glm::dot(f.normal, f.tangent), 0, 1e-5f);
            ASSERT_NEAR(glm::dot(f.normal, f.bitangent), 0, 1e-5f);
        }
    }
}

TEST(Spline, VectorsAreReplacedBelowAMillionthOfTheBladeOnly) {
    const vec3 tip(1, 0, 0), side(0, 0, 1);
    for (float k : {1e-2f, 1e-4f, 3e-6f, 3e-7f, 0.0f}) {
        const vec3 control(0, k, 0), width(0, 0, -k);  // a width against the rest side shows who decided
        const SplineFrame f = splineFrame(vec3(0), control, tip, width, control + width, tip + width, side, 0, 0);
        EXPECT_EQ(f.tangent, k > 1e-6f ? vec3(0, 1, 0) : tip) << k;
        EXPECT_EQ(f.bitangent, k > 1e-6f ? -side : side) << k;
    }
}

TEST(Blade, ShortTangentsAreReplacedBelowAMillionthOfTheBladeOnly) {
    for (float k : {1e-2f, 1e-4f, 3e-6f, 3e-7f, 0.0f})
        EXPECT_EQ(bladeFrame({0, k, 0}, {1, 0, 0}, 0, 0).tangent, k > 1e-6f ? vec3(0, 1, 0) : vec3(1, 0, 0)) << k;
}

vec3 clumpAt(int cell, float local, float cellSize, float clumpSize) {
    return clumpValues(cell, cell / 3, vec2(local, 0.3f * cellSize), cellSize, clumpSize, 5);
}

TEST(Clump, CellsMeetExactlyEvenWhereClumpsDoNotDivideThem) {
    for (int cell : {-180000, -1, 0, 5, 65535, 180000})
        for (float size : {0.13f, 0.7f, 1.7f, 9.3f, 400.0f})
            for (float z : {0.0f, 0.4f, 1.69f}) {
                const vec3 a = clumpValues(cell, cell, vec2(1.7f, z), 1.7f, size, 3),
                           b = clumpValues(cell + 1, cell, vec2(0, z), 1.7f, size, 3);
                const vec3 c = clumpValues(cell, cell, vec2(z, 1.7f), 1.7f, size, 3),
                           d = clumpValues(cell, cell + 1, vec2(z, 0), 1.7f, size, 3);
                EXPECT_EQ(a, b) << cell << ' ' << size;
                EXPECT_EQ(c, d) << cell << ' ' << size;
            }
}

TEST(Clump, IsAsSmoothFarOutAsAtTheOrigin) {
    for (int cell : {0, 180000}) {
        float steepest = 0;
        vec3 before = clumpAt(cell, 0, 2, 0.7f);
        for (int k = 1; k <= 4000; ++k) {
            const vec3 now = clumpAt(cell, 2 * float(k) / 4000, 2, 0.7f);
            steepest = std::max(steepest, maxAbs3(now - before) * 4000 / 2);
            before = now;
        }
        EXPECT_GT(steepest, 0.5f) << cell;                       // it varies,
        EXPECT_LT(steepest, 2 * 1.875f / 0.7f * 1.02f) << cell;  // by no more than the fade's slope between -1 and 1
    }
}

TEST(Clump, ThreeValuesAreIndependentCentredAndSeeded) {
    vec3 sum(0), square(0), mixed(0);
    const int n = 200;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const vec3 c = clumpLattice(uint(i), uint(j), 1);
            sum += c;
            square += c * c;
            mixed += vec3(c.x * c.y, c.y * c.z, c.z * c.x);
        }
    const float count = float(n * n);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(sum[k] / count, 0, 0.015f);
        EXPECT_NEAR(square[k] / count, 1.0f / 3, 0.01f);
        EXPECT_NEAR(mixed[k] / count, 0, 0.01f);
    }
    EXPECT_NE(clumpLattice(3, 4, 1), clumpLattice(3, 4, 2));
}

TEST(Hash, IsUniformAndNeighboursAreUncorrelated) {
    const int n = 512;
    double sum = 0, square = 0, neighbour = 0;
    std::vector<int> bins(64);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const float a = hashUnit(hash2(uint(i), uint(j))), b = hashUnit(hash2(uint(i + 1), uint(j)));
            ASSERT_TRUE(a >= 0 && a < 1);
            ++bins[size_t(a * 64)];
            sum += double(a);
            square += double(a * a);
            neighbour += double(a * b);
        }
    const double count = n * n, mean = sum / count, variance = square / count - mean * mean;
    EXPECT_LT(std::abs(neighbour / count - mean * mean) / variance, 0.01);
    double chi = 0;
    for (int b : bins) chi += (b - count / 64) * (b - count / 64) / (count / 64);
    EXPECT_LT(chi / 63, 1.6);
    EXPECT_GT(chi / 63, 0.5);
    EXPECT_LT(hashUnit(0xFFFFFFFFu), 1.0f);
    EXPECT_NE(hash2(1, 2), hash2(2, 1));
    EXPECT_NE(hashMix(0), 0u);
}

TEST(Hash, MirrorsAreBalancedOverCells) {
    int x = 0, z = 0, both = 0;
    for (int i = -100; i < 100; ++i)
        for (int j = -100; j < 100; ++j) {
            const vec2 m = cellMirror(cellHash(i, j, 9));
            ASSERT_EQ(std::abs(m.x) + std::abs(m.y), 2.0f);
            x += int(m.x), z += int(m.y), both += int(m.x * m.y);
        }
    EXPECT_LT(std::abs(x), 700);  // 3.5 sigma of 40,000 coins
    EXPECT_LT(std::abs(z), 700);
    EXPECT_LT(std::abs(both), 700);
}

float windOf(double x, double z, double t) {
    const double cx = std::floor(x), cz = std::floor(z);
    const f64::WindPhase p = f64::windPhase(cx, cz, t, 1, 0.5, 0.75);
    WindPhase q;
    q.first = float(p.first), q.second = float(p.second), q.across = float(p.across);
    return windAt(q, float(x - cx), float(z - cz), 1, 0.5f, 0.75f, 0.1f);
}

TEST(Wind, IsBoundedPeriodicAndSteadyAfterThirtyDays) {
    Random r;
    for (int i = 0; i < 20000; ++i) {
        const double x = double(r.in(-90000, 90000)), z = double(r.in(-90000, 90000)), t = double(r.in(0, 60));
        const float now = windOf(x, z, t);
        ASSERT_LE(std::abs(now), 1.000001f);
        const double month = 8 * 3.14159265358979323846 * 103133;  // whole periods of both waves, 30 days
        ASSERT_NEAR(windOf(x, z, t + month), now, 2e-5f);
        ASSERT_NEAR(windOf(x, z, t + month + 1 / 60.0) - windOf(x, z, t + month), windOf(x, z, t + 1 / 60.0) - now,
                    4e-5f);
    }
}

TEST(Wind, MeetsAtCellBorders) {
    for (double x : {1.0, 777.0, 90000.0}) EXPECT_NEAR(windOf(x - 1e-9, 3.3, 12.5), windOf(x, 3.3, 12.5), 4e-6f);
}

TEST(Tessellation, FallsFromTheSmoothnessToZero) {
    for (float s : {1.0f, 8.0f, 13.0f, 64.0f}) {
        int before = 64;
        for (int d = 0; d <= 120; ++d) {
            const int level = tessLevel(s, float(d), 100);
            EXPECT_LE(level, before);
            before = level;
        }
        EXPECT_EQ(tessLevel(s, 0, 100), int(s));
        EXPECT_EQ(tessLevel(s, 100, 100), 0);
    }
    EXPECT_EQ(tessLevel(8, std::nanf(""), 100), 0);
}

TEST(Ticks, PhasesRepeatAfterAnyTime) {
    for (uint tick : {0u, 17u, 599u})
        for (uint periods : {0u, 1u, 1000000u})
            EXPECT_EQ(tickPhase(tick + periods * 600u, 600u), tickPhase(tick, 600u));
    EXPECT_LT(tickPhase(599u, 600u), 1.0f);
}

// The mean along a strip, whose colours are interpolated between its rows, is that of the gradient for any strip.
TEST(Blade, StripsOfAnyNumberOfQuadsShowTheGradientsColours) {
    const f32::vec3 root(0.04f, 0.06f, 0.018f), middle(0.05f, 0.12f, 0.028f), tip(0.075f, 0.15f, 0.04f);
    const f32::vec3 mean = 0.25f * root + 0.5f * middle + 0.25f * tip;
    for (int quads = 1; quads <= 11; ++quads) {
        const float lacked = f32::middleLacked(quads), n = static_cast<float>(quads);
        f32::vec3 shown(0);
        for (float k = 0; k < n; ++k)
            shown += 0.5f / n *
                     (f32::bladeGradientRow(root, middle, tip, k / n, lacked) +
                      f32::bladeGradientRow(root, middle, tip, (k + 1) / n, lacked));
        EXPECT_NEAR(glm::distance(shown, mean), 0, 1e-6) << quads;
    }
    EXPECT_GT(glm::distance(0.5f * (root + tip), mean), 0.007f) << "rows at both ends alone lack the middle";
}

}  // namespace
}  // namespace sward
