// Filters over a plane: weights, edges, and what is not a number.
#include "metrics/convolve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sward {
namespace {

const Taps kNone{1};

TEST(Convolve, GaussianWeightsSumToOneAndFallAsTheBellDoes) {
    const Taps taps = gaussianTaps(1.5, 5);
    ASSERT_EQ(taps.size(), 11u);
    double sum = 0;
    for (size_t i = 0; i < taps.size(); ++i) {
        sum += taps[i];
        EXPECT_EQ(taps[i], taps[10 - i]);
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    EXPECT_NEAR(taps[8] / taps[5], std::exp(-9 / (2 * 1.5 * 1.5)), 1e-14);
}

TEST(Convolve, AWeightAtMinusOneTakesTheNeighbourBeforeAndEdgesRepeat) {
    const Plane plane{3, 2, {1, 2, 3, 4, 5, 6}};
    EXPECT_EQ(convolve(plane, kNone, kNone).values, plane.values);
    EXPECT_EQ(convolve(plane, {1, 0, 0}, kNone).values, (std::vector<float>{1, 1, 2, 4, 4, 5}));
    EXPECT_EQ(convolve(plane, {0, 0, 1}, kNone).values, (std::vector<float>{2, 3, 3, 5, 6, 6}));
    EXPECT_EQ(convolve(plane, kNone, {1, 0, 0}).values, (std::vector<float>{1, 2, 3, 1, 2, 3}));
    EXPECT_EQ(convolve(plane, kNone, {1, 1, 1}).values, (std::vector<float>{6, 9, 12, 9, 12, 15}));
}

TEST(Convolve, WhatIsNoNumberSpoilsItsWindowAndNoMore) {
    Plane plane{7, 1, std::vector<float>(7, 1)};
    plane.values[3] = std::numeric_limits<float>::quiet_NaN();
    const Plane out = convolve(plane, {0.25, 0.5, 0.25}, kNone);
    for (size_t i = 0; i < 7; ++i) EXPECT_EQ(std::isnan(out.values[i]), i >= 2 && i <= 4) << i;
}

}  // namespace
}  // namespace sward
