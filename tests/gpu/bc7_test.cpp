// Blocks of BC7: what comes back is near to what went in; nothing stays nothing.
#include "gpu/bc7.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics.h"

namespace sward {
namespace {

Bc7Texels along(const std::array<int, 4>& a, const std::array<int, 4>& b) {
    Bc7Texels t;
    for (size_t i = 0; i < 16; ++i)
        for (size_t c = 0; c < 4; ++c)
            t[i][c] = static_cast<uint8_t>(std::lround(a[c] + (b[c] - a[c]) * static_cast<double>(i) / 15));
    return t;
}

TEST(Bc7, NothingStaysNothing) { EXPECT_EQ(bc7Decoded(bc7Encoded({})), Bc7Texels{}); }

TEST(Bc7, ColoursOnALineComeBackWithinAStep) {
    for (const auto& [a, b] : {std::pair<std::array<int, 4>, std::array<int, 4>>{{0, 0, 0, 0}, {60, 90, 40, 200}},
                               {{250, 10, 30, 255}, {10, 250, 90, 255}},
                               {{80, 80, 80, 80}, {80, 80, 80, 80}}}) {
        const Bc7Texels in = along(a, b), out = bc7Decoded(bc7Encoded(in));
        for (size_t i = 0; i < 16; ++i)
            for (size_t c = 0; c < 4; ++c) EXPECT_NEAR(in[i][c], out[i][c], 4) << i << " " << c;
    }
}

TEST(Bc7, OfNoiseTheMeanErrorIsSmall) {
    double error = 0;
    for (uint32_t n = 0; n < 200; ++n) {
        Bc7Texels in;
        for (uint32_t i = 0; i < 16; ++i) {
            // Foliage: one hue, more or less of it, with some variation.
            const float much = f32::hashUnit(f32::hash3(n, i, 1)) * 200;
            for (uint32_t c = 0; c < 4; ++c)
                in[i][c] = static_cast<uint8_t>(much * (0.25f + 0.25f * static_cast<float>(c)) +
                                                10 * f32::hashUnit(f32::hash3(n, i, 2 + c)));
        }
        const Bc7Texels out = bc7Decoded(bc7Encoded(in));
        for (size_t i = 0; i < 16; ++i)
            for (size_t c = 0; c < 4; ++c) error += std::abs(in[i][c] - out[i][c]) / (200.0 * 64);
    }
    EXPECT_LT(error, 5);
    EXPECT_GT(error, 0.5) << "or nothing was tested";
}

TEST(Bc7, AnImagesEdgesAreRepeated) {
    const std::vector<uint8_t> rgba(4 * 5 * 3, 100);
    const std::vector<uint8_t> blocks = bc7Image(rgba.data(), 5, 3);
    ASSERT_EQ(blocks.size(), 32u);
    for (size_t b = 0; b < 2; ++b) {
        Bc7Block block;
        std::copy_n(blocks.begin() + static_cast<ptrdiff_t>(16 * b), 16, block.begin());
        for (const auto& texel : bc7Decoded(block))
            for (const uint8_t c : texel) EXPECT_NEAR(c, 100, 1);
    }
}

}  // namespace
}  // namespace sward
