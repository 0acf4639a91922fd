// Brushes on maps of directions: comb, direction, smooth, subtract.
#include <gtest/gtest.h>

#include <random>

#include "brushes/brush.h"
#include "tests/editor/brushes/stamped.h"
#include "tools/stroke.h"

namespace sward {
namespace {

using namespace test;

float combStep(PixelType type) {
    return type == PixelType::U8 ? 2.f / 255 : type == PixelType::U16 ? 2.f / 65535 : 1e-6f;
}

glm::dvec2 leanAt(const Map& m, int x, int y) { return {m.at(x, y, 0) * 2 - 1, m.at(x, y, 1) * 2 - 1}; }

Map upright(int side, PixelType type) {
    Map m({side, side, 2, type});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int c = 0; c < 2; ++c) m.set(x, y, c, 0.5f);
    return m;
}
void lay(Map& m, int x, int y, const glm::dvec2& lean) {
    m.set(x, y, 0, static_cast<float>(lean.x / 2 + 0.5));
    m.set(x, y, 1, static_cast<float>(lean.y / 2 + 0.5));
}
TEST(Comb, LaysTheCoreAlongTheHeadingByItsStrength) {
    for (const PixelType type : kTypes)
        for (const float strength : {0.25f, 1.0f}) {
            Map m = upright(200, type);
            paint(m, "comb", {100, 100, 60, 60, 7, 3, -4}, brushOf(strength));
            const glm::dvec2 lean = leanAt(m, 100, 100);
            EXPECT_NEAR(lean.x, 0.6 * strength, combStep(type));
            EXPECT_NEAR(lean.y, -0.8 * strength, combStep(type));
            EXPECT_NEAR(glm::length(leanAt(m, 100, 190)), 0, 2 * combStep(type));
            const double edge = glm::length(leanAt(m, 100 + 45, 100));
            EXPECT_GT(edge, 0.1 * strength);
            EXPECT_LT(edge, 0.9 * strength);
        }
}

TEST(Comb, NoHeadingNoStrengthNoRadiusAndBrokenNumbersPaintNothing) {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const PixelType type : kTypes) {
        const Map before = upright(160, type);
        Map m = before;
        paint(m, "comb", {80, 80, 40, 40}, brushOf(1));
        for (const double broken : {nan, inf}) paint(m, "comb", {80, 80, 40, 40, 0, broken, 1}, brushOf(1));
        for (const char* mode : {"comb", "direction", "smooth", "subtract"}) {
            paint(m, mode, {80, 80, 0, 0, 0, 1, 0}, brushOf(1));
            paint(m, mode, {80, 80, 40, 40, 3, 1, 0}, brushOf(0));
            paint(m, mode, {80, 80, 40, 40, 0, 1, 0}, brushOf(static_cast<float>(nan)));
        }
        BrushSettings b = brushOf(1);
        b.angleDeg = static_cast<float>(nan);
        paint(m, "direction", {80, 80, 40, 40}, b);
        EXPECT_TRUE(m.sameTiles(before));
    }
}

TEST(Comb, AnglesGoClockwiseFromNorth) {
    const std::pair<float, glm::dvec2> known[] = {
        {0.f, {0, -1}}, {90.f, {1, 0}}, {180.f, {0, 1}}, {-90.f, {-1, 0}}, {450.f, {1, 0}}};
    for (const auto& [angle, wanted] : known) {
        Map m = upright(64, PixelType::U16);
        BrushSettings b = brushOf(1, 0);
        b.angleDeg = angle;
        paint(m, "direction", {32, 32, 20, 20}, b);
        EXPECT_NEAR(glm::length(leanAt(m, 32, 32) - wanted), 0, 1e-4) << angle;
    }
}

TEST(Comb, OnlyMapsOfTwoChannelsAreLaid) {
    for (const int channels : {1, 3, 4}) {
        const Map before({64, 64, channels, PixelType::U8});
        Map m = before;
        for (const char* mode : {"comb", "direction"}) paint(m, mode, {32, 32, 20, 20, 0, 1, 0}, brushOf(1));
        EXPECT_TRUE(m.sameTiles(before)) << channels;
    }
    const Map before = upright(64, PixelType::U16);
    Map m = before;
    for (const char* mode : {"add", "set", "noise"}) paint(m, mode, {32, 32, 20, 20, 0, 1, 0}, brushOf(1));
    EXPECT_TRUE(m.sameTiles(before));
}

TEST(Comb, SmoothingDirectionsThatAgreeKeepsTheirStrength) {
    for (const PixelType type : kTypes) {
        Map m = upright(160, type);
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 160; ++x) lay(m, x, y, {0.6, -0.8});
        const Map before = m;
        for (uint32_t i = 0; i < 10; ++i) paint(m, "smooth", {80, 80, 60, 60, i}, brushOf(0.7f));
        EXPECT_EQ(m.hash(), before.hash());
    }
}

TEST(Comb, SmoothingOppositeDirectionsGivesNoneAndNotAnother) {
    for (const PixelType type : kTypes) {
        Map m = upright(160, type);
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 160; ++x) lay(m, x, y, x % 2 ? glm::dvec2(1, 0) : glm::dvec2(-1, 0));
        for (uint32_t i = 0; i < 40; ++i) paint(m, "smooth", {80, 80, 60, 60, i}, brushOf(1, 0));
        for (int x = 60; x < 100; ++x) {
            EXPECT_LT(glm::length(leanAt(m, x, 80)), 0.06) << x;
            EXPECT_NEAR(leanAt(m, x, 80).y, 0, 2 * combStep(type)) << x;
        }
    }
}

TEST(Comb, SmoothingAcrossATurnGoesThroughTheMiddle) {
    Map m = upright(160, PixelType::U16);
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x) lay(m, x, y, x < 80 ? glm::dvec2(1, 0) : glm::dvec2(0, 1));
    for (uint32_t i = 0; i < 20; ++i) paint(m, "smooth", {80, 80, 70, 70, i}, brushOf(1));
    const glm::dvec2 middle = (leanAt(m, 79, 80) + leanAt(m, 80, 80)) / 2.0;
    EXPECT_NEAR(middle.x, middle.y, 0.02);
    EXPECT_GT(middle.x, 0.3);
}

TEST(Comb, SubtractMakesBladesStandUpAgainWithoutTurningThem) {
    for (const PixelType type : kTypes) {
        Map m = upright(96, type);
        for (int y = 0; y < 96; ++y)
            for (int x = 0; x < 96; ++x) lay(m, x, y, {0.6, -0.8});
        paint(m, "subtract", {48, 48, 40, 40}, brushOf(0.5f));
        EXPECT_NEAR(leanAt(m, 48, 48).x, 0.3, 2 * combStep(type));
        EXPECT_NEAR(leanAt(m, 48, 48).y, -0.4, 2 * combStep(type));
        paint(m, "subtract", {48, 48, 40, 40}, brushOf(1));
        EXPECT_NEAR(glm::length(leanAt(m, 48, 48)), 0, 2 * combStep(type));
    }
}

TEST(Comb, WhateverIsPaintedStaysFiniteAndNoLongerThanOne) {
    std::mt19937 random(4);
    const auto any = [&](double from, double to) { return std::uniform_real_distribution<>(from, to)(random); };
    for (const PixelType type : kTypes) {
        Map m = upright(180, type);
        for (uint32_t i = 0; i < 300; ++i) {
            BrushSettings b = brushOf(static_cast<float>(any(0, 1)), static_cast<float>(any(0, 1)));
            b.angleDeg = static_cast<float>(any(-700, 700));
            const char* modes[] = {"comb", "direction", "smooth", "subtract"};
            paint(m, modes[random() % 4], {any(0, 180), any(0, 180), any(0, 60), any(0, 60), i, any(-1, 1), any(-1, 1)},
                  b);
        }
        for (int y = 0; y < 180; ++y)
            for (int x = 0; x < 180; ++x) ASSERT_LE(glm::length(leanAt(m, x, y)), 1 + 2 * combStep(type));
    }
}

// --- headings of a stroke

Map combed(const std::vector<std::pair<double, double>>& points) {
    Map m = upright(256, PixelType::U16);
    BrushSettings b = brushOf(1, 0.3f);
    b.mode = "comb", b.radius = 2;
    Stroke stroke(*findBrush("comb"), b, {40, 40, false}, m.info(), 0);
    for (const auto& [x, z] : points) stroke.moveTo(x, z);
    stroke.pump(m, 0);
    return m;
}
glm::dvec2 leanAtMetres(const Map& m, double x, double z) {
    return leanAt(m, static_cast<int>(x * 6.4), static_cast<int>(z * 6.4));
}

TEST(Comb, AStrokeLaysTheWayItGoesFromItsFirstPointOn) {
    const Map m = combed({{10, 20}, {30, 20}});
    for (const double x : {9.0, 10.0, 20.0, 30.0}) {
        EXPECT_NEAR(leanAtMetres(m, x, 20).x, 1, 1e-3) << x;
        EXPECT_NEAR(leanAtMetres(m, x, 20).y, 0, 1e-3) << x;
    }
    EXPECT_NEAR(leanAtMetres(combed({{30, 20}, {10, 20}}), 20, 20).x, -1, 1e-3);
}

TEST(Comb, AClickThatGoesNowhereLaysNothing) {
    const Map before = upright(256, PixelType::U16);
    EXPECT_EQ(combed({{10, 20}}).hash(), before.hash());
    EXPECT_EQ(combed({{10, 20}, {10, 20}, {10, 20}}).hash(), before.hash());
}

TEST(Comb, AStrokeCutIntoPiecesLaysTheSame) {
    std::vector<std::pair<double, double>> pieces;
    for (int i = 0; i <= 160; ++i) pieces.emplace_back(10 + i * 0.125, 20);
    const Map whole = combed({{10, 20}, {30, 20}}), cut = combed(pieces);
    for (double x = 9; x < 31; x += 0.5)
        EXPECT_NEAR(glm::length(leanAtMetres(whole, x, 20) - leanAtMetres(cut, x, 20)), 0, 1e-3);
}

TEST(Comb, WholePixelsOfThePointerDoNotShowInTheHeading) {
    glm::dvec2 heading{0};
    for (int i = 0; i < 200; ++i) heading = headingAfter(heading, i % 2, 1 - i % 2, 0.02, 0.5);  // a diagonal in steps
    const glm::dvec2 unit = glm::normalize(heading);
    EXPECT_NEAR(unit.x, std::sqrt(0.5), 0.03);
    EXPECT_NEAR(unit.y, std::sqrt(0.5), 0.03);
    EXPECT_EQ(headingAfter({0.3, 0.4}, 0, 0, 0, 0.5), glm::dvec2(0.3, 0.4));
    EXPECT_LE(glm::length(headingAfter({1, 0}, -1, 0, 0.5 * std::log(2.0), 0.5)), 1e-12);  // turning back
}

}  // namespace
}  // namespace sward
