#include "editor/tools/rings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sward {
namespace {

const HeightAt kFlat = [](double, double) { return 2.0; };
const HeightAt kHilly = [](double x, double z) { return 1.5 * std::sin(x * 0.2) + std::cos(z * 0.15); };

TEST(Rings, OnLevelGroundARingIsACircle) {
    const auto points = ringPoints(kFlat, {10, 3.7, -4}, 12, 64);
    ASSERT_EQ(points.size(), 64u);
    const double radius = std::sqrt(12 * 12 - 1.7 * 1.7);
    for (const auto& p : points) {
        ASSERT_TRUE(p);
        EXPECT_NEAR(std::hypot(p->x - 10, p->z + 4), radius, 1e-9);
        EXPECT_EQ(p->y, 2);
    }
    EXPECT_NEAR(points[0]->x, 10 + radius, 1e-9);
    EXPECT_NEAR(points[16]->z, -4 + radius, 1e-9);
}

TEST(Rings, OnHillsEveryPointLiesOnTheGroundAtItsDistance) {
    const glm::dvec3 eye{3, kHilly(3, 7) + 1.7, 7};
    for (const double distance : {4.0, 12.0, 25.0, 40.0, 200.0})
        for (const auto& p : ringPoints(kHilly, eye, distance, 96)) {
            ASSERT_TRUE(p) << distance;
            EXPECT_NEAR(glm::length(*p - eye), distance, 0.02 * distance + 0.05);
            EXPECT_EQ(p->y, kHilly(p->x, p->z));
        }
}

TEST(Rings, WhereTheGroundIsFartherThereIsNone) {
    for (const auto& p : ringPoints(kFlat, {0, 12, 0}, 5, 16)) EXPECT_FALSE(p);
    for (const double nothing : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
        for (const auto& p : ringPoints(kFlat, {0, 3, 0}, nothing, 8)) EXPECT_FALSE(p);
    EXPECT_TRUE(ringPoints(kFlat, {0, 3, 0}, 5, 0).empty());
}

TEST(Rings, AHillHidesWhatLiesBehindIt) {
    const HeightAt hill = [](double x, double) { return x > 8 && x < 12 ? 5.0 : 0.0; };
    EXPECT_TRUE(hiddenByGround(hill, {0, 1.7, 0}, {20, 0, 0}, 0.1));
    EXPECT_FALSE(hiddenByGround(hill, {0, 1.7, 0}, {6, 0, 0}, 0.1));
    EXPECT_FALSE(hiddenByGround(hill, {0, 40, 0}, {20, 0, 0}, 0.1));
    EXPECT_FALSE(hiddenByGround(kFlat, {0, 3.7, 0}, {50, 2, 0}, 0.1));
}

ScreenRing square(double side) {
    return {glm::dvec2{side, side}, glm::dvec2{-side, side}, glm::dvec2{-side, -side}, glm::dvec2{side, -side}};
}

TEST(Rings, ThePointerMeansTheNearestRingWithinItsTolerance) {
    const std::vector<ScreenRing> rings{square(10), square(30)};
    const auto hit = pickRing(rings, {0, 26}, 8);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->rings, std::vector<size_t>{1});
    EXPECT_EQ(hit->at, glm::dvec2(0, 30));
    EXPECT_NEAR(hit->share, 0.5, 1e-12);
    EXPECT_NEAR(hit->pixels, 4, 1e-12);
    EXPECT_FALSE(pickRing(rings, {0, 20}, 8));
    EXPECT_FALSE(pickRing({}, {0, 0}, 8));
    EXPECT_TRUE(pickRing(rings, {30, 0}, 1));  // the side from the last point to the first
}

TEST(Rings, WhatIsNotOnTheScreenCannotBeMeant) {
    ScreenRing ring = square(10);
    ring[1].reset();
    EXPECT_FALSE(pickRing(std::vector<ScreenRing>{ring}, {0, 10}, 3));
    EXPECT_TRUE(pickRing(std::vector<ScreenRing>{ring}, {0, -10}, 3));
    EXPECT_FALSE(pickRing(std::vector<ScreenRing>{ScreenRing(4)}, {0, 0}, 100));
}

TEST(Rings, RingsOnTopOfEachOtherAreToldApartByWhereTheHandGoes) {
    const std::vector<ScreenRing> rings{square(5), square(20), square(20.5)};
    const auto hit = pickRing(rings, {0, 20}, 8);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->rings, (std::vector<size_t>{1, 2}));
    EXPECT_EQ(ringMeant(*hit, 25, 20), 1u);
    EXPECT_EQ(ringMeant(*hit, 25, 30), 2u);
}

TEST(Rings, ANameGoesWhereItsRingIsSeen) {
    const ScreenRing ring = square(10);
    EXPECT_EQ(ringLabel(ring, {-20, -20}, {20, 20}, 9), glm::dvec2(10, 10));
    EXPECT_EQ(ringLabel(ring, {-20, -20}, {20, 0}, -9), glm::dvec2(-10, -10));
    EXPECT_FALSE(ringLabel(ring, {-2, -2}, {2, 2}, 0));
}

}  // namespace
}  // namespace sward
