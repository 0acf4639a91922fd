// Grass on a hillside (numerics/slope.h), and pressed down (numerics/lying.h).
#include <gtest/gtest.h>

#include "core/numerics.h"

namespace sward::test {
namespace {

using glm::dvec2, glm::dvec3;

TEST(NumericsSlope, WhatHidesWhatOnTheHillsideHidesItOnLevelGround) {
    const dvec2 slope(0.3, -0.2);
    // A ray to the light from a point of one blade that meets another blade: both roots stand on the slope.
    const dvec3 from(0.1, 0.05 + 0.3 * 0.1, 0), towards = glm::normalize(dvec3(0.5, 0.6, 0.4));
    const dvec3 meets = from + 0.7 * towards;
    const dvec3 level = f64::overLevel(from, slope), way = f64::overLevel(towards, slope);
    const dvec3 there = level + 0.7 * way;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(there[c], f64::overLevel(meets, slope)[c], 1e-15) << "lines stay straight";
    EXPECT_NEAR(level.y, 0.05, 1e-15) << "so high over the ground";
    EXPECT_EQ(there.x, meets.x);
    EXPECT_EQ(there.z, meets.z);
}

// What is seen of leaves, layer by layer, and lit past those above.
double litByLayers(double eyes, double lights) {
    constexpr int kLayers = 20000;
    double seen = 0, lit = 0;
    for (int i = 0; i < kLayers; ++i) {
        const double depth = (i + 0.5) / kLayers, of = std::exp(-eyes * depth);
        seen += of, lit += of * std::exp(-lights * depth);
    }
    return lit / seen;
}

TEST(NumericsSlope, BrightensAsLayersOfLeavesDo) {
    const dvec2 area(2.0, 0.7);
    const dvec3 sun = glm::normalize(dvec3(0, 0.6, -0.8)), eye = glm::normalize(dvec3(0.9, 0.4, 0.1));
    EXPECT_EQ(f64::slopeBrightens(area, eye, sun, {0, 0}), 1) << "level ground";
    for (const dvec2& slope : {dvec2(0, 0.3), dvec2(0, -0.3), dvec2(0.2, 0.1)}) {
        const double eyes = f64::leafDepth(area, eye, f64::riseOver(eye, slope)),
                     want = litByLayers(eyes, f64::leafDepth(area, sun, f64::riseOver(sun, slope))) /
                            litByLayers(eyes, f64::leafDepth(area, sun, sun.y));
        EXPECT_NEAR(f64::slopeBrightens(area, eye, sun, slope), want, 1e-6 * want);
    }
    EXPECT_GT(f64::slopeBrightens(area, eye, sun, {0, 0.3}), 1.1) << "it faces the sun";
    EXPECT_LT(f64::slopeBrightens(area, eye, sun, {0, -0.3}), 0.9);
    EXPECT_EQ(f64::slopeBrightens(area, eye, sun, {0, -1.0}), 0) << "the sun is behind the hill";
    EXPECT_NEAR(f32::slopeBrightens({0, 0}, {0, 1, 0}, {0, 1, 0}, {9, 9}), 1, 1e-6f) << "no leaves at all";
}

TEST(NumericsLying, LeavesWhatPathsLeaveAndAllOfItWhereFewLie) {
    EXPECT_EQ(f64::lyingLit(0), 1);
    EXPECT_NEAR(f64::lyingLit(0.35), 1.00, 0.06);
    EXPECT_NEAR(f64::lyingLit(1.7), 0.89, 0.06);
    EXPECT_NEAR(f64::lyingLit(4.4), 0.77, 0.03);
    EXPECT_NEAR(f64::lyingLit(100), 1 / 1.3, 1e-6);
}

}  // namespace
}  // namespace sward::test
