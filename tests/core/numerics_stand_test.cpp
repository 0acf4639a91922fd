// What stands in the grass leans by the sum of what its place has, and by nothing where it has nothing.
#include <gtest/gtest.h>

#include "core/numerics.h"

namespace sward {
namespace {

f32::BladeStand windyClumps() {
    f32::BladeStand s = f32::emptyStand();
    s.paint = {0.6f, -0.8f}, s.leanAtFull = 0.5f;
    s.clump = {0.3f, -0.7f, 0.9f}, s.clumpLean = 0.25f, s.clumpHeight = 0.4f, s.clumpLightness = 0.2f;
    s.wind = {0.11f, 0.13f};
    return s;
}

TEST(NumericsStand, AnEmptyPlaceLeavesEverythingAsItIs) {
    const f32::BladeLean l = f32::leanOf(f32::emptyStand(), {0, 1});
    EXPECT_EQ(l.lean, glm::vec2(0));
    EXPECT_EQ(l.free, glm::vec2(0));
    EXPECT_EQ(l.scale, 1);
    EXPECT_EQ(l.lighter, 1);
}

TEST(NumericsStand, LeansBySumsAndScalesByProducts) {
    f32::BladeStand s = windyClumps();
    s.tall = 0.5f;
    const f32::BladeLean l = f32::leanOf(s, {1, 0});
    EXPECT_NEAR(l.lean.x, 0.6f * 0.5f + 0.3f * 0.25f + 0.11f, 1e-6f);
    EXPECT_NEAR(l.lean.y, -0.8f * 0.5f - 0.7f * 0.25f + 0.13f, 1e-6f);
    EXPECT_EQ(l.lean, l.free) << "nothing presses";
    EXPECT_NEAR(l.scale, (1 + 0.9f * 0.4f) * 0.5f, 1e-6f);
    EXPECT_NEAR(l.lighter, 1 + 0.9f * 0.2f, 1e-6f) << "a map of heights does not make it darker";
}

TEST(NumericsStand, WhatIsPressedWhollyLiesWhereItFacesAndIsPushed) {
    f32::BladeStand s = windyClumps();
    const f32::BladeLean before = f32::leanOf(s, {0, 1});
    s.push = {0.25f, 0.5f}, s.press = 1;
    const f32::BladeLean l = f32::leanOf(s, {0, 1});
    EXPECT_EQ(l.lean, glm::vec2(0.25f, 1.5f));
    EXPECT_EQ(l.free, before.free) << "what slices take for the rest of the field";
    EXPECT_EQ(l.scale, before.scale);
}

// Slices have the wind as a breeze, blades as their own: apart from the order of the sum they lean alike.
TEST(NumericsStand, ABreezeLeansAsTheSameWindDoes) {
    const f32::BladeStand own = windyClumps();
    f32::BladeStand shared = own;
    shared.breeze = own.wind, shared.wind = {0, 0};
    const glm::vec2 a = f32::leanOf(own, {1, 0}).lean, b = f32::leanOf(shared, {1, 0}).lean;
    EXPECT_LT(glm::length(a - b), 1e-6f);
    shared.breeze = {0, 0};
    EXPECT_GT(glm::length(a - f32::leanOf(shared, {1, 0}).lean), 0.1f);
}

}  // namespace
}  // namespace sward
