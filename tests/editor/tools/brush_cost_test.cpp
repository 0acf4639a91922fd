// Blades under a brush, and those that a stroke brought.
#include "editor/tools/brush_cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sward {
namespace {

TEST(BrushCost, BladesUnderABrushAreThoseOfTheTexelsInItsDisc) {
    Map density({200, 160, 1, PixelType::U8});
    std::mt19937 random(9);
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 200; ++x) density.set(x, y, 0, static_cast<float>(random() % 256) / 255.0f);
    const MapScale scale{50, 40, false};  // texels of a quarter metre
    for (const auto& [cx, cz, radius] :
         {std::tuple{20.0, 15.0, 3.0}, {0.5, 39.0, 2.5}, {-1.0, 5.0, 0.5}, {25.1, 20.2, 0.05}}) {
        double hand = 0;
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 200; ++x)
                if (std::hypot((x + 0.5) / 4 - cx, (y + 0.5) / 4 - cz) <= radius)
                    hand += static_cast<double>(density.at(x, y)) * 3000 / 16;
        EXPECT_NEAR(bladesInDisc(density, 3000, scale, cx, cz, radius), hand, 1e-6 * hand + 1e-9);
    }
    Map full({2000, 2000, 1, PixelType::U8});
    for (int y = 0; y < 2000; ++y)
        for (int x = 0; x < 2000; ++x) full.set(x, y, 0, 1);
    const double disc = 3.14159265 * 40 * 40;
    EXPECT_NEAR(bladesInDisc(full, 10, {100, 100, false}, 50, 50, 40), disc * 10, disc * 10 * 0.01) << "sampled";
    EXPECT_NEAR(bladesInDisc(full, 10, {10, 10, true}, 0, 0, 1), 10 * 3.14159265, 0.1) << "across the repeat's edge";
    EXPECT_NEAR(bladesInDisc({}, 10, {100, 100, false}, 50, 50, 40), disc * 10, 1e-3);
}

TEST(BrushCost, AStrokesBladesAreTheDifferenceOfTheMaps) {
    Map before({300, 200, 1, PixelType::U8});
    before.set(5, 5, 0, 1);
    Map now = before;
    now.set(290, 190, 0, 1), now.set(5, 5, 0, 0), now.set(6, 6, 0, 1), now.set(140, 7, 0, 0.6f);
    const MapScale scale{30, 20, false};
    EXPECT_NEAR(bladesAdded(before, now, 1000, scale), 1000 * 0.01 * 1.6, 1e-4);
    EXPECT_NEAR(bladesAdded(now, before, 1000, scale), -1000 * 0.01 * 1.6, 1e-4);
    EXPECT_EQ(bladesAdded(now, now, 1000, scale), 0);
    EXPECT_NEAR(bladesAdded({}, before, 1, {300, 200, false}), 1 - 60000, 1e-6) << "no map is density 1";
}

TEST(BrushCost, AStrokesTimeIsTheGrasssTimesTheShareThatItAdds) {
    BrushCost cost;
    EXPECT_FALSE(strokeMs(cost, 1000)) << "there was no stroke";
    cost.stroke = 500;
    EXPECT_FALSE(strokeMs(cost, 1000)) << "nothing was measured";
    cost.grassMs = 8;
    EXPECT_EQ(strokeMs(cost, 1000), 4);
    EXPECT_FALSE(strokeMs(cost, 0)) << "no blade is in view";
    cost.stroke = -5000;
    EXPECT_EQ(strokeMs(cost, 1000), -8) << "no more than all of it goes";
}

}  // namespace
}  // namespace sward
