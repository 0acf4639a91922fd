#include "maps/distances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sward {
namespace {

TEST(Distances, AreThoseToTheNearestOfAllByHand) {
    constexpr int kWidth = 19, kHeight = 11;
    std::vector<uint8_t> texels(kWidth * kHeight);
    for (const auto& [x, y] : {std::pair{3, 2}, std::pair{4, 2}, std::pair{17, 9}})
        texels[static_cast<size_t>(y * kWidth + x)] = 1;
    const std::vector<float> d = distancesTo(texels, kWidth, kHeight, 1);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto to = [&](int i, int j) {
                return std::hypot(static_cast<float>(x - i), static_cast<float>(y - j));
            };
            EXPECT_NEAR(d[static_cast<size_t>(y * kWidth + x)], std::min({to(3, 2), to(4, 2), to(17, 9)}), 1e-5f);
        }
}

TEST(Distances, AreInfiniteWhereThereIsNone) {
    for (const float d : distancesTo(std::vector<uint8_t>(12), 4, 3, 1)) EXPECT_TRUE(std::isinf(d) && d > 0);
}

}  // namespace
}  // namespace sward
