// Tiles: held ones, and those that are read when somebody looks at them.
#include "maps/tile.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <thread>

using namespace sward;

namespace {
// The bytes at a place are its number; counts how often it is read.
struct Counted final : TexelSource {
    mutable std::atomic<int> reads{0};
    void read(uint64_t place, std::span<std::byte> out) const override {
        ++reads;
        std::memset(out.data(), static_cast<int>(place), out.size());
    }
    bool broken = false;
    Status sound() const override { return broken ? Status(unsound("broken")) : Status(); }
};
}  // namespace

TEST(Tiles, OfASourceAreReadWhenLookedAtAndStayAtHand) {
    const auto source = std::make_shared<Counted>();
    const Tile tile(source, 7, 64);
    EXPECT_EQ(source->reads, 0);
    EXPECT_EQ(tile.heldBytes(), 0u);
    EXPECT_EQ(tile.look()[63], std::byte(7));
    EXPECT_EQ(tile.texels().data()[0], std::byte(7));
    EXPECT_EQ(tile.texels().size(), 64u);
    EXPECT_EQ(source->reads, 1);
    std::thread([&] { EXPECT_EQ(tile.look()[0], std::byte(7)); }).join();
    EXPECT_EQ(source->reads, 2) << "each thread has its own";
}

TEST(Tiles, TexelsLastAsLongAsTheyAreLookedAt) {
    const auto source = std::make_shared<Counted>();
    const Tile first(source, 1, 64);
    const TileTexels texels = first.texels();
    for (uint64_t i = 0; i < 2 * kTilesAtHand; ++i) Tile(source, 100 + i % 100, 64).look();
    EXPECT_EQ(texels.data()[5], std::byte(1));
    EXPECT_EQ(source->reads, 1 + static_cast<int>(2 * kTilesAtHand));
    EXPECT_EQ(first.look()[5], std::byte(1));
    EXPECT_EQ(source->reads, 2 + static_cast<int>(2 * kTilesAtHand)) << "it had been let go";
}

TEST(Tiles, ARowOfNeighboursIsReadOnce) {
    const auto source = std::make_shared<Counted>();
    std::vector<std::unique_ptr<Tile>> row;
    for (size_t i = 0; i < kTilesAtHand; ++i) row.push_back(std::make_unique<Tile>(source, i, 16));
    for (int pass = 0; pass < 3; ++pass)
        for (const auto& tile : row) tile->look();
    EXPECT_EQ(source->reads, static_cast<int>(kTilesAtHand));
}

TEST(Tiles, ACopyIsHeldAndCanBeWritten) {
    const auto source = std::make_shared<Counted>();
    const Tile tile(source, 3, 16);
    Tile copy(tile);
    EXPECT_EQ(copy.heldBytes(), 16u);
    EXPECT_TRUE(sameTexels(copy, tile));
    copy.write()[2] = std::byte(9);
    EXPECT_FALSE(sameTexels(copy, tile));
    EXPECT_EQ(tile.look()[2], std::byte(3));
}

TEST(Tiles, OfTheSamePlaceOfTwoMapsDoNotDriveEachOtherOut) {
    const auto source = std::make_shared<Counted>();
    std::vector<std::unique_ptr<Tile>> tiles;
    for (size_t i = 0; i < 2 * kTilesAtHand; ++i) tiles.push_back(std::make_unique<Tile>(source, i % 100, 16));
    for (int look = 0; look < 5; ++look) tiles[3]->look(), tiles[3 + kTilesAtHand]->look();
    EXPECT_EQ(source->reads, 2);
}

TEST(Tiles, ACopyOfWhatWasUnsoundStaysSo) {
    const auto source = std::make_shared<Counted>();
    const Tile tile(source, 3, 16);
    const Tile before(tile);
    source->broken = true;
    const Tile after(tile), again(after);
    EXPECT_TRUE(before.sound());
    EXPECT_FALSE(tile.sound());
    EXPECT_FALSE(after.sound());
    EXPECT_FALSE(again.sound());
}

TEST(Tiles, OfOnePlaceAreTheSameUnread) {
    const auto source = std::make_shared<Counted>(), other = std::make_shared<Counted>();
    EXPECT_TRUE(sameTexels(Tile(source, 3, 16), Tile(source, 3, 16)));
    EXPECT_EQ(source->reads, 0);
    EXPECT_TRUE(sameTexels(Tile(source, 3, 16), Tile(other, 3, 16))) << "by their bytes";
    EXPECT_EQ(source->reads + other->reads, 2);
    EXPECT_FALSE(sameTexels(Tile(source, 3, 16), Tile(source, 4, 16)));
}
