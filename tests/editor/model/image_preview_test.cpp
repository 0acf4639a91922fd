// Small pictures of files: what they show, and what they say in numbers.
#include "model/image_preview.h"

#include <gtest/gtest.h>

#include "maps/map_io.h"
#include "support.h"

namespace sward {
namespace {

TEST(ImagePreview, ShowsTheUpperRowFirstFromTheLeastToTheGreatest) {
    test::TempDir dir;
    Map map({200, 100, 1, PixelType::F32});
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 200; ++x) map.set(x, y, 0, y < 50 ? -5.0f : 15.0f);
    ASSERT_TRUE(writeMap(dir / "a.exr", map));
    const ImagePreview p = previewOf((dir / "a.exr").string());
    EXPECT_EQ(p.error, "");
    EXPECT_EQ(p.width, 64);
    EXPECT_EQ(p.height, 32);
    ASSERT_EQ(p.pixels.size(), 64u * 32u);
    EXPECT_EQ(p.pixels.front(), 0xff000000u);
    EXPECT_EQ(p.pixels.back(), 0xffffffffu);
    EXPECT_EQ(p.low, -5);
    EXPECT_EQ(p.high, 15);
    EXPECT_EQ(describe(p), "200 x 100, floats, 1 channel, -5 to 15");
}

TEST(ImagePreview, ColoursAreAsTheyAreAndSmallImagesKeepTheirPixels) {
    Map map({3, 2, 3, PixelType::U8});
    map.set(1, 0, 0, 1), map.set(1, 0, 2, 0.6f);
    const ImagePreview p = previewOf(map);
    EXPECT_EQ(p.width, 3);
    EXPECT_EQ(p.pixels[1], 0xff9900ffu);
    EXPECT_EQ(p.pixels[0], 0xff000000u);
}

TEST(ImagePreview, SaysWhatIsWrongWithAFile) {
    test::TempDir dir;
    test::writeText(dir / "a.png", "nothing");
    const ImagePreview p = previewOf((dir / "a.png").string());
    EXPECT_NE(p.error.find("a.png"), std::string::npos);
    EXPECT_TRUE(p.pixels.empty());
    EXPECT_EQ(p.file, (dir / "a.png").string());
}

}  // namespace
}  // namespace sward
