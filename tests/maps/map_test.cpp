// The tiled map: sharing, copying on write, numbers, rows, hashes.
#include "maps/map.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "tests/maps/images.h"

using namespace sward;
using namespace sward::test;

TEST(Map, ANewMapSharesOneZeroTile) {
    const Map a({1000, 700, 2, PixelType::U16}), b({1000, 700, 2, PixelType::U16});
    EXPECT_EQ(a.tilesX(), 8);
    EXPECT_EQ(a.tilesY(), 6);
    EXPECT_EQ(a.tile(0, 0), a.tile(7, 5));
    EXPECT_TRUE(a.sameTiles(b));
    EXPECT_EQ(a.mean(), 0);
    EXPECT_TRUE(Map().empty());
}

TEST(Map, WritingCopiesOnlyTheTileThatIsWritten) {
    Map a = patternMap({300, 300, 1, PixelType::U16});
    const Map before = a;
    a.set(130, 5, 0, 1);
    EXPECT_FALSE(a.sameTiles(before));
    for (int ty = 0; ty < 3; ++ty)
        for (int tx = 0; tx < 3; ++tx) EXPECT_EQ(a.tile(tx, ty) == before.tile(tx, ty), !(tx == 1 && ty == 0));
    const std::byte* own = a.writeTile(1, 0);
    EXPECT_EQ(a.writeTile(1, 0), own) << "a tile of its own is not copied again";
    EXPECT_EQ(before.at(130, 5), patternMap(before.info()).at(130, 5));
}

TEST(Map, IntegersAreClampedAndRoundedFloatsAreKept) {
    for (const PixelType type : {PixelType::U8, PixelType::U16}) {
        Map m({4, 1, 1, type});
        const float scale = type == PixelType::U8 ? 255 : 65535;
        const float values[] = {-3, 7, std::numeric_limits<float>::quiet_NaN(), 10.4f / scale},
                    expected[] = {0, 1, 0, 10 / scale};
        for (int x = 0; x < 4; ++x) {
            m.set(x, 0, 0, values[x]);
            EXPECT_EQ(m.at(x, 0), expected[x]);
        }
    }
    Map f({1, 1, 1, PixelType::F32});
    f.set(0, 0, 0, -1234.5f);
    EXPECT_EQ(f.at(0, 0), -1234.5f);
    EXPECT_EQ(f.at(-5, 9), -1234.5f) << "beyond the edge lies the edge";
}

TEST(Map, RowsComeBackAsWrittenAcrossTiles) {
    const Map m = patternMap({257, 130, 3, PixelType::U8});
    std::vector<std::byte> rows(size_t(257) * 3 * 130);
    m.readRows(0, 130, rows.data());
    Map copy(m.info());
    copy.writeRows(0, 100, rows.data());
    copy.writeRows(100, 30, rows.data() + size_t(257) * 3 * 100);
    EXPECT_EQ(copy.hash(), m.hash());
    std::vector<std::byte> one(257 * 3);
    copy.readRows(129, 1, one.data());
    EXPECT_EQ(std::memcmp(one.data(), rows.data() + size_t(257) * 3 * 129, one.size()), 0);
}

TEST(Map, TheHashCoversSizeChannelsAndTexelsButNoPadding) {
    const Map m = patternMap({100, 90, 1, PixelType::U16});
    Map padded = m;
    padded.writeTile(0, 0)[size_t(127) * kTileSize * 2] = std::byte{1};  // below the map's edge
    EXPECT_EQ(padded.hash(), m.hash());
    Map changed = m;
    changed.set(99, 89, 0, changed.at(99, 89) > 0.5f ? 0.0f : 1.0f);
    EXPECT_NE(changed.hash(), m.hash());
    EXPECT_NE(Map({8, 4, 1, PixelType::U16}).hash(), Map({4, 8, 1, PixelType::U16}).hash());
    EXPECT_NE(Map({4, 4, 2, PixelType::U16}).hash(), Map({8, 4, 1, PixelType::U16}).hash());
}

TEST(Map, TheMeanCountsEveryTexelOnce) {
    for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::F32}) {
        const Map m = patternMap({131, 257, 2, type});
        double sum = 0;
        for (int y = 0; y < 257; ++y)
            for (int x = 0; x < 131; ++x) sum += double(m.at(x, y, 1));
        EXPECT_NEAR(m.mean(1), sum / (131 * 257), 1e-7);
    }
}

TEST(Map, SamplesAreTexelsAtTheirCentresAndMixedBetween) {
    Map m({2, 1, 1, PixelType::F32});
    m.set(0, 0, 0, 10);
    m.set(1, 0, 0, 30);
    EXPECT_EQ(m.sample(0.25, 0.5), 10);
    EXPECT_EQ(m.sample(0.75, 0.5), 30);
    EXPECT_EQ(m.sample(0.5, 0.5), 20);
    EXPECT_EQ(m.sample(0, 0), 10);
    EXPECT_EQ(m.sample(1, 1), 30);
    EXPECT_EQ(m.sample(-7, std::numeric_limits<double>::quiet_NaN()), 10);
}
