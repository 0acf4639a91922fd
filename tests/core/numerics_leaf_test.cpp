// A leaf sends back no more light than falls on it, the same both ways, and its mean over all leaves is the closed
// form.
#include <gtest/gtest.h>

#include <random>

#include "core/numerics.h"

namespace sward {
namespace {

using namespace f64;

struct Directions {
    std::mt19937 bits{7};
    double unit() { return (bits() >> 8) * 0x1p-24; }
    glm::dvec3 any() {
        const double y = 2 * unit() - 1, a = 2 * kPi * unit(), r = std::sqrt(1 - y * y);
        return {r * std::cos(a), y, r * std::sin(a)};
    }
};

TEST(Leaf, HighlightSendsBackNoMoreThanFallsOnIt) {
    const glm::dvec3 n(0, 1, 0);
    for (const double roughness : {0.2, 0.4, 0.6, 1.0})
        for (const double up : {0.05, 0.3, 0.7, 1.0}) {
            const glm::dvec3 v(std::sqrt(1 - up * up), up, 0);
            double sum = 0;
            constexpr int kRows = 400, kColumns = 400;
            for (int r = 0; r < kRows; ++r)
                for (int c = 0; c < kColumns; ++c) {
                    const double y = (r + 0.5) / kRows, a = 2 * kPi * (c + 0.5) / kColumns, h = std::sqrt(1 - y * y);
                    sum += waxyLobe(n, glm::dvec3(h * std::cos(a), y, h * std::sin(a)), v, roughness);
                }
            sum *= 2 / double(kRows * kColumns);  // 2 pi / n, over pi
            EXPECT_LT(sum, 0.7) << roughness << ' ' << up;
            if (up == 1.0 && roughness < 0.5) {
                EXPECT_NEAR(sum, kLeafFresnel, 0.004) << "facing a leaf, Fresnel's share comes back";
            }
        }
}

TEST(Leaf, HighlightIsTheSameBothWays) {
    Directions d;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 n = d.any(), l = d.any(), v = d.any();
        if (dot(n, l) < 0.01 || dot(n, v) < 0.01) continue;
        const double there = waxyLobe(n, l, v, 0.5) / dot(n, l), back = waxyLobe(n, v, l, 0.5) / dot(n, v);
        EXPECT_NEAR(there, back, 1e-9 * (1 + there));
    }
}

TEST(Leaf, HighlightVanishesBehindAndIsFiniteAtGrazingAngles) {
    const glm::dvec3 n(0, 1, 0), along(1, 0, 0);
    EXPECT_EQ(waxyLobe(n, -n, n, 0.5), 0);
    EXPECT_EQ(waxyLobe(n, n, -n, 0.5), 0);
    for (const double up : {0.0, 1e-30, 1e-9, 1e-3}) {
        const glm::dvec3 l(1, up, 0), v(-1, up, 0);
        const double lobe = waxyLobe(n, l, v, 0.05);
        EXPECT_TRUE(std::isfinite(lobe) && lobe >= 0) << up;
    }
    EXPECT_EQ(waxyLobe(n, along, along, 0.5), 0);
}

TEST(Leaf, MeanOverLeavesOfAllDirectionsIsAQuarterOfFresnel) {
    Directions d;
    for (const double angle : {0.3, 1.2, 2.4}) {
        const glm::dvec3 v(0, 0, 1), l(std::sin(angle), 0, std::cos(angle));
        double sum = 0, seen = 0;
        for (int i = 0; i < 2000000; ++i) {
            const glm::dvec3 n = d.any();
            const double nv = dot(n, v);
            if (nv <= 0) continue;
            seen += nv;
            sum += waxyLobe(n, l, v, 0.3) * nv;
        }
        EXPECT_NEAR(sum / seen, waxyMean(dot(l, v)), 0.2 * waxyMean(dot(l, v)))
            << angle;  // rough lobes are cut where leaves turn away
    }
}

TEST(Leaf, ThroughItLightTurnsYellower) {
    const glm::dvec3 c(0.06, 0.13, 0.04), t = leafThrough(c);
    EXPECT_GT(t.x / t.y, c.x / c.y);
    EXPECT_LT(t.z / t.y, c.z / c.y);
    EXPECT_NEAR(t.y, c.y, 0.1 * c.y);
}

TEST(Leaf, BrightPaintSendsNoMoreThanFallsOnIt) {
    for (const double bright : {0.1, 0.5, 0.8, 0.95, 1.0}) {
        const glm::dvec3 c(bright), passes = leafPasses(c, 1.0);
        for (int k = 0; k < 3; ++k) {
            EXPECT_LE(c[k] + passes[k], std::max(bright, 0.95)) << bright;
            EXPECT_GE(passes[k], 0);
        }
    }
    const glm::dvec3 green(0.06, 0.13, 0.04);
    EXPECT_EQ(leafPasses(green, 0.5), leafThrough(green) * 0.5) << "what grows stays far below";
}

TEST(Leaf, BrightPaintBrightensWhatStandsBesideItAndNothingElseDoes) {
    const glm::dvec3 own(0.05, 0.1, 0.03), white(0.8), none(0);
    EXPECT_EQ(paintScatters(own, own, 0.5, 0.6), glm::dvec3(1));
    EXPECT_EQ(paintScatters(own, white, 0.5, 0.0), glm::dvec3(1)) << "a blade that stands alone";
    const glm::dvec3 more = paintScatters(own, white, 0.0, 0.5);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(more[k], (1 - 0.5 * own[k]) / (1 - 0.5 * 0.8), 1e-12) << "two geometric series";
        EXPECT_LT(paintScatters(own, none, 0.5, 0.6)[k], 1) << "black paint takes away";
        EXPECT_LE(paintScatters(none, glm::dvec3(1), 1.0, 0.95)[k], 20.001);
    }
}

}  // namespace
}  // namespace sward
