// Imprint: a picture's light times a height, added to the ground or set over a base.
#include <gtest/gtest.h>

#include <array>

#include "brushes/shape.h"
#include "editor/brushes/sculpted.h"

namespace sward {
namespace {

using namespace test;

// Light 0, 0.5 and 1 in thirds from left to right.
ShapePtr thirds() {
    std::vector<float> texels;
    for (int i = 0; i < 30 * 30; ++i) texels.push_back(static_cast<float>(i % 30 / 10) / 2);
    return makeShape("thirds", 30, 30, std::move(texels));
}
// Ground of 3 m, or what it becomes at the left, in the middle, at the right of the stamp; its base lies at 2 m.
std::array<double, 3> imprinted(PixelType type, HeightBlend blend, float metres, float strength = 1) {
    Map land = levelLand(128, type, 3);
    BrushSettings b = sculptor(type, metres, strength);
    b.shape = thirds(), b.blend = blend;
    Stamp s{64, 64, 30, 30};
    s.beginHeight = 2;
    paint(land, "imprint", s, b);
    EXPECT_NEAR(metresAt(land, 64, 20), 3, 1e-3) << "beyond the ring";
    return {metresAt(land, 42, 64), metresAt(land, 64, 64), metresAt(land, 86, 64)};
}
void near(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 2e-4) << i;
}

TEST(Imprint, AddsTakesTheHigherTheLowerOrReplaces) {
    for (const PixelType type : kHeightTypes) {
        near(imprinted(type, HeightBlend::Add, 4), {3, 5, 7});
        near(imprinted(type, HeightBlend::Add, -2), {3, 2, 1});
        near(imprinted(type, HeightBlend::Maximum, 4), {3, 4, 6});
        near(imprinted(type, HeightBlend::Minimum, 4), {2, 3, 3});
        near(imprinted(type, HeightBlend::Replace, 4), {2, 4, 6});
        near(imprinted(type, HeightBlend::Replace, 4, 0.5f), {2.5, 3.5, 4.5});
    }
}

TEST(Imprint, OnARangeThatRunsDownwardsTheHigherIsStillTheHigher) {
    Map land = mapOf(128, 128, PixelType::U16, 0.7f);  // 3 m
    BrushSettings b = brushOf(1, 0, 4);
    paintHeights(b, {10, -10});
    b.shape = thirds(), b.blend = HeightBlend::Maximum;
    Stamp s{64, 64, 30, 30};
    s.beginHeight = 2;
    paint(land, "imprint", s, b);
    EXPECT_NEAR(10 - 10 * static_cast<double>(land.at(42, 64)), 3, 1e-3);
    EXPECT_NEAR(10 - 10 * static_cast<double>(land.at(86, 64)), 6, 1e-3);
}

}  // namespace
}  // namespace sward
