#include "grass/slice_gains.h"

#include <gtest/gtest.h>

namespace sward::test {
namespace {

// As lib/slices.glsl unpacks it.
glm::vec3 unpacked(uint32_t bits, float scale) {
    return glm::vec3(bits & 1023u, bits >> 10 & 1023u, bits >> 20) * (scale / 1023.0f);
}

TEST(SliceGains, PackedFactorsAreWithinHalfAStepOfTheGreatest) {
    SliceGlobals g{};
    Gains gains{};
    for (int i = 0; i < LOOK_VIEWS; ++i) {
        const float f = static_cast<float>(i) / LOOK_VIEWS;
        gains.slices[static_cast<size_t>(i)] = {0.3f + f, 1.7f - f, f * f};
        gains.far[static_cast<size_t>(i)] = {5 * f, 0, 0.01f};
        gains.thin[static_cast<size_t>(i)] = {0.5f * f, f, 2 * f};
        gains.laid[static_cast<size_t>(i)] = {0.2f, 0.1f, 0.05f * f};
        gains.paintAcross[static_cast<size_t>(i)] = {1, 2 * f, 0.5f};
        gains.leans[3][static_cast<size_t>(i)] = {-0.25f, f, 0.5f};
    }
    setGains(g, true, gains);
    EXPECT_FLOAT_EQ(g.gainScale.x, 1.7f);
    for (size_t i = 0; i < LOOK_VIEWS; ++i) {
        const glm::vec3 off[] = {unpacked(g.gains[i].across, g.gainScale.x) - gains.slices[i],
                                 unpacked(g.gains[i].above, g.gainScale.y) - gains.far[i],
                                 unpacked(g.gains[i].laid, g.gainScale.z) - gains.laid[i],
                                 unpacked(g.gains[i].thin, g.gainScale.w) - gains.thin[i]};
        for (int k = 0; k < 4; ++k)
            for (int c = 0; c < 3; ++c) EXPECT_LE(std::abs(off[k][c]), 0.501f * g.gainScale[k] / 1023) << i << k << c;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(unpacked(g.gains[i].paintAcross, float(PAINT_SCALE))[c], gains.paintAcross[i][c], 0.0021f)
                << i << c;
        const glm::vec3 lean = 2.0f * unpacked(g.gains[i].leanZZ, g.leanScale) - g.leanScale - gains.leans[3][i];
        for (int c = 0; c < 3; ++c) EXPECT_LE(std::abs(lean[c]), 1.001f * g.leanScale / 1023) << i << c;
    }
}

TEST(SliceGains, WhatIsOutOfRangeIsClampedAndDoesNotSpillIntoTheNextColour) {
    EXPECT_EQ(packedGain({2, -1, 1}, 1), 1023u | 1023u << 20);
}

TEST(SliceGains, AsPublishedAreOneFromEveryView) {
    SliceGlobals g{};
    setGains(g, false, {});
    for (const LookGain& gain : g.gains) {
        for (const uint32_t bits : {gain.across, gain.above, gain.laid})
            EXPECT_EQ(unpacked(bits, g.gainScale.x), glm::vec3(1));
        EXPECT_NEAR(2.0f * unpacked(gain.leanX, g.leanScale).y - g.leanScale, 0, 1e-6f);
    }
}

}  // namespace
}  // namespace sward::test
