// The brush that roughens.
#include "brushes/brush.h"

#include <gtest/gtest.h>

#include "editor/brushes/sculpted.h"

namespace sward {
namespace {

using namespace test;

TEST(NoiseBrush, NoiseIsTheSameForASeedAndUniform) {
    Map a({256, 256, 1, PixelType::U16}), b = a, c = a;
    BrushSettings brush = brushOf(1, 0, 0.8f);
    paint(a, "noise", {128, 128, 400, 400}, brush);
    paint(b, "noise", {128, 128, 400, 400, 9}, brush);
    paint(b, "noise", {128, 128, 400, 400, 10}, brush);
    brush.seed = 1;
    paint(c, "noise", {128, 128, 400, 400}, brush);
    for (int x = 0; x < 256; ++x) EXPECT_NEAR(a.at(x, 99), b.at(x, 99), 2.1f / 65535);
    EXPECT_NE(a.hash(), c.hash());
    EXPECT_NEAR(a.mean(), 0.4, 0.005);
}

TEST(NoiseBrush, OnHeightsItMakesBumpsOfTheirWidthThatNeitherRiseNorSinkAsAWhole) {
    for (const PixelType type : kHeightTypes) {
        const Map before = levelLand(512, type, 5);
        BrushSettings b = sculptor(type, 2);
        b.radius = 300, b.bumpSize = 40;
        Map map = before;
        paint(map, "noise", {256, 256, 300, 300}, b);
        double most = 0, jump = 0;
        for (int y = 100; y < 400; ++y)
            for (int x = 100; x < 400; ++x) {
                most = std::max(most, std::abs(metresAt(map, x, y) - 5));
                jump = std::max(jump, std::abs(metresAt(map, x + 1, y) - metresAt(map, x, y)));
            }
        EXPECT_GT(most, 0.7);
        EXPECT_LE(most, 2);
        EXPECT_LT(jump, 0.5) << "bumps, not single texels";
        EXPECT_NEAR(volume(map) / (512 * 512), 5, 0.05);
        Map again = before, other = before;
        paint(again, "noise", {256, 256, 300, 300}, b);
        EXPECT_EQ(again.hash(), map.hash());
        b.seed = 5;
        paint(other, "noise", {256, 256, 300, 300}, b);
        EXPECT_NE(other.hash(), map.hash());
        b.seed = 0, b.value = -2;
        paint(map, "noise", {256, 256, 300, 300}, b);
        for (int x = 100; x < 400; ++x) EXPECT_NEAR(metresAt(map, x, 256), 5, 5e-4) << "the same bumps, taken away";
    }
}

// A stamp in another tile goes on with the same bumps.
TEST(NoiseBrush, BumpsAreFixedToTheMap) {
    Map left = levelLand(512, PixelType::F32, 0), right = left;
    BrushSettings b = sculptor(PixelType::F32, 1);
    b.radius = 60, b.bumpSize = 30;
    paint(left, "noise", {240, 250, 60, 60}, b);
    paint(right, "noise", {270, 250, 60, 60}, b);
    for (int x = 240; x < 270; ++x) EXPECT_NEAR(left.at(x, 250), right.at(x, 250), 1e-5f);
}

}  // namespace
}  // namespace sward
