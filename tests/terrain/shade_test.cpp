// Shadows of hills, as heights change: brought up to date where they changed, they are what they would be made anew.
#include "terrain/shade.h"

#include <gtest/gtest.h>

#include <random>

namespace sward {
namespace {

Terrain hills(int width, int height) {
    Terrain t;
    t.size = {400, 300};
    t.height.file = "a";
    t.height.map = Map({width, height, 1, PixelType::F32});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            t.height.map.set(x, y, 0,
                             8 * std::sin(static_cast<float>(x) * 0.05f) * std::cos(static_cast<float>(y) * 0.03f));
    return t;
}
void sculpt(Map& map, int x0, int y0, int size, float by) {
    for (int y = y0; y < std::min(y0 + size, map.info().height); ++y)
        for (int x = x0; x < std::min(x0 + size, map.info().width); ++x) map.set(x, y, 0, map.at(x, y) + by);
}
glm::vec3 sunAt(float turn, float up) { return glm::normalize(glm::vec3(std::cos(turn), up, std::sin(turn))); }

TEST(Shade, AHillThrowsItsShadowAwayFromTheSun) {
    Terrain t = hills(256, 192);
    for (int y = 0; y < 192; ++y)
        for (int x = 0; x < 256; ++x) t.height.map.set(x, y, 0, 0);
    sculpt(t.height.map, 120, 90, 10, 20);
    const HeightGrid hidden = hiddenHeights(shadeHeights(t), t.size, sunAt(0, 0.5f));  // the sun stands in +x
    const auto at = [&](int x, int y) { return hidden.metres[static_cast<size_t>(y * hidden.width + x)]; };
    EXPECT_GT(at(110, 95), 5);
    EXPECT_LT(at(140, 95), 1);
    EXPECT_LT(at(110, 120), 1);
}

TEST(Shade, WhatIsBroughtUpToDateEqualsWhatIsMadeAnew) {
    for (const float mapSize : {0.0f, 130.0f}) {
        std::mt19937 random(5);
        for (int round = 0; round < 24; ++round) {
            Terrain t = hills(700, 513);
            t.mapSize = mapSize;
            const float turn = static_cast<float>(round) * 0.7f;
            const glm::vec3 sun = sunAt(turn, 0.1f + 0.2f * static_cast<float>(round % 4));
            HeightGrid heights = shadeHeights(t), hidden = hiddenHeights(heights, t.size, sun);
            const Map before = t.height.map;
            sculpt(t.height.map, static_cast<int>(random() % 700), static_cast<int>(random() % 513), 30,
                   round % 2 ? 25.f : -25.f);
            const GridPart part = updateShadeHeights(heights, before, t);
            EXPECT_LT(part.x0, part.x1);
            EXPECT_EQ(heights.metres, shadeHeights(t).metres) << round;
            const HeightGrid old = hidden;
            updateHiddenHeights(hidden, heights, t.size, sun, part);
            EXPECT_EQ(hidden.metres, hiddenHeights(heights, t.size, sun).metres) << round;
            if (round % 2) EXPECT_NE(hidden.metres, old.metres) << round;
        }
    }
}

TEST(Shade, NothingChangedIsNothingDone) {
    const Terrain t = hills(300, 200);
    HeightGrid heights = shadeHeights(t);
    const GridPart part = updateShadeHeights(heights, t.height.map, t);
    EXPECT_GE(part.x0, part.x1);
    HeightGrid hidden = hiddenHeights(heights, t.size, sunAt(1, 1));
    const std::vector<float> was = hidden.metres;
    updateHiddenHeights(hidden, heights, t.size, sunAt(1, 1), part);
    EXPECT_EQ(hidden.metres, was);
    EXPECT_EQ(shadeHeights(Terrain{}).metres, std::vector<float>{0});
}

}  // namespace
}  // namespace sward
