// The brush that adds, and the one that subtracts as much.
#include "brushes/brush.h"

#include <gtest/gtest.h>

#include "editor/brushes/stamped.h"

namespace sward {
namespace {

using namespace test;

TEST(AddBrush, AddAndSubtractChangeTheCoreByTheirStrength) {
    for (const PixelType type : kTypes) {
        Map map = mapOf(300, 300, type, 0.4f);
        const float was = map.at(150, 150);
        paint(map, "add", {150, 150, 60, 60}, brushOf(0.2f));
        EXPECT_NEAR(map.at(150, 150), was + 0.2f, 0.51f / 255);
        EXPECT_NEAR(map.at(150 + 29, 150), was + 0.2f, 0.51f / 255);
        EXPECT_EQ(map.at(150 + 60, 150), was);
        paint(map, "subtract", {150, 150, 60, 60}, brushOf(0.2f));
        EXPECT_NEAR(map.at(150, 150), was, 1.1f / 255);
    }
}

TEST(AddBrush, HeightsMayLeaveZeroToOne) {
    Map map = mapOf(64, 64, PixelType::F32, 2);
    BrushSettings b = brushOf(1, 0);
    b.low = -100;
    b.high = 100;
    paint(map, "subtract", {32, 32, 10, 10}, b);
    EXPECT_FLOAT_EQ(map.at(32, 32), 1);
    b.value = -7;
    paint(map, "set", {32, 32, 10, 10}, b);
    EXPECT_FLOAT_EQ(map.at(32, 32), -7);
    EXPECT_EQ(map.at(60, 60), 2);
}

}  // namespace
}  // namespace sward
