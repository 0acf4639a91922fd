// Brushes on maps of forces: press, smooth, subtract.
#include <gtest/gtest.h>

#include <random>

#include "brushes/brush.h"
#include "tests/editor/brushes/stamped.h"
#include "tools/stroke.h"

namespace sward {
namespace {

using namespace test;

float pressStep(PixelType type) {
    return type == PixelType::U8 ? 3.f / 255 : type == PixelType::U16 ? 3.f / 65535 : 1e-5f;
}

// What acts: push x, z and press, times the share.
glm::dvec3 forceAt(const Map& m, int x, int y) {
    const double share = static_cast<double>(m.at(x, y, 3));
    return glm::dvec3(2 * m.at(x, y, 0) - 1, 2 * m.at(x, y, 1) - 1, m.at(x, y, 2)) * share;
}
Map pressMap(int side, PixelType type, const glm::vec4& texel = {0.5f, 0.5f, 0, 0}) {
    Map m({side, side, 4, type});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int c = 0; c < 4; ++c) m.set(x, y, c, texel[c]);
    return m;
}
TEST(Press, PushesAndPressesTheCoreAlongTheHeadingByItsStrength) {
    for (const PixelType type : kTypes)
        for (const float strength : {0.25f, 1.0f}) {
            Map m = pressMap(200, type);
            paint(m, "press", {100, 100, 60, 60, 7, 3, -4}, brushOf(strength));
            const glm::dvec3 f = forceAt(m, 100, 100);
            EXPECT_NEAR(f.x, 0.6 * strength, pressStep(type));
            EXPECT_NEAR(f.y, -0.8 * strength, pressStep(type));
            EXPECT_NEAR(f.z, strength, pressStep(type));
            EXPECT_EQ(forceAt(m, 100, 190), glm::dvec3(0));
            const glm::dvec3 edge = forceAt(m, 145, 100);
            EXPECT_GT(edge.z, 0.1 * strength);
            EXPECT_LT(edge.z, 0.9 * strength);
            EXPECT_NEAR(edge.x / edge.z, 0.6, 0.1) << "the edge is pushed the same way, only less";
        }
}

TEST(Press, WithoutAHeadingItPushesApart) {
    for (const PixelType type : kTypes) {
        Map m = pressMap(200, type);
        paint(m, "press", {100, 100, 60, 40}, brushOf(1, 0));
        for (const auto& [x, y] : {std::pair{140, 100}, {60, 100}, {100, 128}, {100, 72}, {128, 119}}) {
            const glm::dvec2 way((x + 0.5 - 100) / 60, (y + 0.5 - 100) / 40), push(forceAt(m, x, y));
            EXPECT_NEAR(glm::dot(glm::normalize(push), glm::normalize(way)), 1, 1e-3) << x << ' ' << y;
            EXPECT_NEAR(glm::length(push), std::min(glm::length(way) * 2, 1.0), 3 * pressStep(type)) << x << ' ' << y;
            EXPECT_NEAR(forceAt(m, x, y).z, 1, pressStep(type));
        }
        EXPECT_LT(glm::length(glm::dvec2(forceAt(m, 100, 100))), 0.05) << "in the middle there is no way out";
    }
}

TEST(Press, ItReplacesWhatWasThereBefore) {
    for (const PixelType type : kTypes) {
        Map m = pressMap(128, type);
        paint(m, "press", {64, 64, 50, 50, 1, 1, 0}, brushOf(1));
        paint(m, "press", {64, 64, 50, 50, 2, 0, -1}, brushOf(0.5f));
        const glm::dvec3 f = forceAt(m, 64, 64);
        EXPECT_NEAR(f.x, 0, pressStep(type));
        EXPECT_NEAR(f.y, -0.5, pressStep(type));
        EXPECT_NEAR(f.z, 0.5, pressStep(type));
    }
}

// What a texel of no share holds says nothing: it must not come to light at a stamp's edge.
TEST(Press, WhatNoShareHidesDoesNotComeToLight) {
    for (const PixelType type : kTypes)
        for (const glm::vec4 hidden : {glm::vec4(0), glm::vec4(0, 1, 1, 0)}) {
            Map m = pressMap(128, type, hidden), clean = pressMap(128, type);
            for (const char* mode : {"press", "smooth"}) {
                paint(m, mode, {64, 64, 40, 40, 3, 1, 0}, brushOf(0.8f, 1));
                paint(clean, mode, {64, 64, 40, 40, 3, 1, 0}, brushOf(0.8f, 1));
            }
            for (int x = 20; x < 108; ++x)
                EXPECT_LT(glm::length(forceAt(m, x, 60) - forceAt(clean, x, 60)), 4 * pressStep(type)) << x;
        }
}

TEST(Press, NoRadiusNoStrengthAndBrokenNumbersPaintNothing) {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const PixelType type : kTypes) {
        const Map before = pressMap(160, type, {0.9f, 0.3f, 0.5f, 0.6f});
        Map m = before;
        for (const double broken : {nan, inf}) paint(m, "press", {80, 80, 40, 40, 0, broken, 1}, brushOf(1));
        for (const char* mode : {"press", "smooth", "subtract"}) {
            paint(m, mode, {80, 80, 0, 0, 0, 1, 0}, brushOf(1));
            paint(m, mode, {80, 80, 40, 40, 3, 1, 0}, brushOf(0));
            paint(m, mode, {80, 80, 40, 40, 0, 1, 0}, brushOf(static_cast<float>(nan)));
        }
        EXPECT_TRUE(m.sameTiles(before));
    }
}

TEST(Press, SubtractLiftsWithoutTurningAndLeavesEmptyMapsAlone) {
    for (const PixelType type : kTypes) {
        Map m = pressMap(96, type, {0.8f, 0.1f, 0.9f, 1});
        const glm::dvec3 whole = forceAt(m, 48, 48);
        paint(m, "subtract", {48, 48, 40, 40}, brushOf(0.5f));
        EXPECT_LT(glm::length(forceAt(m, 48, 48) - whole * 0.5), 2 * pressStep(type));
        paint(m, "subtract", {48, 48, 40, 40}, brushOf(1));
        EXPECT_EQ(m.at(48, 48, 3), 0);
        const Map empty = pressMap(96, type);
        Map same = empty;
        paint(same, "subtract", {48, 48, 40, 40, 9}, brushOf(0.7f));
        EXPECT_TRUE(same.sameTiles(empty));
    }
}

TEST(Press, SmoothingKeepsForcesThatAgreeAndCancelsOpposites) {
    for (const PixelType type : kTypes) {
        Map same = pressMap(160, type, {0.8f, 0.1f, 0.9f, 0.7f});
        const glm::dvec3 before = forceAt(same, 80, 80);
        for (uint32_t i = 0; i < 10; ++i) paint(same, "smooth", {80, 80, 60, 60, i}, brushOf(0.7f));
        EXPECT_LT(glm::length(forceAt(same, 80, 80) - before), 2 * pressStep(type));
        Map m = pressMap(160, type);
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 160; ++x) m.set(x, y, 0, x % 2 ? 1.0f : 0.0f), m.set(x, y, 2, 1), m.set(x, y, 3, 1);
        for (uint32_t i = 0; i < 40; ++i) paint(m, "smooth", {80, 80, 60, 60, i}, brushOf(1, 0));
        EXPECT_LT(glm::length(glm::dvec2(forceAt(m, 80, 80))), 0.06);
        EXPECT_NEAR(forceAt(m, 80, 80).z, 1, 2 * pressStep(type)) << "still as flat";
    }
}

TEST(Press, WhateverIsPaintedStaysFiniteAndNoStrongerThanOne) {
    std::mt19937 random(4);
    const auto any = [&](double from, double to) { return std::uniform_real_distribution<>(from, to)(random); };
    for (const PixelType type : kTypes) {
        Map m = pressMap(180, type, {0, 0, 0, 0});
        for (uint32_t i = 0; i < 200; ++i) {
            const char* modes[] = {"press", "smooth", "subtract"};
            paint(m, modes[random() % 3], {any(0, 180), any(0, 180), any(0, 60), any(0, 60), i, any(-1, 1), any(-1, 1)},
                  brushOf(static_cast<float>(any(0, 1)), static_cast<float>(any(0, 1))));
        }
        for (int y = 0; y < 180; ++y)
            for (int x = 0; x < 180; ++x) {
                const glm::dvec3 f = forceAt(m, x, y);
                ASSERT_LE(glm::length(glm::dvec2(f)), 1 + 2 * pressStep(type));
                ASSERT_TRUE(f.z >= 0 && f.z <= 1);
            }
    }
}

// --- strokes

Map rolled(const std::vector<std::pair<double, double>>& points) {
    Map m = pressMap(256, PixelType::U16);
    BrushSettings b = brushOf(1, 0.3f);
    b.mode = "press", b.radius = 2;
    Stroke stroke(*findBrush("press"), b, {40, 40, false}, m.info(), 0);
    for (const auto& [x, z] : points) stroke.moveTo(x, z);
    stroke.end();
    stroke.pump(m, 0);
    return m;
}
glm::dvec3 forceAtMetres(const Map& m, double x, double z) {
    return forceAt(m, static_cast<int>(x * 6.4), static_cast<int>(z * 6.4));
}

TEST(Press, AStrokePushesTheWayItGoesFromItsFirstPointOn) {
    const Map m = rolled({{10, 20}, {30, 20}});
    for (const double x : {9.0, 10.0, 20.0, 30.0})
        EXPECT_LT(glm::length(forceAtMetres(m, x, 20) - glm::dvec3(1, 0, 1)), 1e-3) << x;
}

TEST(Press, ACurveTurnsThePushAndAClickPushesApartWhenItEnds) {
    std::vector<std::pair<double, double>> curve;
    for (int i = 0; i <= 90; ++i)
        curve.emplace_back(20 + 10 * std::sin(glm::radians(1.0 * i)), 20 - 10 * std::cos(glm::radians(1.0 * i)));
    const Map m = rolled(curve);
    EXPECT_GT(forceAtMetres(m, 20 + 10 * std::sin(0.2), 20 - 10 * std::cos(0.2)).x, 0.9);
    EXPECT_GT(forceAtMetres(m, 20 + 10 * std::sin(1.4), 20 - 10 * std::cos(1.4)).y, 0.9);
    const Map click = rolled({{20, 20}});
    EXPECT_GT(forceAtMetres(click, 21.2, 20).x, 0.9);
    EXPECT_LT(forceAtMetres(click, 18.8, 20).x, -0.9);
    Map waiting = pressMap(64, PixelType::U8);
    BrushSettings b = brushOf(1);
    b.mode = "press";
    Stroke stroke(*findBrush("press"), b, {10, 10, false}, waiting.info(), 0);
    stroke.end();  // before any point
    stroke.moveTo(5, 5);
    EXPECT_TRUE(stroke.idle()) << "it waits for a way to go";
}

}  // namespace
}  // namespace sward
