// Plots as descriptions: bars and ticks; lines and texts are seen in the plots of their own tests.
#include "cost/plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

TEST(Plot, TicksAreMultiplesOfOneTwoOrFiveWithinTheirRange) {
    EXPECT_EQ(evenTicks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(evenTicks(-1, 1, 4), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
    for (const double v : evenTicks(0, 0.037, 6)) EXPECT_FALSE(std::signbit(v)) << "0 has no sign";
    const std::vector<double> fine = evenTicks(0.0012, 0.0029, 8);
    ASSERT_EQ(fine.size(), 3u) << "the next finer step would give more than 8";
    EXPECT_NEAR(fine[0], 0.0015, 1e-12);
    EXPECT_NEAR(fine[2], 0.0025, 1e-12);
}

TEST(Plot, ABarFillsItsCornersAndNoMore) {
    Plot plot;
    plot.width = 20, plot.height = 10;
    plot.bars.push_back({{5, 2}, {9, 8}, "#ff0000"});
    const std::vector<uint8_t> pixels = plotPixels(plot);
    const auto green = [&](int x, int y) { return int(pixels[static_cast<size_t>(3 * (y * 20 + x) + 1)]); };
    EXPECT_EQ(green(6, 4), 0);
    EXPECT_EQ(green(5, 2), 0);
    EXPECT_EQ(green(8, 7), 0);
    for (const auto& [x, y] : {std::pair{4, 4}, std::pair{9, 4}, std::pair{6, 1}, std::pair{6, 8}})
        EXPECT_EQ(green(x, y), 255) << x << ' ' << y;
    EXPECT_NE(plotSvg(plot).find("<rect x=\"5.0\" y=\"2.0\" width=\"4.0\" height=\"6.0\" fill=\"#ff0000\"/>"),
              std::string::npos);
}

}  // namespace
}  // namespace sward
