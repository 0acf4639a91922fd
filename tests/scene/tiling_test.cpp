#include "scene/tiling.h"

#include <gtest/gtest.h>

#include "world/ground.h"

namespace sward {
namespace {

Map numbered(int side, PixelType type = PixelType::F32) {
    Map m({side, side, 1, type});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) m.set(x, y, 0, static_cast<float>((x * 31 + y * 17) % 64) / 63.0f);
    return m;
}
// The map n times along both sides, as texels.
Map laidOut(const Map& m, int n, bool mirrored) {
    const int side = m.info().width;
    Map out({side * n, side * n, 1, m.info().type});
    const auto inside = [&](int i) { return mirrored && (i / side) % 2 ? side - 1 - i % side : i % side; };
    for (int y = 0; y < side * n; ++y)
        for (int x = 0; x < side * n; ++x) out.set(x, y, 0, m.at(inside(x), inside(y)));
    return out;
}
Terrain terrainOf(double side) {
    Terrain t;
    t.size = {side, side};
    return t;
}

TEST(Tiling, AMapThatLiesOnTheTerrainOnceIsReadAsItWas) {
    const Map m = numbered(16);
    const Terrain t = terrainOf(40);
    const Tiling once = tilingOf(t, 1);
    EXPECT_FALSE(once.repeats);
    EXPECT_EQ(shaderTiling(t, 1), 0);
    for (double x = -3; x < 44; x += 0.73) {
        EXPECT_EQ(tiledSample(m, once, x, 40 - x), m.sample(x / 40, (40 - x) / 40));
        EXPECT_EQ(mirroredSample(m, once, x, 40 - x), m.sample(x / 40, (40 - x) / 40));
    }
}

TEST(Tiling, RepeatsAreThoseOfAMapLaidOutByHand) {
    const Map m = numbered(16), four = laidOut(m, 4, false), mirrored = laidOut(m, 4, true);
    const Terrain t = terrainOf(40);
    const Tiling tiling = tilingOf(t, 4);
    EXPECT_EQ(shaderTiling(t, 4), 4);
    for (double x = 1; x < 39; x += 0.37)  // the outermost half texel goes on with the other side's instead of its own
        for (double z = 1; z < 39; z += 0.91) {
            ASSERT_NEAR(tiledSample(m, tiling, x, z), four.sample(x / 40, z / 40), 1e-5f) << x << ' ' << z;
            ASSERT_NEAR(mirroredSample(m, tiling, x, z), mirrored.sample(x / 40, z / 40), 1e-5f) << x << ' ' << z;
        }
}

TEST(Tiling, MapSizeMakesTheTilingIndependentOfTheTerrain) {
    Terrain small = terrainOf(50), large = terrainOf(90000);
    small.mapSize = large.mapSize = 25;
    EXPECT_EQ(tilingOf(small, 2).metres, glm::dvec2(12.5));
    EXPECT_EQ(tilingOf(large, 2).metres, glm::dvec2(12.5));
    EXPECT_TRUE(tilingOf(small, 1).repeats);
    const Map m = numbered(16);
    EXPECT_EQ(tiledSample(m, tilingOf(small, 2), 31, 7), tiledSample(m, tilingOf(large, 2), 31, 7));
    EXPECT_NEAR(tiledSample(m, tilingOf(large, 2), 31 + 12.5 * 7000, 7), tiledSample(m, tilingOf(small, 2), 31, 7),
                1e-6f);
}

TEST(Tiling, HeightsHaveNoCliffAtTheirSeams) {
    Terrain t = terrainOf(160);
    Map slope({32, 32, 1, PixelType::F32});
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) slope.set(x, y, 0, static_cast<float>(x));  // 31 m from one side to the other
    t.height = {"maps/h.exr", slope};
    t.heightTiling = 4;
    double steepest = 0, highest = 0;
    for (double x = 0; x < 160; x += 0.1) {
        steepest = std::max(steepest, std::abs(terrainHeight(t, x + 0.1, 9) - terrainHeight(t, x, 9)) / 0.1);
        highest = std::max(highest, terrainHeight(t, x, 9));
    }
    EXPECT_NEAR(steepest, 32.0 / 40, 1e-3) << "the map's own slope";
    EXPECT_EQ(highest, 31);
}

TEST(Tiling, BoundsOfMirroredHeightsHoldEveryHeight) {
    Terrain t = terrainOf(300);
    t.height = {"maps/h.exr", numbered(200)};
    for (const float tiling : {0.3f, 1.7f, 4.0f, 33.3f}) {
        t.heightTiling = tiling;
        HeightBounds b;
        updateHeightBounds(b, t);
        int tight = 0;
        for (int i = 0; i < 400; ++i) {
            const double x = (i * 37) % 290, z = (i * 53) % 290, side = i % 2 ? 1.5 : 0.2 + i % 10;
            const auto [low, high] = b.over(t.size, x, z, x + side, z + side);
            tight += high - low < 0.999f;
            for (int k = 0; k < 25; ++k) {
                const double h = terrainHeight(t, x + side * (k % 5) / 4, z + side * (k / 5) / 4);
                ASSERT_GE(h, static_cast<double>(low) - 1e-6) << tiling << ' ' << i;
                ASSERT_LE(h, static_cast<double>(high) + 1e-6) << tiling << ' ' << i;
            }
        }
        if (tiling < 1) {
            EXPECT_GT(tight, 100) << "bounds that are always the whole map's cull nothing";
        }
    }
}

TEST(Tiling, BoundsFollowTheTilingAndTheRangeOfHeights) {
    Terrain t = terrainOf(100);
    t.height = {"maps/h.png", numbered(64, PixelType::U16)};
    t.heightRange = {0, 10};
    HeightBounds b;
    updateHeightBounds(b, t);
    EXPECT_NEAR(b.high, 10, 1e-3);
    t.heightRange = {5, 30};
    updateHeightBounds(b, t);
    EXPECT_NEAR(b.low, 5, 1e-3);
    EXPECT_NEAR(b.high, 30, 1e-3);
    t.heightTiling = 3;
    updateHeightBounds(b, t);
    EXPECT_NEAR(b.repeat.x, 100.0 / 3, 1e-5);
}

}  // namespace
}  // namespace sward
