// The brush that erodes: what it takes it leaves elsewhere, and where.
#include <gtest/gtest.h>

#include <cmath>

#include "editor/brushes/sculpted.h"

namespace sward {
namespace {

using namespace test;

// A cone of this height in metres with its middle in the map's, a metre a texel.
Map cone(int side, PixelType type, double metres, double radius) {
    Map map = levelLand(side, type, 1);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double far = std::hypot(x + 0.5 - side / 2.0, y + 0.5 - side / 2.0),
                         h = 1 + std::max(0.0, metres * (1 - far / radius));
            map.set(x, y, 0, static_cast<float>(type == PixelType::F32 ? h : h / 10));
        }
    return map;
}
BrushSettings eroder(PixelType type, float water, float talusDeg, float radius) {
    BrushSettings b = sculptor(type, 1, 1, 0.3f);
    b.water = water, b.talusDeg = talusDeg, b.radius = radius;
    return b;
}
double moved(const Map& a, const Map& b) {
    double sum = 0;
    for (int y = 0; y < a.info().height; ++y)
        for (int x = 0; x < a.info().width; ++x) sum += std::abs(metresAt(a, x, y) - metresAt(b, x, y));
    return sum;
}
// Of neighbours along x and z within a part of the map.
double steepest(const Map& map, int from, int to) {
    double most = 0;
    for (int y = from; y < to; ++y)
        for (int x = from; x < to; ++x)
            most = std::max({most, std::abs(metresAt(map, x + 1, y) - metresAt(map, x, y)),
                             std::abs(metresAt(map, x, y + 1) - metresAt(map, x, y))});
    return most;
}

TEST(ErodeBrush, NoGroundComesOrGoes) {
    for (const PixelType type : kHeightTypes) {
        const Map before = cone(200, type, 8, 60);
        for (const float water : {0.0f, 1.0f}) {
            Map map = before;
            for (uint32_t turn = 0; turn < 20; ++turn)
                paint(map, "erode", {100, 100, 70, 70, turn}, eroder(type, water, 5, 70));
            const double shifted = moved(before, map);
            EXPECT_GT(shifted, 100) << water;
            // Floats round off; integers carry what is less than a step on by chance.
            EXPECT_NEAR(volume(map), volume(before), (type == PixelType::F32 ? 1e-4 : 1e-2) * shifted) << water;
        }
    }
}

TEST(ErodeBrush, SlopesSlideUntilTheyStandAtTheTalusAngle) {
    Map map = cone(80, PixelType::F32, 24, 15);  // 58 degrees
    const double limit = std::tan(35 * 3.14159265 / 180);
    EXPECT_GT(steepest(map, 20, 60), 1.5);
    for (uint32_t turn = 0; turn < 4000; ++turn)
        paint(map, "erode", {40, 40, 60, 60, turn}, eroder(PixelType::F32, 0, 35, 60));
    EXPECT_LT(steepest(map, 20, 60), 1.03 * limit);
    EXPECT_GT(steepest(map, 20, 60), 0.9 * limit);
    const Map calm = map;
    paint(map, "erode", {40, 40, 20, 20, 1}, eroder(PixelType::F32, 0, 60, 20));
    EXPECT_TRUE(map.sameTiles(calm)) << "no slope is as steep";
}

TEST(ErodeBrush, RainTakesFromAboveAndLeavesBelow) {
    const Map before = cone(200, PixelType::F32, 40, 80);
    Map map = before;
    for (uint32_t turn = 0; turn < 20; ++turn)
        paint(map, "erode", {100, 100, 95, 95, turn}, eroder(PixelType::F32, 1, 89, 95));
    double high = 0, low = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            const double change = metresAt(map, x, y) - metresAt(before, x, y);
            (metresAt(before, x, y) > 16 ? high : low) += change;
        }
    EXPECT_LT(high, -20);
    EXPECT_GT(low, 20);
}

TEST(ErodeBrush, NothingMovesOutsideTheRingAndLevelGroundStays) {
    const Map before = randomMap(200, 180, PixelType::F32, 5);
    Map map = before;
    paint(map, "erode", {190, 100, 40, 30, 3}, eroder(PixelType::F32, 1, 2, 40));
    int changed = 0;
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 200; ++x) {
            const double dx = (x + 0.5 - 190) / 40, dy = (y + 0.5 - 100) / 30;
            if (map.at(x, y) == before.at(x, y)) continue;
            ++changed;
            EXPECT_LT(dx * dx + dy * dy, 1.0);
        }
    EXPECT_GT(changed, 500);
    EXPECT_NEAR(volume(map), volume(before), 1e-2);
    Map level = levelLand(200, PixelType::F32, 3);
    const uint64_t was = level.hash();
    paint(level, "erode", {100, 100, 50, 50, 3}, eroder(PixelType::F32, 1, 35, 50));
    EXPECT_EQ(level.hash(), was);
}

TEST(ErodeBrush, TheSameStampGivesTheSameGroundAndAnotherNumberOtherGullies) {
    const Map before = cone(200, PixelType::F32, 40, 80);
    const auto eroded = [&](uint32_t turn, int seed) {
        Map map = before;
        BrushSettings b = eroder(PixelType::F32, 1, 35, 90);
        b.seed = seed;
        paint(map, "erode", {100, 100, 90, 90, turn}, b);
        return map.hash();
    };
    EXPECT_EQ(eroded(1, 0), eroded(1, 0));
    EXPECT_NE(eroded(1, 0), eroded(2, 0));
    EXPECT_NE(eroded(1, 0), eroded(1, 1));
}

}  // namespace
}  // namespace sward
