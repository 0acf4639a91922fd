// The brush that smooths.
#include "brushes/brush.h"

#include <gtest/gtest.h>

#include <cmath>

#include "editor/brushes/stamped.h"

namespace sward {
namespace {

using namespace test;

// Direct mean over the square, from the map as it was: what smooth must paint towards in every tile.
float meanAround(const Map& map, int x, int y, int reach) {
    double sum = 0;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) sum += map.at(x + i, y + j);
    return float(sum / ((2 * reach + 1) * (2 * reach + 1)));
}

TEST(SmoothBrush, SmoothReadsTheStateBeforeTheStampAcrossTilesAndEdges) {
    for (const PixelType type : kTypes) {
        const Map before = randomMap(270, 260, type, 9);
        Map map = before;
        paint(map, "smooth", {250, 130, 60, 60}, brushOf(1, 0));
        const float step = type == PixelType::U8 ? 0.51f / 255 : 0.51f / 65535;
        const int reach = 8;  // 60 / 8, rounded
        for (const auto& [x, y] : {std::pair{250, 130}, {255, 127}, {256, 128}, {269, 130}, {215, 110}, {230, 170}})
            EXPECT_NEAR(map.at(x, y), meanAround(before, x, y, reach), step + 1e-6f) << x << "," << y;
    }
}

TEST(SmoothBrush, SmoothLeavesAFlatMapExactlyAsItIs) {
    for (const PixelType type : kTypes) {
        const Map before = mapOf(300, 300, type, 0.7f);
        Map map = before;
        for (uint32_t i = 0; i < 20; ++i) paint(map, "smooth", {150, 20, 250, 250, i}, brushOf(0.37f));
        EXPECT_EQ(map.hash(), before.hash());
    }
}

TEST(SmoothBrush, SmoothEvensOutAndKeepsTheMean) {
    Map map = randomMap(256, 256, PixelType::U16, 4);
    const double mean = map.mean();
    const auto roughness = [&] {
        double sum = 0;
        for (int x = 100; x < 150; ++x) sum += std::abs(map.at(x, 128) - map.at(x + 1, 128));
        return sum;
    };
    const double rough = roughness();
    for (uint32_t i = 0; i < 10; ++i) paint(map, "smooth", {128, 128, 100, 100, i}, brushOf(0.5f));
    EXPECT_LT(roughness(), rough / 20);
    EXPECT_NEAR(map.mean(), mean, 0.003);
}

}  // namespace
}  // namespace sward
