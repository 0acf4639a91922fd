// Image files: what is written comes back.
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

#include "maps/map_io.h"
#include "tests/support.h"

namespace sward::test {
namespace {

TEST(Images, PngAndExrComeBackAsWritten) {
    TempDir dir;
    const std::vector<uint8_t> bytes{0, 51, 255, 102, 153, 204};
    ASSERT_TRUE(writeImagePng(dir / "i.png", 2, 1, 3, bytes));
    const Result<Image> png = readImage(dir / "i.png");
    ASSERT_TRUE(png);
    EXPECT_EQ(png->channels, 3);
    EXPECT_FALSE(png->linear);
    for (size_t i = 0; i < bytes.size(); ++i) EXPECT_EQ(png->pixels[i], float(bytes[i]) / 255.0f);
    const std::vector<float> floats{0.25f, 3, std::numeric_limits<float>::infinity()};
    ASSERT_TRUE(writeImageExr(dir / "i.exr", 1, 1, 3, floats));
    const Result<Image> exr = readImage(dir / "i.exr");
    ASSERT_TRUE(exr);
    EXPECT_TRUE(exr->linear);
    EXPECT_EQ(exr->pixels, (std::vector<float>{0.25f, 3, 0}));
    EXPECT_TRUE(checkImage(dir / "i.exr"));
}

// Also a second later: no file holds the clock.
TEST(Images, EqualPicturesAreEqualFiles) {
    TempDir dir;
    const std::vector<float> floats{0.25f, 3, 1};
    Map map({3, 2, 1, PixelType::U16});
    for (const char* name : {"a", "b"}) {
        ASSERT_TRUE(writeImageExr(dir / (std::string(name) + ".exr"), 1, 1, 3, floats));
        ASSERT_TRUE(writeMap(dir / (std::string(name) + ".tif"), map));
        if (*name == 'a') std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    }
    for (const char* ext : {".exr", ".tif"})
        EXPECT_EQ(readText(dir / ("a" + std::string(ext))), readText(dir / ("b" + std::string(ext)))) << ext;
    for (const char* stamp : {"capDate", ":20"}) EXPECT_EQ(readText(dir / "a.tif").find(stamp), std::string::npos);
}

}  // namespace
}  // namespace sward::test
