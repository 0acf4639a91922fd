#include "grass/mask.h"

#include <gtest/gtest.h>

namespace sward::test {
namespace {

Species dense() {
    Species s;
    s.bladesPerM2 = 20000;
    return s;
}
double mean(const BladeMask& m, int row, int channel) {
    double sum = 0;
    for (int x = 0; x < m.width; ++x) sum += m.pixels[static_cast<size_t>((row * m.width + x) * 4 + channel)] / 255.0;
    return sum / m.width;
}

TEST(BladeMask, LetsThroughLessTheDenserAndTheNearerTheGround) {
    const Species s = dense();
    const BladeMask m = makeBladeMask(s, makePatch(s, 0.5f, 1), 0.5f, 64);
    EXPECT_EQ(m.width, 64);
    for (size_t i = 0; i < m.pixels.size(); i += 4)
        for (size_t c = 1; c < 4; ++c) ASSERT_LE(m.pixels[i + c], m.pixels[i + c - 1]);
    for (int c = 0; c < 4; ++c) {
        EXPECT_EQ(mean(m, m.height - 1, c), 1) << "above the blades all light passes";
        EXPECT_LT(mean(m, 0, c), mean(m, m.height * 3 / 4, c));
    }
    EXPECT_LT(mean(m, 1, 3), 0.2);
    EXPECT_GT(mean(m, 1, 0), mean(m, 1, 3) + 0.2);
}

TEST(BladeMask, HidesByOneBladeWhatItsWidthSays) {
    Species s;
    s.bladesPerM2 = 100;
    s.height = 0.2f;
    Patch p;
    Blade b{};
    b.root = {0.1f, 0.05f};
    b.width = 0.02f;
    b.threshold = 0.5f;
    b.control = {0, 0.1f, 0};
    b.tip = {0, 0.2f, 0};
    b.facing = {0, 1};  // seen from its broad side
    p.blades = {b};
    const BladeMask m = makeBladeMask(s, p, 10, 256);
    EXPECT_FLOAT_EQ(m.radius, 0.15f) << "one and a half times the spacing";
    EXPECT_FLOAT_EQ(m.top, 0.21f);
    EXPECT_EQ(mean(m, 0, 0), 1) << "it does not exist at a density of 1/4";
    EXPECT_NEAR(1 - mean(m, 0, 1), 0.02 / (6.2831853 * 0.15), 0.002);
    const int half = static_cast<int>(m.height * 0.1 / 0.21);
    EXPECT_NEAR(1 - mean(m, half, 3), 0.75 * 0.02 / (6.2831853 * 0.15), 0.003) << "it tapers";
    p.blades[0].facing = {1, 0};
    EXPECT_EQ(mean(makeBladeMask(s, p, 10, 256), 0, 3), 1) << "seen edge-on it hides nothing";
}

TEST(BladeMask, IsTheSameEveryTimeAndSoundForSpeciesWithoutBladesOrSize) {
    const Species s = dense();
    EXPECT_EQ(makeBladeMask(s, makePatch(s, 0.5f, 1), 0.5f, 64).pixels,
              makeBladeMask(s, makePatch(s, 0.5f, 1), 0.5f, 64).pixels);
    Species none, flat = dense(), giant = dense();
    none.bladesPerM2 = 0;
    flat.height = 0;
    giant.height = 20;
    giant.bladesPerM2 = 1e5f;
    for (const Species& odd : {none, flat, giant}) {
        const BladeMask m = makeBladeMask(odd, makePatch(odd, 0.1f, 1), 0.1f, 16);
        EXPECT_GT(m.radius, 0);
        EXPECT_GT(m.top, 0);
        EXPECT_EQ(m.pixels.size(), static_cast<size_t>(m.width) * static_cast<size_t>(m.height) * 4);
        EXPECT_GE(m.height, 4);
        EXPECT_EQ(mean(m, m.height - 1, 3), 1);
    }
}

}  // namespace
}  // namespace sward::test
