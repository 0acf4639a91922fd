#include "grass/mask.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics.h"
#include "grass/blade_cover.h"

namespace sward::test {
namespace {

Species dense() {
    Species s;
    s.bladesPerM2 = 20000;
    return s;
}
double mean(const BladeMask& m, int layer, int row, int channel) {
    double sum = 0;
    for (int x = 0; x < m.width; ++x) sum += m.at(layer, row, x)[channel] / 255.0;
    return sum / m.width;
}
BladeMask maskOf(const Species& s, float cellSize, int width) {
    return makeBladeMask(s, makePatch(s, cellSize, 1), cellSize, width, makeBladeImage(32, 128));
}

TEST(BladeMask, LetsThroughLessTheDenserTheNearerTheGroundAndTheLowerTheLight) {
    const BladeMask m = maskOf(dense(), 0.5f, 64);
    EXPECT_EQ(m.width, 64);
    for (size_t i = 0; i < m.pixels.size(); i += 4)
        for (size_t c = 1; c < 4; ++c) ASSERT_LE(m.pixels[i + c], m.pixels[i + c - 1]);
    const int middle = kMaskLayers / 3;  // light of 33 degrees
    for (int c = 0; c < 4; ++c) {
        EXPECT_EQ(mean(m, middle, m.height - 1, c), 1) << "above the blades all light passes";
        EXPECT_LT(mean(m, middle, m.height / 4, c), mean(m, middle, m.height * 3 / 4, c));
    }
    EXPECT_LT(mean(m, middle, 1, 3), 0.2);
    EXPECT_GT(mean(m, middle, m.height / 4, 0), mean(m, middle, m.height / 4, 3) + 0.2);
    for (int layer = 1; layer < kMaskLayers; ++layer)
        EXPECT_GT(mean(m, layer, m.height * 2 / 3, 3), mean(m, layer - 1, m.height * 2 / 3, 3) - 0.02) << layer;
}

// Beer's law through blades that stand anywhere but half a step about the point, in light of 45 degrees: what lies in
// its way is their area towards a level view, from as much higher as the light rises there.
TEST(BladeMask, LetsThroughWhatBeersLawSaysAtEveryHeightFacingAndDensity) {
    Species s;
    s.bladesPerM2 = 3000;
    s.height = 0.3f;
    s.heightVariation = 0, s.bend = 0, s.leanDeg = 0, s.leanVariationDeg = 0;
    const Rgba8 image = makeBladeImage(32, 128);
    const std::vector<float> alpha = alphaAlong(image, 64);
    struct Turned {
        const char* name;
        glm::vec2 facing;  // of all blades; 0: any
        double seen;       // share of their width
    };
    for (const Turned& turned :
         {Turned{"any way", {0, 0}, 2 / 3.14159265}, Turned{"broad side", {0, 1}, 1}, Turned{"edge", {1, 0}, 0}}) {
        Patch patch = makePatch(s, 1, 1);
        double width = 0;
        for (Blade& b : patch.blades) {
            width += double(b.width) / double(patch.blades.size());
            if (turned.facing != glm::vec2(0)) b.facing = turned.facing;
        }
        const BladeMask m = makeBladeMask(s, patch, 1, 128, image);
        const BladeShade shade = shadeBy(m);
        const float top = m.top / 1.05f, gap = 0.5f / std::sqrt(3000.0f) / top;
        for (const float high : {0.3f, 0.5f, 0.7f, 0.85f}) {
            double above = 0;
            for (size_t i = 0; i < alpha.size(); ++i)
                if ((static_cast<float>(i) + 0.5f) / 64 > high + gap) above += double(alpha[i]) / 64 * double(top);
            const double want = std::exp(-3000 * width * turned.seen * above);
            EXPECT_NEAR(maskPasses(shade, high * top, glm::normalize(glm::vec3(1, 1, 0))), want, 0.06)
                << turned.name << " at " << high;
        }
        for (Blade& b : patch.blades) b.threshold = 0.5f;
        const BladeMask half = makeBladeMask(s, patch, 1, 128, image);
        EXPECT_EQ(mean(half, 4, 0, 0), 1) << "none exists at a density of 1/4";
        EXPECT_NEAR(mean(half, 4, 40, 1), mean(half, 4, 40, 3), 1e-9) << "all do at 1/2";
    }
}

TEST(BladeMask, IsTheSameEveryTimeAndSoundForSpeciesWithoutBladesOrSize) {
    EXPECT_EQ(maskOf(dense(), 0.5f, 64).pixels, maskOf(dense(), 0.5f, 64).pixels);
    Species none, flat = dense(), giant = dense();
    none.bladesPerM2 = 0;
    flat.height = 0;
    giant.height = 20;
    giant.bladesPerM2 = 1e5f;
    for (const Species& odd : {none, flat, giant}) {
        const BladeMask m = maskOf(odd, 0.1f, 16);
        EXPECT_GT(m.radius, 0);
        EXPECT_GT(m.top, 0);
        EXPECT_EQ(m.pixels.size(), static_cast<size_t>(m.width) * static_cast<size_t>(m.height) * kMaskLayers * 4);
        EXPECT_GE(m.height, 4);
        for (int layer = 0; layer < kMaskLayers; ++layer) EXPECT_EQ(mean(m, layer, m.height - 1, 3), 1);
    }
}

}  // namespace
}  // namespace sward::test
