// Small made pictures for the tests of metrics.
#pragma once
#include <gtest/gtest.h>

#include <random>

#include "metrics/picture.h"

namespace sward::test {

template <class F>
Picture made(int width, int height, F&& color) {
    Picture p{width, height, false, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) p.pixels.push_back(glm::vec3(color(x, y)));
    return p;
}
inline Picture plain(int width, int height, glm::vec3 color) {
    return made(width, height, [&](int, int) { return color; });
}
// Colours of their own for each pixel, within `spread` of middle gray, moved by `offset`.
inline Picture noise(int width, int height, unsigned seed, float spread = 0.4f, float offset = 0) {
    std::mt19937 random(seed);
    return made(width, height, [&](int, int) {
        const auto next = [&] { return 0.5f + offset + spread * (static_cast<float>(random() % 65536) / 32768 - 1); };
        const float r = next(), g = next(), b = next();
        return glm::vec3(r, g, b);
    });
}
inline PicturePair pairOf(Picture a, Picture b, const std::vector<float>& mask = {}) {
    auto p = pairPictures(std::move(a), std::move(b), mask);
    EXPECT_TRUE(p) << p.error().text();
    return p ? std::move(*p) : PicturePair{};
}

}  // namespace sward::test
