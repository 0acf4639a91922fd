// Large maps in files of tiles: opened without being read, grown by what changed, and told of when they are damaged.
#include "maps/tile_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "core/file.h"
#include "maps/map_io.h"
#include "tests/maps/images.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {

MapWish channelWish(int channels) {
    MapWish w;
    w.channels = channels;
    w.mayStay = true;
    return w;
}

Map opened(const fs::path& file, int channels = 1) {
    Result<Map> map = readMap(file, channelWish(channels));
    EXPECT_TRUE(map) << (map ? "" : map.error().text());
    return map ? *map : Map();
}

// As the library reads it, which knows nothing of our tiles.
std::vector<uint8_t> readByLibrary(const fs::path& file) {
    OIIO::ImageSpec asStored;
    asStored["oiio:UnassociatedAlpha"] = 1;
    const auto in = OIIO::ImageInput::open(file.string(), &asStored);
    EXPECT_TRUE(in) << OIIO::geterror();
    if (!in) return {};
    const OIIO::ImageSpec& spec = in->spec();
    std::vector<uint8_t> out(static_cast<size_t>(spec.image_bytes(true)));
    EXPECT_TRUE(in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UNKNOWN, out.data())) << in->geterror();
    return out;
}
std::vector<uint8_t> texelsOf(const Map& map) {
    std::vector<uint8_t> out(size_t(map.info().width) * size_t(map.info().height) * map.texelBytes());
    map.readRows(0, map.info().height, out.data());
    return out;
}

// Every tile lies in a file.
bool isOpen(const Map& map) {
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx)
            if (!map.tile(tx, ty)->source()) return false;
    return true;
}

// `now`, beside what the file at `file` holds, by growing.
void grow(const fs::path& file, const Map& before, const Map& now) {
    ASSERT_TRUE(worthGrowing(file, before, now));
    const std::optional<PlainTiles> tiles = tilesOf(file, now.info());
    ASSERT_TRUE(tiles);
    Result<FileGrowth> growth = FileGrowth::begin(file);
    ASSERT_TRUE(growth);
    const Result<HeadSwitch> to = growTiles(*growth, *tiles, before, now);
    ASSERT_TRUE(to) << to.error().text();
    EXPECT_TRUE(texelsOf(opened(file)) == texelsOf(before)) << "nothing counts before the switch";
    ASSERT_TRUE(switchHead(file, *to));
}

}  // namespace

TEST(TileFile, LargeMapsComeBackUnreadAndAsTheyWere) {
    TempDir dir;
    const Map map = largeMap();
    ASSERT_TRUE(writeMap(dir / "m.tif", map));
    const Map back = opened(dir / "m.tif");
    EXPECT_TRUE(isOpen(back));
    EXPECT_EQ(back.info(), map.info());
    EXPECT_EQ(back.hash(), map.hash());
    EXPECT_TRUE(readByLibrary(dir / "m.tif") == texelsOf(map)) << "another reader of TIFF sees something else";
    EXPECT_EQ(back.tile(3, 20), back.tile(9, 25)) << "zero tiles are one";
    EXPECT_LT(fs::file_size(dir / "m.tif"), size_t(map.tilesX()) * size_t(map.tilesY()) * map.tileBytes());
}

TEST(TileFile, HasEveryNumberOfChannelsAndBits) {
    TempDir dir;
    for (const PixelType type : {PixelType::U8, PixelType::U16})
        for (int channels = 1; channels <= 4; ++channels) {
            Map map({4100, 4096, channels, type});
            for (int c = 0; c < channels; ++c) map.set(4099, 4095, c, pattern(4099, 4095, c)), map.set(7, 300, c, 0.5f);
            const fs::path file = dir / fmt::format("{}-{}.tif", channels, pixelBytes(type));
            ASSERT_TRUE(writeMap(file, map));
            const Map back = opened(file, channels);
            EXPECT_TRUE(isOpen(back)) << file;
            for (int c = 0; c < channels; ++c) EXPECT_EQ(back.at(4099, 4095, c), map.at(4099, 4095, c)) << file;
            const std::vector<uint8_t> library = readByLibrary(file);
            ASSERT_EQ(library.size(), size_t(4100) * 4096 * map.texelBytes()) << file;
            std::vector<uint8_t> row(size_t(4100) * map.texelBytes());
            for (const int y : {0, 300, 4095}) {
                map.readRows(y, 1, row.data());
                EXPECT_TRUE(std::equal(row.begin(), row.end(), library.begin() + long(size_t(y) * row.size()))) << file;
            }
        }
}

TEST(TileFile, SmallMapsFloatsAndFlippedOnesAreReadAsBefore) {
    TempDir dir;
    const Map map = largeMap();
    ASSERT_TRUE(writeMap(dir / "flipped.tif", map, true));
    MapWish flip = channelWish(1);
    flip.flip = true;
    const Result<Map> back = readMap(dir / "flipped.tif", flip);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->hash(), map.hash());
    EXPECT_FALSE(back->tile(0, 0)->source());
    ASSERT_TRUE(writeMap(dir / "m.tif", map));
    MapWish others;  // of an import: its file is not ours
    EXPECT_FALSE(readMap(dir / "m.tif", others)->tile(0, 0)->source());
    EXPECT_EQ(readMap(dir / "m.tif", others)->hash(), map.hash());
    ASSERT_TRUE(writeMap(dir / "small.tif", patternMap({300, 200, 1, PixelType::U16})));
    EXPECT_FALSE(opened(dir / "small.tif").tile(0, 0)->source());
    EXPECT_FALSE(keptInTiles({16384, 8192, 1, PixelType::F32}));
    EXPECT_FALSE(keptInTiles({4096, 4096, 1, PixelType::U16}));
    EXPECT_TRUE(keptInTiles({4097, 4096, 1, PixelType::U16}));
}

TEST(TileFile, GrowsByWhatChangedAndWhoHasItOpenReadsOn) {
    TempDir dir;
    const fs::path file = dir / "m.tif";
    ASSERT_TRUE(writeMap(file, largeMap()));
    const Map before = opened(file);
    Map now = before;
    now.set(130, 5, 0, 0.25f), now.set(131, 5, 0, 0.25f), now.set(4100, 4000, 0, 1);
    const uint64_t size = fs::file_size(file);
    grow(file, before, now);
    const size_t tables = 8 * size_t(now.tilesX()) * size_t(now.tilesY()) + 512;
    EXPECT_LT(fs::file_size(file), size + 2 * now.tileBytes() + tables) << "two tiles changed";
    EXPECT_TRUE(texelsOf(opened(file)) == texelsOf(now));
    EXPECT_TRUE(readByLibrary(file) == texelsOf(now));
    EXPECT_TRUE(texelsOf(before) == texelsOf(largeMap())) << "what was opened before reads what was before";
    Map again = now;
    again.set(130, 5, 0, 0.75f);
    grow(file, now, again);
    EXPECT_TRUE(texelsOf(opened(file)) == texelsOf(again));
}

TEST(TileFile, IsWrittenAnewBeforeItIsTwiceTheMap) {
    TempDir dir;
    const fs::path file = dir / "m.tif";
    const Map map = fullMap();
    ASSERT_TRUE(writeMap(file, map));
    Map half = map, most = map;
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx) {
            most.set(tx * kTileSize, ty * kTileSize, 0, 0.5f);
            if (ty % 2 == 0) half.set(tx * kTileSize, ty * kTileSize, 0, 0.5f);
        }
    EXPECT_TRUE(worthGrowing(file, map, half));
    EXPECT_FALSE(worthGrowing(file, map, most)) << "all of it and the directories";
    EXPECT_FALSE(worthGrowing(file, Map({8, 8, 1, PixelType::U8}), map));
    fs::create_hard_link(file, dir / "copy.tif");
    EXPECT_FALSE(worthGrowing(file, map, half)) << "the copy would change with it";
}

TEST(TileFile, WhatIsCutShortIsToldOfAndNotSaved) {
    TempDir dir;
    const fs::path file = dir / "m.tif";
    ASSERT_TRUE(writeMap(file, fullMap()));
    const Map map = opened(file);
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_GT(map.at(0, 0), 0) << "what is left";
    EXPECT_EQ(map.at(4200, 3900), 0) << "what is gone";
    const Status checked = checkTiles(map);
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().code, ExitCode::Unsound);
    EXPECT_NE(checked.error().text().find(file.string()), std::string::npos) << checked.error().text();
    for (const char* name : {"copy.tif", "copy.png"}) {
        const Status copied = writeMap(dir / name, map);
        ASSERT_FALSE(copied) << name;
        EXPECT_EQ(copied.error().code, ExitCode::Failed) << name;
        EXPECT_FALSE(fs::exists(dir / name)) << name;
    }
    EXPECT_FALSE(readMap(file, channelWish(1))) << "the next to open it is told at once";
}

TEST(TileFile, WhatAnotherProgramWroteOverIsNotSavedAsOnesOwn) {
    TempDir dir;
    const fs::path file = dir / "m.tif";
    ASSERT_TRUE(writeMap(file, fullMap()));
    const Map map = opened(file);
    Map painted = map;
    painted.set(0, 0, 0, 0.5f);
    std::string bytes = readText(file);
    std::reverse(bytes.begin() + 8, bytes.begin() + 8 + 1000000);
    std::ofstream(file, std::ios::binary | std::ios::in) << bytes;  // in its place, as long as before
    ASSERT_EQ(fs::file_size(file), bytes.size());
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(1));
    for (const Map& m : {map, painted}) {
        const Status saved = writeMap(dir / "copy.tif", m);
        ASSERT_FALSE(saved);
        EXPECT_NE(saved.error().text().find("written over by another program"), std::string::npos)
            << saved.error().text();
    }
    EXPECT_FALSE(fs::exists(dir / "copy.tif"));
    EXPECT_TRUE(writeMap(dir / "copy.tif", opened(file))) << "opened anew it is what it is";
}

TEST(TileFile, WhatWasPaintedOnTexelsThatAreGoneIsNotSaved) {
    TempDir dir;
    const fs::path file = dir / "m.tif";
    ASSERT_TRUE(writeMap(file, fullMap()));
    Map map = opened(file);
    fs::resize_file(file, 4096);
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx) map.writeTile(tx, ty);
    EXPECT_FALSE(isOpen(map));
    EXPECT_FALSE(writeMap(dir / "copy.tif", map)) << "zeros for texels";
}

TEST(TileFile, RefusesWhatAnyMapIsRefusedFor) {
    TempDir dir;
    ASSERT_TRUE(writeMap(dir / "m.tif", largeMap()));
    MapWish heights = channelWish(1);
    heights.isHeight = true;
    const Result<Map> eight = readMap(dir / "m.tif", heights);
    ASSERT_FALSE(eight);
    EXPECT_NE(eight.error().text().find("8 bits"), std::string::npos) << eight.error().text();
    EXPECT_FALSE(readMap(dir / "m.tif", channelWish(4)));
}
