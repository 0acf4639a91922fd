// The brushes that level ground: flatten to a height, ramp from one to another.
#include <gtest/gtest.h>

#include "editor/brushes/sculpted.h"

namespace sward {
namespace {

using namespace test;

TEST(FlattenBrush, GroundBecomesLevelAndFlatteningItAgainChangesNothing) {
    for (const PixelType type : kHeightTypes) {
        Map map = randomMap(200, 200, type, 3);
        const BrushSettings b = sculptor(type, type == PixelType::F32 ? 0.37f : 3.7f);
        paint(map, "flatten", {100, 100, 50, 50}, b);
        const double level = metresAt(map, 100, 100);
        EXPECT_NEAR(level, static_cast<double>(b.value), 1e-4);
        for (int y = 70; y < 130; ++y)
            for (int x = 70; x < 130; ++x) ASSERT_EQ(metresAt(map, x, y), level);
        EXPECT_NE(metresAt(map, 100, 155), level);
        const Map once = map;
        BrushSettings core = b;
        paint(map, "flatten", {100, 100, 40, 40, 7}, core);
        EXPECT_TRUE(map.sameTiles(once)) << "within the level part";
    }
}

TEST(FlattenBrush, AWeakStampGoesItsShareOfTheWay) {
    Map map = levelLand(64, PixelType::F32, 2);
    paint(map, "flatten", {32, 32, 20, 20}, sculptor(PixelType::F32, 6, 0.25f));
    EXPECT_NEAR(metresAt(map, 32, 32), 3, 1e-5);
}

TEST(RampBrush, GoesEvenlyFromTheHeightOfOneEndToThatOfTheOther) {
    for (const PixelType type : kHeightTypes) {
        Map map = levelLand(300, type, 5);
        Stamp stamp{40.5, 50.5, 12, 12};
        stamp.acrossX = 200, stamp.acrossY = 150;
        stamp.beginHeight = 2, stamp.endHeight = 8;
        paint(map, "ramp", stamp, sculptor(type, 0, 1, 0.5f));
        EXPECT_NEAR(metresAt(map, 40, 50), 2, 2e-4);
        EXPECT_NEAR(metresAt(map, 240, 200), 8, 2e-4);
        for (int i = 0; i <= 10; ++i) EXPECT_NEAR(metresAt(map, 40 + 20 * i, 50 + 15 * i), 2 + 0.6 * i, 2e-4) << i;
        EXPECT_NEAR(metresAt(map, 40 + 100 - 3, 50 + 75 + 4), 5, 0.02) << "level across";
        EXPECT_EQ(metresAt(map, 40 + 100 - 9, 50 + 75 + 12), metresAt(map, 0, 0)) << "beyond its width";
        EXPECT_EQ(metresAt(map, 240 + 8, 200 + 10), metresAt(map, 0, 0)) << "beyond its end";
    }
}

TEST(RampBrush, WithoutALengthItLevelsADisc) {
    Map map = levelLand(64, PixelType::F32, 5);
    Stamp stamp{32, 32, 10, 10};
    stamp.beginHeight = 2, stamp.endHeight = 2;
    paint(map, "ramp", stamp, sculptor(PixelType::F32, 0));
    EXPECT_EQ(metresAt(map, 32, 32), 2);
    EXPECT_EQ(metresAt(map, 50, 32), 5);
}

}  // namespace
}  // namespace sward
