// What slices' images send on average, against what is put into them.
#include "grass/image_light.h"

#include <gtest/gtest.h>

namespace sward::test {
namespace {

constexpr int kLevel = 2;
constexpr float kApart = 0.01f, kTop = 0.4f;

SliceTexel coloured(const glm::vec3& color) { return {color, 1, 1, {1, 0, 0, 0}, {1, 0, 0, 0}}; }
// Slices of one opacity from top to bottom, white in the upper half.
StandingImage halfWhite(float opacity) {
    StandingImage out;
    for (SliceRows& level : out.levels)
        for (auto& axis : level)
            for (size_t row = 0; row < kSliceRows; ++row)
                axis[row] = {{coloured(glm::vec3(row < kSliceRows / 2 ? 0.0f : 1.0f))}, opacity, opacity};
    out.top = kTop, out.width = out.height = 64;
    return out;
}
SliceStand standing() {
    SliceStand s;
    s.apart = kApart, s.across = 0.5f, s.steepest = 100;
    return s;
}
glm::vec3 alongX(float sine) { return {std::sqrt(1 - sine * sine), sine, 0}; }
float whiteShare(const RowShares& shares) {
    float sum = 0;
    for (const auto& axis : shares)
        for (size_t row = kSliceRows / 2; row < kSliceRows; ++row) sum += axis[row];
    return sum;
}
float all(const RowShares& shares) {
    float sum = 0;
    for (const auto& axis : shares)
        for (const float share : axis) sum += share;
    return sum;
}

TEST(ImageLight, AViewShowsRowsByWhatStandsOverThem) {
    constexpr float kOpacity = 0.05f, kSine = 0.5f;
    const RowShares seen = sharesSeen(halfWhite(kOpacity), kLevel, alongX(kSine), standing());
    EXPECT_NEAR(all(seen), 1, 1e-4f);
    const float met = kTop * std::sqrt(1 - kSine * kSine) / kSine / kApart,  // slices on the way down
        upper = 1 - std::pow(1 - kOpacity, met / 2), both = 1 - std::pow(1 - kOpacity, met);
    EXPECT_NEAR(whiteShare(seen), upper / both, 0.02f);
    EXPECT_LT(whiteShare(seen), 0.97f) << "else all views show the same";
    for (const float share : seen[1]) EXPECT_EQ(share, 0) << "slices across z are edge on";
}

TEST(ImageLight, OpaqueSlicesShowTheirTopsFromLowAndAllOfThemselvesFromAbove) {
    const StandingImage image = halfWhite(1);
    SliceStand stand = standing();
    EXPECT_NEAR(whiteShare(sharesSeen(image, kLevel, alongX(0.3f), stand)), 1, 1e-4f);
    stand.apart = 2 * kTop;  // a ray meets one at any height, or none
    EXPECT_NEAR(whiteShare(sharesSeen(image, kLevel, alongX(0.7071f), stand)), 0.5f, 0.12f);
}

TEST(ImageLight, WithoutSlicesNothingIsShown) {
    EXPECT_EQ(all(sharesSeen(halfWhite(0), kLevel, alongX(0.5f), standing())), 0);
    EXPECT_EQ(all(sharesSeen({}, kLevel, alongX(0.5f), standing())), 0);
}

// Rays take what they meet for as bright as the two slices that send most: among faint ones these are the first.
TEST(ImageLight, RaysShowMoreOfTheTopThanSlicesDo) {
    const StandingImage image = halfWhite(0.03f);
    SliceStand rays = standing();
    rays.traced = true, rays.steps = 1000;
    const float by = whiteShare(sharesSeen(image, kLevel, alongX(0.5f), standing())),
                traced = whiteShare(sharesSeen(image, kLevel, alongX(0.5f), rays));
    EXPECT_GT(traced, by + 0.1f);
    rays.steps = 4, rays.restShown = true, rays.across = 4;  // most of it is the rest, from the middle of the way on
    EXPECT_LT(whiteShare(sharesSeen(image, kLevel, alongX(0.5f), rays)), traced - 0.1f);
}

TEST(ImageLight, SidesAreLitAsTheyAreSeen) {
    StandingImage image = halfWhite(1);
    for (SliceRows& level : image.levels)
        for (auto& axis : level) axis.fill({{{glm::vec3(0.5f), 1, 1, {0.8f, 0, 0, 0}, {0.4f, 0, 0, 0}}}, 1, 1});
    FieldLight light;
    light.suns = {{{1, 0, 0}, {2, 2, 2}}};
    const RowsSend sends = rowsSend(image, kLevel, light, glm::vec3(0), 64);
    const RowShares seen = sharesSeen(image, kLevel, alongX(0.1f), standing());
    EXPECT_NEAR(sentAlong(seen, sends, alongX(0.1f)).y, 0.5f * 2 * 0.6f, 1e-4f) << "cells are mirrored both ways";
    EXPECT_NEAR(sentAlong(seen, sends, {-0.995f, 0.1f, 0}).y, 0, 1e-4f) << "the light comes from behind";
    light.translucency = 1;
    EXPECT_GT(sentAlong(seen, rowsSend(image, kLevel, light, glm::vec3(0), 64), {-0.995f, 0.1f, 0}).y, 0.1f);
    light.suns = {};
    EXPECT_NEAR(sentAlong(seen, rowsSend(image, kLevel, light, glm::vec3(3), 64), alongX(0.1f)).y, 1.5f, 1e-4f);
}

SliceImages baked(const glm::vec3& root, const glm::vec3& tip) {
    SliceSpec spec;
    spec.species.rootColor = root, spec.species.midColor = 0.5f * (root + tip), spec.species.tipColor = tip;
    spec.species.hueVariationDeg = spec.species.lightnessVariation = 0;
    spec.slices = 4, spec.width = 32, spec.height = 32, spec.farSize = 64;
    spec.blade = {1, 1, std::vector<uint8_t>(4, 255)};
    JobControl control;
    return *bakeSlices(spec, control);
}

TEST(ImageLight, RowsAreTheImagesFromTheGroundUp) {
    const DrawnImages images = drawnImagesOf(baked(glm::vec3(0), glm::vec3(0.3f)), true, SliceSets::Each, standing());
    for (const SliceRows& level : {images.standing.levels[0], images.standing.levels[1]})
        for (const auto& axis : level) {
            const auto mean = [](const SliceRow& row) {
                float sum = 0;
                for (const SliceTexel& t : row.texels) sum += t.color.y / static_cast<float>(row.texels.size());
                return sum;
            };
            EXPECT_GT(axis[0].opacity, 0.3f);
            EXPECT_LT(axis[kSliceRows - 1].opacity, axis[0].opacity) << "few blades reach the top";
            EXPECT_GT(mean(axis[5]), 2 * mean(axis[0]));
        }
}

TEST(ImageLight, KeyTellsColoursAndHowSlicesAreSeenApart) {
    const SliceImages dark = baked(glm::vec3(0.1f), glm::vec3(0.1f)), bright = baked(glm::vec3(0.1f), glm::vec3(0.3f));
    SliceStand rays = standing();
    rays.traced = true, rays.steps = 24;
    const uint64_t key = drawnImagesOf(dark, true, SliceSets::Each, standing()).key;
    EXPECT_EQ(drawnImagesOf(dark, true, SliceSets::Each, standing()).key, key);
    EXPECT_NE(drawnImagesOf(bright, true, SliceSets::Each, standing()).key, key);
    EXPECT_NE(drawnImagesOf(dark, true, SliceSets::Each, rays).key, key);
    EXPECT_NE(drawnImagesOf(dark, false, SliceSets::Each, standing()).key, key);
}

}  // namespace
}  // namespace sward::test
