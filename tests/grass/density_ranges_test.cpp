#include "grass/density_ranges.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

const Tiling kOnce{{10, 10}, false};

TEST(DensityRanges, EachCellIsLookedAtOnceWhileItsMapStays) {
    DensityRanges r;
    const Map map({8, 8, 1, PixelType::U8});
    int looks = 0;
    const auto look = [&](int x, int z) { return rangeOf(r, x, z, [&] { return std::pair(float(++looks), 9.0f); }); };
    keepRangesOf(r, map, kOnce, 0.5);
    EXPECT_EQ(look(3, -4).first, 1);
    EXPECT_EQ(look(-4, 3).first, 2) << "another cell";
    keepRangesOf(r, map, kOnce, 0.5);
    EXPECT_EQ(look(3, -4), std::pair(1.0f, 9.0f));
    EXPECT_EQ(looks, 2);
}

TEST(DensityRanges, NothingIsKeptOfAnotherMapTilingOrCell) {
    DensityRanges r;
    Map map({8, 8, 1, PixelType::U8});
    float density = 0.25f;
    const auto look = [&](const Map& m, const Tiling& tiling, double side) {
        keepRangesOf(r, m, tiling, side);
        return rangeOf(r, 1, 1, [&] { return std::pair(density, density); }).first;
    };
    EXPECT_EQ(look(map, kOnce, 0.5), 0.25f);
    density = 0.5f;
    EXPECT_EQ(look(map, kOnce, 0.5), 0.25f);
    map.set(0, 0, 0, 1);
    EXPECT_EQ(look(map, kOnce, 0.5), 0.5f) << "painted since";
    density = 0.75f;
    EXPECT_EQ(look(map, {{10, 10}, true}, 0.5), 0.75f);
    density = 1;
    EXPECT_EQ(look(map, {{10, 10}, true}, 1), 1);
}

TEST(DensityRanges, AWalkAcrossALargeFieldKeepsNoMoreThanItsLimit) {
    DensityRanges r;
    const Map map({8, 8, 1, PixelType::U8});
    size_t most = 0;
    for (int x = 0; x < 400; ++x) {
        keepRangesOf(r, map, kOnce, 0.5);
        for (int z = 0; z < 1000; ++z) rangeOf(r, x, z, [] { return std::pair(0.0f, 1.0f); });
        most = std::max(most, r.cells.size());
    }
    EXPECT_LT(most, 140000u);
    EXPECT_GT(most, 1000u);
}

}  // namespace
}  // namespace sward
