// Known answers of water's and flowers' formulas.
#include <gtest/gtest.h>

#include "core/numerics.h"
#include "world/water.h"

namespace sward::test {
namespace {

// Fresnel's equations as taught, by Snell's angles.
double fresnelByAngles(double angle) {
    const double t = std::asin(std::sin(angle) / 1.333);
    if (angle < 1e-9) return std::pow(0.333 / 2.333, 2);
    const double s = std::sin(angle - t) / std::sin(angle + t), p = std::tan(angle - t) / std::tan(angle + t);
    return 0.5 * (s * s + p * p);
}

TEST(NumericsWater, FresnelIsThatOfTheAnglesAtEveryDegree) {
    for (int degrees = 0; degrees < 90; ++degrees) {
        const double angle = glm::radians(static_cast<double>(degrees));
        EXPECT_NEAR(f64::waterFresnel(std::cos(angle)), fresnelByAngles(angle), 1e-9) << degrees;
        EXPECT_NEAR(static_cast<double>(f32::waterFresnel(static_cast<float>(std::cos(angle)))), fresnelByAngles(angle),
                    2e-6)
            << degrees;
    }
    EXPECT_NEAR(f64::waterFresnel(0), 1, 1e-12);
}

TEST(NumericsWater, RaysBendBySnellAndAreThrownBackAtTheSameAngle) {
    const glm::dvec3 up(0, 1, 0);
    for (int degrees = 5; degrees < 90; degrees += 5) {
        const double angle = glm::radians(static_cast<double>(degrees));
        const glm::dvec3 way(std::sin(angle), -std::cos(angle), 0), in = f64::refracted(way, up),
                                                                    back = f64::mirrored(way, up);
        EXPECT_NEAR(in.x * 1.333, way.x, 1e-12);
        EXPECT_NEAR(glm::length(in), 1, 1e-12);
        EXPECT_NEAR(back.y, -way.y, 1e-9);
        EXPECT_NEAR(back.x, way.x, 1e-9);
    }
}

TEST(NumericsWater, WhatIsInClearSightLosesAllButTwoPercent) {
    Water w;
    w.clarity = 4;
    const glm::vec3 left = f32::waterLeft(waterGlobals({&w}, nullptr, {}, 0).extinction, 4, 0);
    EXPECT_LT(left.x, left.y);  // water takes red first
    EXPECT_NEAR(left.y, 0.02f * std::exp(-0.0565f * 4), 1e-4f);
    EXPECT_EQ(f32::waterLeft(glm::vec3(1), 0, 0), glm::vec3(1));
}

// The mean of slopes' squares over a wide square.
double meanSquare(const WaterGlobals& g) {
    double sum = 0;
    constexpr int kSide = 300;
    for (int z = 0; z < kSide; ++z)
        for (int x = 0; x < kSide; ++x) {
            const glm::vec2 s = waterSlope(g, glm::vec2(x, z) * 0.173f, 1);
            sum += static_cast<double>(glm::dot(s, s));
        }
    return sum / (kSide * kSide);
}

TEST(NumericsWater, SlopesAreTheOpenSeasAtFullStrengthAndNoneInACalm) {
    Water w;
    w.ripples = 1;
    Wind wind;
    wind.speed = 5;
    EXPECT_NEAR(meanSquare(waterGlobals({&w}, &wind, {}, 0)), 0.003 + 0.00512 * 5, 0.002);
    EXPECT_EQ(meanSquare(waterGlobals({&w}, nullptr, {}, 0)), 0);
}

TEST(NumericsWater, AMonthLaterAndFarAwayRipplesStepAsEvenly) {
    Water w;
    Wind wind;
    constexpr double kMonth = 30.0 * 86400;
    const auto step = [&](double from, const glm::dvec3& eye) {
        double worst = 0;
        for (int i = 0; i < 200; ++i) {
            const glm::vec2 at(0.37f * static_cast<float>(i), 0);
            const glm::vec2 a = waterSlope(waterGlobals({&w}, &wind, eye, from), at, 1),
                            b = waterSlope(waterGlobals({&w}, &wind, eye, from + 1.0 / 60), at, 1);
            worst = std::max(worst, static_cast<double>(glm::length(a - b)));
        }
        return worst;
    };
    const double first = step(0, {});
    EXPECT_GT(first, 0);
    EXPECT_NEAR(step(kMonth, {90000, 0, -70000}), first, 0.5 * first);
}

TEST(NumericsWater, TheEyeMayMoveWithoutMovingTheRipples) {
    Water w;
    Wind wind;
    const WaterGlobals here = waterGlobals({&w}, &wind, {0, 0, 0}, 7),
                       there = waterGlobals({&w}, &wind, {13.5, 0, -4.25}, 7);
    for (int i = 0; i < 50; ++i) {
        const glm::vec2 at(0.31f * static_cast<float>(i), 0.17f * static_cast<float>(i));
        EXPECT_NEAR(glm::distance(waterSlope(here, at, 1), waterSlope(there, at - glm::vec2(13.5f, -4.25f), 1)), 0,
                    1e-4f);
    }
}

TEST(NumericsWater, TheGlintIsAsBrightAsTheSunItMirrors) {
    // All that the sky's half sphere gets of a beam straight down: Fresnel's share of it.
    constexpr int kRows = 400;
    double sum = 0;
    for (int i = 0; i < kRows; ++i) {
        const double angle = (i + 0.5) / kRows * glm::radians(40.0);
        const glm::dvec3 toEye(std::sin(angle), std::cos(angle), 0);
        sum += f64::sunGlint(glm::dvec2(0), 0.004, toEye, glm::dvec3(0, 1, 0)) * std::cos(angle) * 2 * f64::kPi *
               std::sin(angle) * glm::radians(40.0) / kRows;
    }
    EXPECT_NEAR(sum / f64::kPi, f64::waterFresnel(1), 0.02 * f64::waterFresnel(1));
}

TEST(NumericsFlower, AsManyExistAsTheDensitySays) {
    for (const float density : {0.1f, 0.5f, 1.0f}) {
        int exist = 0;
        constexpr int kCells = 2000;
        for (int c = 0; c < kCells; ++c)
            for (uint32_t i = 0; i < 16; ++i) {
                const f32::Flower f = f32::flowerOf(c, -c, i, 15.5f, 3);
                exist += f.threshold <= density;
                EXPECT_GT(f.threshold, 0);
                EXPECT_TRUE(f.place.x >= 0 && f.place.x < 1 && f.place.y >= 0 && f.place.y < 1);
            }
        EXPECT_NEAR(static_cast<double>(exist) / kCells, 15.5 * static_cast<double>(density), 0.1);
    }
}

TEST(NumericsFlower, DistanceShrinksThemOneAfterTheOtherAndNeverJumps) {
    for (const float threshold : {0.05f, 0.3f, 0.6f}) {
        float last = f32::flowerSize(threshold, 0.6f, 1, 1, 1.7f);
        EXPECT_EQ(last, 1);
        for (int i = 1; i <= 1000; ++i) {
            const float size = f32::flowerSize(threshold, 0.6f, 1, 1 - static_cast<float>(i) / 1000, 1.7f);
            EXPECT_LT(std::abs(size - last), 0.02f);
            last = size;
        }
        EXPECT_EQ(last, 0);
    }
    EXPECT_EQ(f32::flowerSize(0.61f, 0.6f, 1, 1, 1.7f), 0);
    EXPECT_EQ(f32::flowerSize(0.5f, 0, 1, 1, 1.7f), 0);
}

// However few stand for all, and however many of those the distance leaves: as much is covered, up to the widest.
TEST(NumericsFlower, ThoseThatStandForOthersCoverAsMuchAndNoRankBeyondTheMostHasASize) {
    constexpr int kRanks = 200000;
    for (const float size : {1.0f, 0.97f, 0.7f, 0.3f, 0.1f, 0.02f}) {
        const float standing = f32::flowersStanding(size);
        for (const float kept : {1.0f, 0.6f}) {
            double covered = 0;
            for (int i = 0; i < kRanks; ++i) {
                const float rank = (static_cast<float>(i) + 0.5f) / kRanks,
                            one = f32::flowerSize(0.4f * rank, 0.4f, standing, kept, 1.7f);
                covered += static_cast<double>(one) * static_cast<double>(one) / kRanks;
                if (rank > f32::flowerRankMost(standing, kept) * 1.0001f) ASSERT_EQ(one, 0) << size << " " << rank;
            }
            EXPECT_NEAR(covered, 1, kept < 1 ? 0.12 : 0.02) << size << " " << kept;
        }
    }
    EXPECT_EQ(f32::flowersStanding(4), 1);
    EXPECT_GT(f32::flowersStanding(0), 0);
}

TEST(NumericsFlower, ItsPiecesAreSquareToEachOtherFromEverySide) {
    const glm::vec3 ways[] = {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {0.6f, 0.8f, 0}, {0, -1, 0}};
    for (const glm::vec3& toEye : ways) {
        const f32::FlowerFrame f = f32::flowerFrame({0, 0.3f, 0}, {1, 0}, toEye);
        EXPECT_NEAR(glm::dot(f.side, f.up), 0, 1e-5f);
        EXPECT_NEAR(glm::length(f.side), 1, 1e-5f);
        EXPECT_NEAR(glm::length(f.up), 1, 1e-5f);
        EXPECT_GE(glm::dot(f.face, toEye), -1e-5f) << "it turns its back";
    }
}

}  // namespace
}  // namespace sward::test
