// Maps from and to files: every format both ways, and every refusal with its message. Damage: map_damage_test.cpp.
#include "maps/map_io.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <set>

#include "maps/map_repair.h"
#include "tests/maps/images.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

Map readBack(const fs::path& file, const MapWish& wish) {
    Result<Map> map = readMap(file, wish);
    EXPECT_TRUE(map) << (map ? "" : map.error().text());
    return map ? *map : Map();
}
MapWish channels(int n) {
    MapWish w;
    w.channels = n;
    return w;
}
MapWish heightWish() {
    MapWish w;
    w.isHeight = true;
    return w;
}
// The error of a map that must be refused, within a second.
Error refusal(const fs::path& file, const MapWish& wish) {
    const auto start = std::chrono::steady_clock::now();
    const Result<Map> map = readMap(file, wish);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
    EXPECT_FALSE(map) << file;
    if (map) return {};
    EXPECT_EQ(map.error().code, ExitCode::Unsound);
    return map.error();
}
// Writes with the library itself, as other programs would.
void writeOther(const fs::path& file, OIIO::ImageSpec spec, OIIO::TypeDesc type, const void* pixels) {
    auto out = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(out && out->open(file.string(), spec) && out->write_image(type, pixels) && out->close()) << file;
}
struct Format {
    const char* ext;
    PixelType type;
    int channels;
};
constexpr Format kLossless[] = {
    {".png", PixelType::U8, 1},  {".png", PixelType::U8, 2},  {".png", PixelType::U8, 3},  {".png", PixelType::U8, 4},
    {".png", PixelType::U16, 1}, {".png", PixelType::U16, 2}, {".png", PixelType::U16, 3}, {".png", PixelType::U16, 4},
    {".exr", PixelType::F32, 1}, {".exr", PixelType::F32, 2}, {".exr", PixelType::F32, 3}, {".exr", PixelType::F32, 4},
    {".tif", PixelType::U8, 1},  {".tif", PixelType::U8, 4},  {".tif", PixelType::U16, 1}, {".tif", PixelType::U16, 2},
    {".tif", PixelType::U16, 4}, {".tif", PixelType::F32, 1}, {".tif", PixelType::F32, 2}, {".tif", PixelType::F32, 4},
    {".r16", PixelType::U16, 1},
};
}  // namespace

TEST(MapFiles, EveryFormatGivesBackTheTexelsItWasGiven) {
    TempDir dir;
    for (const Format& f : kLossless)
        for (const bool flip : {false, true}) {
            const Map map = patternMap({200, 131, f.channels, f.type});
            const fs::path file = dir / (std::string("m") + f.ext);
            const Status written = writeMap(file, map, flip);
            ASSERT_TRUE(written) << written.error().text();
            MapWish wish = channels(f.channels);
            wish.flip = flip;
            const Map back = readBack(file, wish);
            EXPECT_EQ(back.info(), map.info()) << f.ext << f.channels;
            EXPECT_EQ(back.hash(), map.hash())
                << f.ext << " type " << int(f.type) << " channels " << f.channels << " flip " << flip;
            EXPECT_EQ(std::distance(fs::directory_iterator(dir.path), {}), f.ext == std::string(".r16") ? 2 : 1)
                << "left-overs";
            fs::remove(file);
            fs::remove(dir / "m.json");
        }
}

TEST(MapFiles, FlippingPutsTheFirstRowLast) {
    TempDir dir;
    Map map({2, 3, 1, PixelType::U8});
    map.set(0, 0, 0, 1);
    ASSERT_TRUE(writeMap(dir / "m.png", map));
    MapWish wish;
    wish.flip = true;
    EXPECT_EQ(readBack(dir / "m.png", wish).at(0, 2), 1.0f);
}

TEST(MapFiles, AnExrMayHaveItsDataWindowAnywhereAndHalfFloats) {
    TempDir dir;
    for (const int origin : {0, 700, -300}) {
        OIIO::ImageSpec spec(150, 140, 1, OIIO::TypeDesc::HALF);
        spec.x = origin;
        spec.y = -origin;
        spec.full_x = 0;
        spec.full_y = 0;
        spec.full_width = spec.full_height = 64;
        std::vector<float> pixels(150 * 140);
        for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = float(i % 1024) / 4;
        writeOther(dir / "m.exr", spec, OIIO::TypeDesc::FLOAT, pixels.data());
        const Map map = readBack(dir / "m.exr", heightWish());
        ASSERT_EQ(map.info(), (MapInfo{150, 140, 1, PixelType::F32}));
        EXPECT_EQ(map.at(0, 0), pixels[0]);
        EXPECT_EQ(map.at(149, 139), pixels[149 + 139 * 150]);
    }
}

TEST(MapFiles, TiledFilesAreReadAsAnyOther) {
    TempDir dir;
    for (const char* name : {"m.exr", "m.tif"}) {
        OIIO::ImageSpec spec(300, 200, 1, OIIO::TypeDesc::FLOAT);
        spec.tile_width = spec.tile_height = 64;
        std::vector<float> pixels(300 * 200);
        for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = float(i);
        writeOther(dir / name, spec, OIIO::TypeDesc::FLOAT, pixels.data());
        const Map map = readBack(dir / name, heightWish());
        EXPECT_EQ(map.at(299, 199), pixels.back());
        EXPECT_EQ(map.at(130, 129), pixels[130 + 129 * 300]);
    }
}

TEST(MapFiles, AlphaIsNeverMultipliedIntoColour) {
    TempDir dir;
    for (const char* name : {"m.png", "m.tif", "m.exr"}) {
        Map map({4, 4, 4, name == std::string("m.exr") ? PixelType::F32 : PixelType::U8});
        for (int c = 0; c < 3; ++c) map.set(1, 1, c, 1);
        map.set(1, 1, 3, 51 / 255.0f);
        ASSERT_TRUE(writeMap(dir / name, map));
        const Map back = readBack(dir / name, channels(4));
        EXPECT_EQ(back.at(1, 1, 0), 1.0f) << name;
        EXPECT_EQ(back.at(1, 1, 3), 51 / 255.0f) << name;
    }
}

TEST(MapFiles, ThreeChannelsServeFourWithFullAlpha) {
    TempDir dir;
    for (const Format& f :
         {Format{"m.png", PixelType::U8, 3}, Format{"m.png", PixelType::U16, 3}, Format{"m.exr", PixelType::F32, 3}}) {
        const Map map = patternMap({130, 5, 3, f.type});
        ASSERT_TRUE(writeMap(dir / f.ext, map));
        const Map back = readBack(dir / f.ext, channels(4));
        EXPECT_EQ(back.at(129, 4, 2), map.at(129, 4, 2));
        EXPECT_EQ(back.at(129, 4, 3), 1.0f);
    }
}

TEST(MapFiles, NoOtherCountOfChannelsStandsForAnother) {
    TempDir dir;
    for (int has = 1; has <= 4; ++has) {
        ASSERT_TRUE(writeMap(dir / "m.png", patternMap({8, 8, has, PixelType::U8})));
        for (int wants = 1; wants <= 4; ++wants) {
            if (has == wants || (has == 3 && wants == 4)) continue;
            const Error e = refusal(dir / "m.png", channels(wants));
            EXPECT_EQ(e.message, fmt::format("has {} channel{}, not {}", has, has == 1 ? "" : "s", wants));
            EXPECT_FALSE(e.remedy.empty());
        }
    }
}

TEST(MapFiles, HeightsOfEightBitsAreRefused) {
    TempDir dir;
    ASSERT_TRUE(writeMap(dir / "m.png", patternMap({8, 8, 1, PixelType::U8})));
    const Error e = refusal(dir / "m.png", heightWish());
    EXPECT_NE(e.message.find("8 bits"), std::string::npos);
    EXPECT_NE(e.remedy.find("16 bits"), std::string::npos);
    EXPECT_EQ(e.file, (dir / "m.png").string());
}

TEST(MapFiles, WhatIsNoImageIsRefusedByName) {
    TempDir dir;
    EXPECT_EQ(refusal(dir / "none.png", {}).message, "cannot be read: No such file or directory");
    writeText(dir / "empty.exr", "");
    EXPECT_EQ(refusal(dir / "empty.exr", {}).message, "is empty");
    writeText(dir / "letter.png", "Dear Sir or Madam");
    EXPECT_EQ(refusal(dir / "letter.png", {}).message, "is no PNG, EXR or TIFF image, or is damaged");
}

TEST(MapFiles, WhatIsNoFileIsCalledWhatItIs) {
    TempDir dir;
    ASSERT_EQ(mkfifo((dir / "pipe.png").c_str(), 0600), 0);
    fs::create_directory(dir / "folder.png");
    EXPECT_EQ(readMap(dir / "pipe.png", {}).error().message, "is a FIFO (a named pipe), not a file");
    EXPECT_EQ(readMap(dir / "folder.png", {}).error().message, "is a folder, not a file");
    EXPECT_EQ(checkImage(dir / "pipe.png").error().code, ExitCode::Unsound);
}

TEST(MapFiles, LimitsAreKnownBeforeAMapIsWritten) {
    EXPECT_TRUE(checkMapLimits("h.exr", {kMaxMapSide, kMaxMapSide, 1, PixelType::F32}));
    const Status heavy = checkMapLimits("h.exr", {kMaxMapSide, kMaxMapSide, 2, PixelType::F32});
    ASSERT_FALSE(heavy);
    EXPECT_EQ(heavy.error().message, "takes 2048 MiB; the limit is 1024");
}

TEST(MapFiles, SizesBeyondTheLimitAreRefusedFromTheHeader) {
    TempDir dir;
    writeText(dir / "a.exr", exrBomb(8166272, 23));
    EXPECT_EQ(refusal(dir / "a.exr", {}).message, "is 8166272 x 23; the limit is 16384 a side");
    writeText(dir / "b.exr", exrBomb(23, 2147483647));
    EXPECT_NE(refusal(dir / "b.exr", {}).message.find("the limit is 16384"), std::string::npos);
    writeText(dir / "a.png", pngBomb(30000, 30000));
    EXPECT_EQ(refusal(dir / "a.png", {}).message, "is 30000 x 30000; the limit is 16384 a side");
    writeText(dir / "a.tif", tiffBomb(4000000000u, 4000000000u));
    EXPECT_FALSE(refusal(dir / "a.tif", {}).message.empty());
    writeText(dir / "b.tif", tiffBomb(30000, 30000));
    EXPECT_NE(refusal(dir / "b.tif", {}).message.find("the limit is 16384"), std::string::npos);
}

TEST(MapFiles, SizesWithinTheLimitButWithoutPixelsAreRefused) {
    TempDir dir;
    writeText(dir / "a.exr", exrBomb(16384, 16384));
    refusal(dir / "a.exr", {});
    writeText(dir / "a.png", pngBomb(16384, 16384));
    refusal(dir / "a.png", {});
    writeText(dir / "a.tif", tiffBomb(16384, 16384));
    refusal(dir / "a.tif", {});
}

TEST(MapFiles, AMapHeavierThanTheLimitIsRefused) {
    TempDir dir;
    EXPECT_FALSE(checkImage(dir / "none.png"));
    writeText(dir / "a.json", R"({"width": 100000, "height": 2})");
    writeText(dir / "a.r16", "12345678");
    EXPECT_NE(refusal(dir / "a.r16", {}).message.find("the limit is 16384"), std::string::npos);
    MapWish wish = channels(4);
    OIIO::ImageSpec spec(16384, 16384, 4, OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "none");
    auto out = OIIO::ImageOutput::create((dir / "heavy.tif").string());
    ASSERT_TRUE(out->open((dir / "heavy.tif").string(), spec));
    std::vector<float> row(16384 * 4);
    out->write_scanline(0, 0, OIIO::TypeDesc::FLOAT, row.data());
    out->close();
    EXPECT_EQ(refusal(dir / "heavy.tif", wish).message, "takes 4096 MiB; the limit is 1024");
}

TEST(MapFiles, SizeZeroIsRefused) {
    TempDir dir;
    writeText(dir / "a.png", pngBomb(0, 7));
    EXPECT_EQ(refusal(dir / "a.png", {}).message, "has size 0 x 7");
    writeText(dir / "a.exr", exrBomb(0, 0));
    EXPECT_EQ(refusal(dir / "a.exr", {}).message, "has size 0 x 0");
    writeText(dir / "a.json", R"({"width": 0, "height": 0})");
    writeText(dir / "a.r16", "");
    EXPECT_EQ(refusal(dir / "a.r16", {}).message, "has size 0 x 0");
}

TEST(MapFiles, AnR16NeedsASidecarThatFits) {
    TempDir dir;
    writeText(dir / "a.r16", std::string(24, 'x'));
    EXPECT_NE(refusal(dir / "a.r16", {}).remedy.find("\"width\""), std::string::npos);
    writeText(dir / "a.json", R"({"width": 4, "height": 4})");
    EXPECT_EQ(refusal(dir / "a.r16", {}).message, "has 24 bytes; 4 x 4 texels take 32");
    writeText(dir / "a.json", R"({"width": 2, "height": 4})");
    EXPECT_EQ(refusal(dir / "a.r16", {}).message, "has 24 bytes; 2 x 4 texels take 16");
    writeText(dir / "a.json", R"({"width": 4.5, "height": 3})");
    EXPECT_EQ(refusal(dir / "a.r16", {}).file, (dir / "a.json").string());
    writeText(dir / "a.json", "{\"width\": 4, \"height\": 3,\n \"range\": 7}");
    EXPECT_EQ(refusal(dir / "a.r16", {}).line, 2);
    writeText(dir / "a.json", "{\"width\": 4,, \"height\": 3}");
    EXPECT_EQ(refusal(dir / "a.r16", {}).column, 13);
    writeText(dir / "a.json", R"({"width": 4, "height": 3})");
    EXPECT_EQ(readBack(dir / "a.r16", {}).info(), (MapInfo{4, 3, 1, PixelType::U16}));
    writeText(dir / "a.r16", std::string("\x01\x02", 2) + std::string(22, '\0'));
    EXPECT_EQ(readBack(dir / "a.r16", {}).at(0, 0), 0x0201 / 65535.0f);
}

TEST(MapFiles, ARangeTurnsIntegersIntoMetresAndBack) {
    TempDir dir;
    Map heights({3, 1, 1, PixelType::F32});
    heights.set(0, 0, 0, -50);
    heights.set(1, 0, 0, 0);
    heights.set(2, 0, 0, 150);
    for (const char* name : {"m.png", "m.r16"}) {
        EXPECT_FALSE(writeMap(dir / name, heights)) << "floats need a range";
        ASSERT_TRUE(writeMap(dir / name, heights, false, {{-50, 150}}));
        MapWish wish = heightWish();
        wish.type = PixelType::F32;
        wish.range = {-50, 150};
        const Map back = readBack(dir / name, wish);
        for (int x = 0; x < 3; ++x) EXPECT_NEAR(back.at(x, 0), heights.at(x, 0), 200.0 / 65535);
    }
    EXPECT_EQ(sidecarRange(dir / "m.r16"), (std::pair<double, double>(-50, 150)));
    EXPECT_EQ(sidecarRange(dir / "m.png"), std::nullopt);
    MapWish asStated = heightWish();
    asStated.type = PixelType::F32;
    EXPECT_NEAR(readBack(dir / "m.r16", asStated).at(2, 0), 150, 0.01) << "the sidecar's range, if no other is given";
}

TEST(MapFiles, FourThousandSquareHeightsLoadWithinTwoSecondsOfOneCore) {
    TempDir dir;
    Map map({4096, 4096, 1, PixelType::F32});
    std::vector<float> row(4096);
    for (int y = 0; y < 4096; ++y) {
        for (int x = 0; x < 4096; ++x) row[size_t(x)] = 20 * std::sin(float(x) * 0.01f) * std::cos(float(y) * 0.013f);
        map.writeRows(y, 1, row.data());
    }
    for (const char* name : {"m.exr", "m.png"}) {
        ASSERT_TRUE(writeMap(dir / name, map, false, {{-20, 20}}));
        const std::clock_t start = std::clock();  // of all threads: what else the machine does must not count
        EXPECT_EQ(readBack(dir / name, heightWish()).info().width, 4096);
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        EXPECT_LT(seconds, SWARD_OPTIMIZED && !sanitized() ? 2.0 : 60.0) << name;
    }
}

TEST(MapFiles, AFailedWriteLeavesTheOldFile) {
    TempDir dir;
    const Map map = patternMap({16, 16, 1, PixelType::F32});
    writeText(dir / "m.png", "old");
    EXPECT_FALSE(writeMap(dir / "m.png", map)) << "floats in a PNG";
    EXPECT_EQ(readText(dir / "m.png"), "old");
    EXPECT_FALSE(writeMap(dir / "none/m.exr", map));
    EXPECT_FALSE(writeMap(dir / "m.bmp", map));
}

// --- what others hold ------------------------------------------------------------------------------------------------
namespace {
MapWish heights() {
    MapWish w;
    w.isHeight = true;
    return w;
}
}  // namespace

TEST(MapFiles, NumbersOfElevationModelsAreReadByTheirValues) {
    TempDir dir;
    const auto expectHeights = [&](const std::string& file, const std::vector<float>& want) {
        writeText(dir / "h.tif", file);
        const Result<Map> map = readMap(dir / "h.tif", heights());
        ASSERT_TRUE(map) << map.error().text();
        EXPECT_EQ(map->info().type, PixelType::F32);
        for (size_t i = 0; i < want.size(); ++i) EXPECT_EQ(map->at(int(i) % 2, int(i) / 2), want[i]) << i;
    };
    expectHeights(tiffOf(2, 2, 16, 2, bytesOf<int16_t>({-430, 0, 8848, 32767})), {-430, 0, 8848, 32767});
    expectHeights(tiffOf(2, 2, 32, 1, bytesOf<uint32_t>({0, 1, 8848, 1 << 20})), {0, 1, 8848, 1 << 20});
    expectHeights(tiffOf(2, 2, 32, 2, bytesOf<int32_t>({-5, 1, 8848, 70000})), {-5, 1, 8848, 70000});
    expectHeights(tiffOf(2, 2, 64, 3, bytesOf<double>({-0.5, 1.25, 8848.75, 3e5})), {-0.5f, 1.25f, 8848.75f, 3e5f});
}

TEST(MapFiles, TexelsWithoutDataTakeTheNearestThatHasSome) {
    TempDir dir;
    const auto expectFirst = [&](const std::string& file, float first, const std::string& said) {
        writeText(dir / "h.tif", file);
        std::vector<std::string> repaired;
        const Result<Map> map = readMap(dir / "h.tif", heights(), &repaired);
        ASSERT_TRUE(map) << map.error().text();
        EXPECT_NEAR(map->at(0, 0), first, 1e-6);
        EXPECT_EQ(repaired, std::vector<std::string>{said});
    };
    const std::string one = "texel (0, 0) has no data; replaced by the nearest finite texel";
    expectFirst(tiffOf(2, 2, 32, 3, bytesOf<float>({-9999, 12, 12, 14}), "-9999"), 12, one);
    expectFirst(tiffOf(2, 2, 16, 2, bytesOf<int16_t>({-32768, 12, 12, 14}), "-32768"), 12, one);
    expectFirst(tiffOf(2, 2, 64, 3, bytesOf<double>({-3.4028234663852886e+38, 12, 12, 14}), "-3.4028234663852886e+38"),
                12, one);
    expectFirst(tiffOf(2, 2, 16, 1, bytesOf<uint16_t>({65535, 13107, 13107, 65535}), "65535"), 0.2f,
                "texel (0, 0) and 1 more have no data; replaced by the nearest finite texel");
    writeText(dir / "u.tif", tiffOf(2, 2, 16, 1, bytesOf<uint16_t>({0, 1, 2, 3}), "0"));
    EXPECT_EQ(readMap(dir / "u.tif", heights())->info().type, PixelType::U16) << "shares stay shares";
}

// The header of a subsampled EXR, as OpenEXR's own tools write them of colour differences.
TEST(MapFiles, ChannelsOfDifferentSizesAreRefusedForThat) {
    TempDir dir;
    std::string exr = exrBomb(64, 64);
    const size_t sampling = exr.find(std::string("Y\0", 2)) + 2 + 8;
    ASSERT_LT(sampling + 8, exr.size());
    exr[sampling] = exr[sampling + 4] = 2;
    writeText(dir / "s.exr", exr + std::string(1 << 16, '\0'));
    const Error e = refusal(dir / "s.exr", heights());
    EXPECT_EQ(e.message, "has channels of different sizes (subsampled)");
    EXPECT_EQ(e.remedy, "export every channel at the full size");
    writeText(dir / "l.tif", tiffOf(2, 1, 64, 1, bytesOf<uint64_t>({1, 2})));
    EXPECT_EQ(refusal(dir / "l.tif", heights()).message, "is of a kind that is not read");
}
