// Blades that are drawn straight show as much, as high, as bent ones (grass/blade_cover.h).
#include "grass/blade_cover.h"

#include <gtest/gtest.h>

#include "core/numerics.h"
#include "frame/color_image.h"

namespace sward::test {
namespace {

// The image of a blade whose width falls from 1 at the root by the square of v.
Rgba8 parabola(int rows) {
    Rgba8 image{1, rows, std::vector<uint8_t>(static_cast<size_t>(4 * rows), 255)};
    for (int y = 0; y < rows; ++y) {
        const double v = (y + 0.5) / rows;
        image.pixels[static_cast<size_t>(4 * y + 3)] = static_cast<uint8_t>(std::lround(255 * (1 - v * v)));
    }
    return image;
}
struct Sums {
    double area = 0;
    glm::vec3 middle{0}, reach{0};
};
// Of a bent blade's rows, as its image covers them.
Sums summed(const glm::vec3& control, const glm::vec3& tip) {
    constexpr int kRows = 4000;
    Sums s;
    for (int i = 0; i < kRows; ++i) {
        const float v = (static_cast<float>(i) + 0.5f) / kRows, alpha = 1 - v * v;
        const glm::vec3 way = 2.0f * (1 - 2 * v) * control + 2.0f * v * tip;
        s.area += double(alpha) / kRows;
        s.middle += alpha / kRows * f32::bladePosition(control, tip, v);
        s.reach += alpha / kRows * way;
    }
    s.middle /= float(s.area);
    return s;
}

TEST(BladeCover, MiddleAndReachAreThoseOfTheBentBlade) {
    SpeciesGlobals g{};
    setCover(g, alphaMoments(parabola(512)));
    for (const glm::vec3& control : {glm::vec3(0, 0.5f, 0), glm::vec3(0, 0.9f, 0), glm::vec3(0.1f, 0.8f, 0)}) {
        const glm::vec3 tip(0.4f, 1, 0);
        const Sums want = summed(control, tip);
        EXPECT_NEAR(glm::distance(g.middle.x * control + g.middle.y * tip, want.middle), 0, 2e-3f);
        EXPECT_NEAR(glm::distance(g.reach.x * control + g.reach.y * tip, want.reach), 0, 2e-3f);
        EXPECT_GT(glm::distance(0.5f * tip, want.middle), 0.05f) << "the straight line to the tip, which must lose";
    }
    EXPECT_NEAR(g.covered, 2.0 / 3, 2e-3);
    EXPECT_NEAR(g.middleRow, 0.375, 2e-3);
}

// Weighted as what is seen among other blades.
TEST(BladeCover, LightBetweenTheTwoRowsHasTheMeanOfThatAlongTheBlade) {
    SpeciesGlobals g{};
    setCover(g, alphaMoments(parabola(512)));
    const auto light = [](double v) { return 0.1 + 0.3 * v + 0.7 * v * v; };
    const double low = double(g.lightRow);
    const auto straight = [&](double v) { return light(low) + (v - low) / (1 - low) * (light(1) - light(low)); };
    double weights = 0, want = 0, drawn = 0, ends = 0;
    for (int i = 0; i < 1000; ++i) {
        const double v = (i + 0.5) / 1000, weight = (1 + 3 * v) * (1 - v * v);
        weights += weight, want += weight * light(v), drawn += weight * straight(v);
        ends += weight * (light(0) + v * (light(1) - light(0)));
    }
    EXPECT_NEAR(drawn / weights, want / weights, 2e-3);
    EXPECT_GT(std::abs(ends - want) / weights, 0.05) << "light of both ends, which must lose";
}

TEST(BladeCover, ImagesThatAreMissingOrClearAreFinite) {
    for (const Rgba8& image : {Rgba8{}, Rgba8{2, 2, std::vector<uint8_t>(16, 0)}}) {
        SpeciesGlobals g{};
        setCover(g, alphaMoments(image));
        EXPECT_NEAR(g.middleRow, 0.5f, 1e-5f);
        EXPECT_NEAR(g.lightRow, 5 / 12.0f, 1e-5f);
        EXPECT_TRUE(std::isfinite(g.reach.x) && g.covered > 0);
    }
}

TEST(BladeCover, ColorIsTheMeanOfWhatIsSeenOfTheImage) {
    Rgba8 image{2,
                2,
                {0, 0, 0, 255, 10, 20, 30, 0,               // the root: half of it clear
                 255, 255, 255, 255, 255, 255, 255, 255}};  // the tip
    const double root = 1 + 3 * 0.25, tip = 2 * (1 + 3 * 0.75);
    EXPECT_NEAR(double(meanColor(image).y), tip / (root + tip), 1e-5);
    image.pixels[0] = 188;
    EXPECT_NEAR(double(meanColor(image).x), (root * 0.5029 + tip) / (root + tip), 1e-3) << "means are of light";
    EXPECT_EQ(meanColor({}), glm::vec3(0.5f));
    EXPECT_EQ(meanColor({2, 2, std::vector<uint8_t>(16, 0)}), glm::vec3(0.5f)) << "clear";
}

TEST(BladeCover, TellsTheImagesAlphaByPartsOfItsLength) {
    const std::vector<float> parts = alphaAlong(parabola(800), 4);
    for (int i = 0; i < 4; ++i) {
        const double from = i / 4.0, to = (i + 1) / 4.0;
        EXPECT_NEAR(parts[static_cast<size_t>(i)], 1 - (to * to * to - from * from * from) / 3 * 4, 0.003) << i;
    }
    EXPECT_EQ(alphaAlong({}, 3), (std::vector<float>{1, 1, 1}));
    EXPECT_EQ(alphaAlong(parabola(1), 3).size(), 3u) << "more parts than rows";
}

}  // namespace
}  // namespace sward::test
