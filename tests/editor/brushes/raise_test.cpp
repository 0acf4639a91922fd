// The brushes that raise and lower ground.
#include <gtest/gtest.h>

#include "editor/brushes/sculpted.h"

namespace sward {
namespace {

using namespace test;

TEST(RaiseBrush, AStampRaisesAndLowersByMetresTimesStrengthWhateverTheMapIsMadeOf) {
    for (const PixelType type : kHeightTypes) {
        Map map = levelLand(200, type, 4);
        paint(map, "raise", {100, 100, 40, 40}, sculptor(type, 3, 0.5f, 0.5f));
        EXPECT_NEAR(metresAt(map, 100, 100), 5.5, 2e-4);
        EXPECT_NEAR(metresAt(map, 119, 100), 5.5, 2e-4) << "within the core";
        EXPECT_GT(metresAt(map, 130, 100), 4.1);
        EXPECT_LT(metresAt(map, 130, 100), 5.4);
        EXPECT_NEAR(metresAt(map, 141, 100), 4, 1e-4);
        paint(map, "lower", {100, 100, 40, 40}, sculptor(type, 3, 0.5f, 0.5f));
        for (int x = 50; x < 150; ++x) EXPECT_NEAR(metresAt(map, x, 100), 4, 4e-4) << x;
    }
}

TEST(RaiseBrush, IntegersEndWithTheirRangeAndFloatsGoOn) {
    Map whole = levelLand(64, PixelType::U16, 9), fine = levelLand(64, PixelType::F32, 9);
    paint(whole, "raise", {32, 32, 10, 10}, sculptor(PixelType::U16, 5));
    paint(fine, "raise", {32, 32, 10, 10}, sculptor(PixelType::F32, 5));
    EXPECT_EQ(metresAt(whole, 32, 32), 10);
    EXPECT_NEAR(metresAt(fine, 32, 32), 14, 1e-5);
    paint(whole, "lower", {32, 32, 10, 10}, sculptor(PixelType::U16, 50));
    paint(fine, "lower", {32, 32, 10, 10}, sculptor(PixelType::F32, 50));
    EXPECT_EQ(metresAt(whole, 32, 32), 0);
    EXPECT_NEAR(metresAt(fine, 32, 32), -36, 1e-4);
}

TEST(RaiseBrush, ChangesSmallerThanAStepOfIntegersAddUpOverStamps) {
    Map map = levelLand(64, PixelType::U16, 5);
    for (uint32_t turn = 0; turn < 1000; ++turn)
        paint(map, "raise", {32, 32, 10, 10, turn}, sculptor(PixelType::U16, 2e-5f));  // an eighth of a step
    EXPECT_NEAR(metresAt(map, 32, 32), 5.02, 4e-4);
}

TEST(RaiseBrush, ARangeThatRunsDownwardsIsSculptedTheRightWayUp) {
    Map map = mapOf(64, 64, PixelType::U16, 0.5f);
    BrushSettings b = brushOf(1, 0, 2);
    paintHeights(b, {10.0, -10.0});
    const float before = map.at(32, 32);
    paint(map, "raise", {32, 32, 10, 10}, b);
    EXPECT_NEAR(map.at(32, 32), before - 0.2f, 2e-5);
    b.metres.y = 0;
    Map flat = mapOf(64, 64, PixelType::U16, 0.5f);
    paint(flat, "raise", {32, 32, 10, 10}, b);
    EXPECT_EQ(flat.at(32, 32), before) << "a range that spans nothing";
}

}  // namespace
}  // namespace sward
