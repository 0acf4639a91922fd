// The brush that roughens.
#include "brushes/brush.h"

#include <gtest/gtest.h>

#include "editor/brushes/stamped.h"

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

}  // namespace
}  // namespace sward
