// The bounds of the ground, as heights change under them.
#include "world/ground.h"

#include <gtest/gtest.h>

#include <random>

namespace sward {
namespace {

Terrain land(PixelType type, int width, int height) {
    Terrain t;
    t.size = {100, 80};
    t.heightRange = {-5, 45};
    t.height.file = "a";
    t.height.map = Map({width, height, 1, type});
    std::mt19937 random(3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) t.height.map.set(x, y, 0, static_cast<float>(random() % 1000) / 1000.0f);
    return t;
}

void expectSame(const HeightBounds& a, const HeightBounds& b) {
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
    EXPECT_EQ(a.parts, b.parts);
}

TEST(HeightBounds, AreThoseOfTheHeightsWithinEachPart) {
    for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::F32}) {
        const Terrain t = land(type, 300, 200);
        HeightBounds b;
        updateHeightBounds(b, t);
        for (int i = 0; i < 40; ++i) {
            const double x0 = 2.3 * i, z0 = 1.7 * i, x1 = x0 + 9, z1 = z0 + 7;
            const auto [low, high] = b.over(t.size, x0, z0, x1, z1);
            for (int k = 0; k < 100; ++k) {
                const double h = terrainHeight(t, x0 + (x1 - x0) * (k % 10) / 9.0, z0 + (z1 - z0) * (k / 10) / 9.0);
                EXPECT_GE(h, static_cast<double>(low) - 1e-4);
                EXPECT_LE(h, static_cast<double>(high) + 1e-4);
            }
        }
        const auto [offset, scale] = heightScale(t);
        float lowest = 1e9f, highest = -1e9f;
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 300; ++x) {
                const float h = static_cast<float>(offset + scale * static_cast<double>(t.height.map.at(x, y)));
                lowest = std::min(lowest, h), highest = std::max(highest, h);
            }
        EXPECT_EQ(b.low, lowest);
        EXPECT_EQ(b.high, highest);
    }
}

TEST(HeightBounds, FollowChangedTilesAsIfTheyWereMadeAnew) {
    for (const PixelType type : {PixelType::U16, PixelType::F32}) {
        Terrain t = land(type, 700, 513);
        HeightBounds followed;
        updateHeightBounds(followed, t);
        std::mt19937 random(8);
        for (int i = 0; i < 60; ++i) {
            const int x = static_cast<int>(random() % 700), y = static_cast<int>(random() % 513);
            t.height.map.set(x, y, 0, i % 2 ? 1.0f : 0.0f);
            if (i == 30) t.heightRange = {0, 10};
            HeightBounds fresh;
            updateHeightBounds(fresh, t);
            updateHeightBounds(followed, t);
            expectSame(followed, fresh);
        }
        t.height.map = land(type, 100, 90).height.map;
        HeightBounds fresh;
        updateHeightBounds(fresh, t);
        updateHeightBounds(followed, t);
        expectSame(followed, fresh);
        t.height = {};
        updateHeightBounds(followed, t);
        EXPECT_TRUE(followed.parts.empty());
    }
}

}  // namespace
}  // namespace sward
