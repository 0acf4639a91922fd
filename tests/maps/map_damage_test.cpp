// Damaged map files: cut short at many places, and with bytes changed at random. None may crash, hang or give a texel
// that is not finite; none that lacks pixels may pass.
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "maps/map_io.h"
#include "tests/maps/images.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {
struct Kind {
    const char* name;
    PixelType type;
    int channels;
};
constexpr Kind kKinds[] = {{"m.png", PixelType::U8, 4},  {"m.png", PixelType::U16, 1}, {"m.exr", PixelType::F32, 1},
                           {"m.exr", PixelType::F32, 4}, {"m.tif", PixelType::U16, 1}, {"m.tif", PixelType::F32, 2},
                           {"m.r16", PixelType::U16, 1}};

// The bytes of a sound file of this kind.
std::string soundFile(const TempDir& dir, const Kind& kind) {
    EXPECT_TRUE(writeMap(dir / kind.name, patternMap({61, 150, kind.channels, kind.type})));
    return readText(dir / kind.name);
}
MapWish wishFor(const Kind& kind) {
    MapWish w;
    w.channels = kind.channels;
    return w;
}
bool allFinite(const Map& map) {
    for (int y = 0; y < map.info().height; ++y)
        for (int x = 0; x < map.info().width; ++x)
            for (int c = 0; c < map.info().channels; ++c)
                if (!std::isfinite(map.at(x, y, c))) return false;
    return true;
}
}  // namespace

TEST(DamagedMaps, AFileCutShortAnywhereIsRefused) {
    TempDir dir;
    for (const Kind& kind : kKinds) {
        const std::string sound = soundFile(dir, kind);
        ASSERT_TRUE(readMap(dir / kind.name, wishFor(kind)));
        for (size_t step = 0; step < 120; ++step) {
            const size_t size = step < 40   ? step * 4
                                : step < 80 ? sound.size() - (step - 39)
                                            : sound.size() * (step - 80) / 40;
            writeText(dir / kind.name, sound.substr(0, std::min(size, sound.size() - 1)));
            const auto start = std::chrono::steady_clock::now();
            const Result<Map> map = readMap(dir / kind.name, wishFor(kind));
            EXPECT_FALSE(map) << kind.name << " cut to " << size << " of " << sound.size();
            EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
            if (map) continue;
            EXPECT_EQ(map.error().code, ExitCode::Unsound);
            EXPECT_FALSE(map.error().message.empty());
        }
    }
}

TEST(DamagedMaps, ChangedBytesNeverCrashNorGiveTexelsThatAreNotFinite) {
    TempDir dir;
    std::mt19937 random(7);
    size_t refused = 0, read = 0;
    for (const Kind& kind : kKinds) {
        const std::string sound = soundFile(dir, kind);
        for (int round = 0; round < 150; ++round) {
            std::string bytes = sound;
            const size_t reach =
                round % 2 ? bytes.size() : std::min<size_t>(bytes.size(), 400);  // headers as often as pixels
            for (int flips = 1 + round % 4; flips > 0; --flips) bytes[random() % reach] = static_cast<char>(random());
            writeText(dir / kind.name, bytes);
            const Result<Map> map = readMap(dir / kind.name, wishFor(kind));
            (map ? read : refused)++;
            if (map) {
                EXPECT_TRUE(allFinite(*map)) << kind.name << " round " << round;
            }
        }
    }
    EXPECT_GT(refused, 100u);
    EXPECT_GT(read, 100u);
}

// A data window that ends before it begins. Fuzzing found it: a product of both sides overflowed in the fuzz target.
TEST(DamagedMaps, AnExrWhoseWindowIsTurnedInsideOutIsRefused) {
    TempDir dir;
    const Kind& kind = kKinds[2];
    std::string bytes = soundFile(dir, kind);
    const std::string name("dataWindow\0box2i\0", 17);
    const size_t window = bytes.find(name) + name.size() + 4;
    ASSERT_LT(window, bytes.size());
    bytes.replace(window, 16, std::string("\xff\xff\xff\x7f\xff\xff\xff\x7f\0\0\0\x80\0\0\0\x80", 16));
    writeText(dir / kind.name, bytes);
    const Result<Map> map = readMap(dir / kind.name, wishFor(kind));
    ASSERT_FALSE(map);
    EXPECT_EQ(map.error().code, ExitCode::Unsound);
}

// Chunk lengths that, with the 12 bytes around a chunk, come to 2^32 or more: found by fuzzing, which it hung.
TEST(DamagedMaps, APngWhoseChunksAreAsLongAsNumbersGoIsRefused) {
    TempDir dir;
    const std::string sound = soundFile(dir, kKinds[0]);
    const size_t second = 8 + 12 + 13;  // after the signature and IHDR
    for (const char low : {'\xf3', '\xf4', '\xff', '\xc7'}) {
        std::string bytes = sound;
        bytes.replace(second, 4, std::string("\xff\xff\xff") + low);
        writeText(dir / "m.png", bytes);
        const Result<Map> map = readMap(dir / "m.png", wishFor(kKinds[0]));
        ASSERT_FALSE(map);
        EXPECT_EQ(map.error().code, ExitCode::Unsound);
    }
}
