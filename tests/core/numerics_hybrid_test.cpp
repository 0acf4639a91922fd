// What must hold between the hard points of Boulanger, Pattanaik and Bouatouch's formulas: partitions, monotony, means.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/numerics.h"

namespace sward {
namespace {

using namespace f32;

struct Random {
    std::mt19937 bits{2006};
    float in(float a, float b) { return a + (b - a) * hashUnit(bits()); }
};

TEST(LightWeights, ZeroSignsAndHorizonMakeNoDifference) {
    for (float z : {-0.0f, 0.0f}) {
        const auto w = f32::lightWeights({z, 1, z});
        EXPECT_EQ(w.yPos, 1.0f);
        EXPECT_EQ(w.xPos + w.zPos + w.xNeg + w.zNeg, 0.0f);
    }
    Random r;
    for (int i = 0; i < 1000; ++i) {
        const float angle = r.in(-3, 3), x = std::cos(angle), z = std::sin(angle);
        const auto above = f32::lightWeights({x, 1e-7f, z}), below = f32::lightWeights({x, -1e-7f, z});
        EXPECT_NEAR(above.xPos, below.xPos, 1e-6f);
        EXPECT_NEAR(above.yPos, below.yPos, 1e-6f);
        EXPECT_EQ(below.yPos, 0.0f);
        EXPECT_TRUE(x < 0 ? above.xPos == 0 : above.xNeg == 0);
    }
}

TEST(LightWeights, SymmetryExchangesTheImages) {
    Random r;
    for (int i = 0; i < 1000; ++i) {
        const float x = r.in(0.01f, 1), y = r.in(0, 1), z = r.in(0.01f, 1);
        const auto a = f32::lightWeights({x, y, z}), b = f32::lightWeights({-x, y, -z}),
                   c = f32::lightWeights({z, y, x});
        EXPECT_EQ(a.xPos, b.xNeg);
        EXPECT_EQ(a.zPos, b.zNeg);
        EXPECT_NEAR(a.xPos, c.zPos, 3e-7f);
    }
}

TEST(Lod, GeometryAndHorizontalAreOneBitForBitAndNeverGrowOrJump) {
    Random r;
    for (int i = 0; i < 500; ++i) {
        const float near = r.in(0, 50), far = near + (i % 5 ? r.in(0, 40) : 0), inv = lodInverse(near, far);
        float before = 1;
        for (int k = 0; k <= 400; ++k) {
            const float d = r.in(0, 0.25f) + 0.25f * float(k);
            const LodWeights w = lodWeights(d, near, inv, 60, lodInverse(60, 80));
            EXPECT_EQ(w.geometry + w.horizontal, 1.0f);
            EXPECT_LE(w.geometry, before);
            EXPECT_LE(w.vertical, w.horizontal);
            if (far > near) {
                EXPECT_LE(before - w.geometry, 0.5f / (far - near) + 1e-6f);
            }
            before = w.geometry;
        }
    }
}

TEST(Lod, NotANumberAndInfiniteDistancesAreFarAndInfiniteRangesNeverFade) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (float d : {nan, inf, 3e38f}) {
        EXPECT_EQ(lodRamp(d, 10, lodInverse(10, 20)), 1.0f);
        EXPECT_EQ(lodRamp(d, 10, lodInverse(10, 10)), 1.0f);
        EXPECT_EQ(lodRamp(d, 10, lodInverse(20, 10)), 1.0f);
    }
    EXPECT_EQ(lodInverse(10, inf), 0.0f);
    EXPECT_EQ(lodRamp(1e9f, 10, 0), 0.0f);
    EXPECT_EQ(lodRamp(9.999f, 10, lodInverse(10, 10)), 0.0f);
    EXPECT_EQ(lodRamp(10, 10, lodInverse(10, 10)), 1.0f);
}

TEST(Opacity, BareGroundIsBareFullGroundFullAndTheMeanIsTheDensity) {
    for (float omega : {0.0f, 0.05f, 0.4f, 0.5f}) {
        for (float threshold : {1.0f / 255, 0.5f, 1.0f}) {
            EXPECT_EQ(opacityConserving(0, threshold, omega), 0.0f);
            EXPECT_EQ(opacityConserving(1, threshold, omega), 1.0f);
        }
        for (double density : {0.0, 0.02, 0.25, 0.5, 0.9, 1.0}) {
            double sum = 0;
            const int n = 200000;
            for (int i = 0; i < n; ++i) sum += f64::opacityConserving(density, (i + 0.5) / n, double(omega));
            EXPECT_NEAR(sum / n, density, omega > 0 ? 1e-6 : 3e-6);
        }
    }
}

TEST(Opacity, IsMonotoneInDensityAndFallsWithTheThreshold) {
    Random r;
    for (int i = 0; i < 200; ++i) {
        const float threshold = r.in(0.004f, 1), omega = r.in(0, 0.5f);
        float before = 0;
        for (int k = 0; k <= 256; ++k) {
            const float now = opacityConserving(float(k) / 256, threshold, omega);
            EXPECT_GE(now, before - 1e-7f);
            EXPECT_LE(opacityConserving(float(k) / 256, std::min(threshold + 0.1f, 1.0f), omega), now + 1e-7f);
            before = now;
        }
    }
}

TEST(Opacity, EqualsEquation5InsideAndTheStepWithoutFading) {
    Random r;
    for (int i = 0; i < 2000; ++i) {
        const float omega = r.in(0, 0.4f), density = r.in(omega, 1 - omega), threshold = r.in(0.004f, 1);
        if (omega <= density && density <= 1 - omega) {
            EXPECT_EQ(opacityConserving(density, threshold, omega), opacityEq5(density, threshold, omega));
        }
        EXPECT_EQ(opacityEq5(density, threshold, 0), density >= threshold ? 1.0f : 0.0f);
    }
    EXPECT_EQ(opacityEq5(0.5f, 0.5f, 0), 1.0f);
}

TEST(Partition, EveryBladeIsDrawnExactlyOnceWhereItExists) {
    int drawn = 0;
    for (float density : {0.0f, 0.25f, 0.5f, 0.6f, 1.0f})
        for (int w = 0; w <= 1000; ++w)
            for (int k = 1; k <= 255; ++k) {
                const float ws = float(w) / 1000, t = thresholdOf(k);
                const int times = sliceHolds(density, ws, t) + geometryHolds(density, ws, t);
                ASSERT_EQ(times, t <= density ? 1 : 0) << density << ' ' << ws << ' ' << k;
                drawn += times;
            }
    EXPECT_EQ(drawn, 1001 * (63 + 127 + 153 + 255));
}

TEST(Partition, FadingSharesTheBladeAndBoundsHoldWhatIsDrawn) {
    Random r;
    for (int i = 0; i < 200000; ++i) {
        const float density = r.in(0, 1), ws = r.in(0, 1), omega = i % 5 ? r.in(0, 0.5f) : 0,
                    t = thresholdOf(1 + int(r.bits() % 255));
        const float slice = sliceOpacity(density, ws, t, omega), geometry = geometryOpacity(density, ws, t, omega);
        ASSERT_GE(geometry, 0.0f);
        ASSERT_NEAR(slice + geometry, opacityConserving(density, t, omega), 1.2e-7f);
        if (geometry > 0) {
            ASSERT_LE(t, highestThresholdDrawn(density, omega));
            ASSERT_GE(t, lowestThresholdDrawn(sliceDensity(density, ws), omega));
        }
    }
}

TEST(Bilinear, TexelCentresGiveTheirTexelsAndEdgesHold) {
    for (int n : {1, 2, 7, 128, 4096})
        for (int i = 0; i < n; i += std::max(1, n / 9)) {
            const BilinearTap t = bilinearTap((float(i) + 0.5f) / float(n), 0.5f, n, n);
            EXPECT_NEAR(float(t.x0) + t.fx, float(i), 3e-4f);
            EXPECT_LT(t.x1, n);
        }
    for (float u : {-5.0f, 0.0f, 1.0f, 7.0f}) {
        const BilinearTap t = bilinearTap(u, u, 8, 8);
        EXPECT_EQ(t.x0, u > 0.5f ? 7 : 0);
        EXPECT_EQ(t.fx, 0.0f);
        EXPECT_TRUE(t.y0 >= 0 && t.y1 <= 7);
    }
    EXPECT_EQ(bilinearMix(0.3f, 0.3f, 0.3f, 0.3f, 0.7f, 0.1f), 0.3f);
    EXPECT_FLOAT_EQ(bilinearMix(0, 1, 2, 3, 0.5f, 0.5f), 1.5f);
}

TEST(Quadtree, LevelsNeverFallWithDistanceAndAreZeroInside) {
    int before = 0;
    for (int k = 0; k < 4000; ++k) {
        const int level = macroLevel(float(k), 20, 16, 10);
        EXPECT_GE(level, before);
        if (k <= 20) {
            EXPECT_EQ(level, 0);
        }
        before = level;
    }
    EXPECT_EQ(before, 7);  // 32, 64, ... 2048 are reached
}

TEST(GroundShadow, LiesAwayFromTheLightIsNeverLongerThanItsLimitAndFadesWithoutAJump) {
    float before = 0;
    for (int k = -200; k <= 1500; ++k) {
        const float up = float(k) * 1e-3f;
        const GroundShadow g = shadowOfSun(0.3f, {std::cos(up), std::sin(up), 0}, 2);
        EXPECT_LE(g.offset.x, 0.0f);
        EXPECT_LE(glm::length(g.offset), 2.000001f);
        EXPECT_TRUE(g.alpha >= 0 && g.alpha <= 1);
        EXPECT_LT(std::abs(g.alpha - before), 0.01f);
        if (k <= 0) {
            EXPECT_EQ(g.alpha, 0.0f);
        }
        before = g.alpha;
    }
    EXPECT_EQ(before, 1.0f);
}

TEST(GroundShadow, OneStandsForThoseThatAreNarrowerThanHalfAPixel) {
    EXPECT_EQ(shadowsOfOne(0.02f, 0.01f), 1.0f);
    EXPECT_EQ(shadowsOfOne(0.004f, 0.024f), 3.0f);
    EXPECT_EQ(shadowsOfOne(0, 1), kMostShadows);
    EXPECT_EQ(shadowWidening(1, 0.9999f), 1.0f);
    constexpr int kChances = 20000;
    for (const float many : {1.001f, 1.3f, 2.0f, 5.5f, 16.0f}) {
        double sum = 0;
        int left = 0;
        for (int i = 0; i < kChances; ++i) {
            const float w = shadowWidening(many, (float(i) + 0.5f) / kChances);
            ASSERT_TRUE(w >= 0 && w <= many * 4 / 3) << many;
            sum += double(w), left += w > 0;
        }
        EXPECT_NEAR(sum / kChances, 1, 1e-3) << "as much shadow as all have, of one for " << many;
        EXPECT_NEAR(double(left) / kChances, 1 / double(many), 1e-3) << many;
    }
    float before = shadowWidening(1, 0.3f);  // a blade's, while the eye goes away from it
    for (float many = 1; many < 16; many *= 1.01f) {
        const float w = shadowWidening(many, 0.3f);
        EXPECT_LT(std::abs(w - before), 0.1f) << many;
        before = w;
    }
    EXPECT_EQ(before, 0.0f);
}

TEST(ShadowCylinder, RaysLeaveOnTheCylinder) {
    Random r;
    for (int i = 0; i < 5000; ++i) {
        const vec3 o(r.in(-0.03f, 0.03f), r.in(0, 0.3f), r.in(-0.03f, 0.03f)), d(r.in(-1, 1), r.in(-1, 1), r.in(-1, 1));
        const float t = cylinderExit(o, d, 0.05f);
        const vec3 p = o + d * t;
        ASSERT_GE(t, 0.0f);
        ASSERT_NEAR(std::sqrt(p.x * p.x + p.z * p.z), 0.05f, 1e-5f);
    }
    EXPECT_EQ(cylinderExit({0.2f, 0, 0}, {1, 0, 0}, 0.05f), 0.0f);  // outside counts as on it
}

}  // namespace
}  // namespace sward
