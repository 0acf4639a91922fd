#include "frame/color_image.h"

#include <gtest/gtest.h>

#include "core/numerics.h"
#include "maps/map_io.h"
#include "support.h"

namespace sward {
namespace {

TEST(ColorImage, TransparentTexelsTakeTheColourOfTheirNearestOpaqueOnes) {
    Rgba8 image{5, 1, {0, 0, 0, 0, 0, 0, 0, 0, 10, 200, 30, 255, 0, 0, 0, 0, 0, 0, 0, 0}};
    dilateColor(image);
    for (size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(image.pixels[i * 4], 10) << i;
        EXPECT_EQ(image.pixels[i * 4 + 1], 200) << i;
        EXPECT_EQ(image.pixels[i * 4 + 3], i == 2 ? 255 : 0) << "alpha stays";
    }
}

TEST(ColorImage, AnImageWithoutOpaqueTexelsIsLeftAsItIs) {
    Rgba8 image{2, 1, {1, 2, 3, 0, 4, 5, 6, 0}};
    const auto before = image.pixels;
    dilateColor(image);
    EXPECT_EQ(image.pixels, before);
}

TEST(ColorImage, TheMadeBladeIsPointedAndHasNoDarkRim) {
    const Rgba8 blade = makeBladeImage(32, 128);
    const auto alphaOfRow = [&](int y) {
        int sum = 0;
        for (int x = 0; x < 32; ++x) sum += blade.pixels[static_cast<size_t>(y * 32 + x) * 4 + 3];
        return sum / 255.0;
    };
    EXPECT_GT(alphaOfRow(40), 20) << "wide below";
    EXPECT_LT(alphaOfRow(127), 3) << "pointed at the tip";
    for (size_t i = 0; i < blade.pixels.size(); i += 4)
        ASSERT_GT(blade.pixels[i], 60) << "a dark texel under transparency makes a halo";
}

TEST(ColorImage, RowsAreAddedBetweenThoseThatAreThere) {
    const Rgba8 image{1, 2, {0, 0, 0, 255, 200, 100, 50, 155}}, same = withRows(image, 2), tall = withRows(image, 4);
    EXPECT_EQ(same.pixels, image.pixels);
    ASSERT_EQ(tall.height, 4);
    EXPECT_EQ(tall.pixels, (std::vector<uint8_t>{0, 0, 0, 255, 50, 25, 13, 230, 150, 75, 38, 180, 200, 100, 50, 155}));
}

TEST(ColorImage, TheMadeSoilHasTheMeanThatTheShaderDoubles) {
    const Rgba8 soil = makeSoil(128);
    double sum = 0;
    for (size_t i = 1; i < soil.pixels.size(); i += 4) sum += f32::srgbDecode(soil.pixels[i] / 255.0f);
    EXPECT_NEAR(sum / (128 * 128), 0.5, 0.05);
}

TEST(ColorImage, AFileKeepsItsColoursAndOneThatIsMissingIsEmpty) {
    test::TempDir dir;
    ASSERT_TRUE(writeImagePng(dir / "t.png", 2, 1, 4, {200, 100, 50, 255, 0, 0, 0, 0}));
    const Rgba8 image = loadColorImage(dir / "t.png");
    ASSERT_EQ(image.width, 2);
    EXPECT_EQ(image.pixels, (std::vector<uint8_t>{200, 100, 50, 255, 200, 100, 50, 0}));
    EXPECT_TRUE(loadColorImage(dir / "gone.png").pixels.empty());
}

}  // namespace
}  // namespace sward
