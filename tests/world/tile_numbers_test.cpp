// Tiles as numbers: the same texels give the same tile, and boxes hold what differs.
#include "world/tile_numbers.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(TileNumbers, AreWhatTheMapsTexelsAre) {
    for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::F32}) {
        Map map({200, 150, 1, type});
        map.set(130, 5, 0, 0.4f);
        Numbers numbers(kTileTexels);
        readTile(map, 1, 0, numbers);
        EXPECT_EQ(numbers[5 * kTileSize + 2], map.at(130, 5));
        EXPECT_EQ(makeTile(map, 1, 0, numbers, NumberRange::Unit), map.tile(1, 0)) << "the tile that stands there";
        numbers[0] = 7;
        const auto unit = makeTile(map, 1, 0, numbers, NumberRange::Unit);
        EXPECT_NE(unit, map.tile(1, 0));
        map.setTile(1, 0, unit);
        EXPECT_EQ(map.at(128, 0), 1);
    }
    Map metres({200, 150, 1, PixelType::F32});
    Numbers numbers(kTileTexels, -12.5f);
    metres.setTile(1, 1, makeTile(metres, 1, 1, numbers, NumberRange::Any));
    EXPECT_EQ(metres.at(199, 149), -12.5f);
    readTile(metres, 1, 1, numbers);
    EXPECT_EQ(numbers.back(), 0) << "texels beyond the edge are zero";
}

TEST(TileNumbers, BoxesHoldWhatDiffersAndItsNeighbours) {
    Map before({512, 512, 1, PixelType::F32}), now = before;
    EXPECT_TRUE(changedBoxes(before, now).empty());
    EXPECT_TRUE(isZero(now));
    now.set(300, 40, 0, 1);
    EXPECT_FALSE(isZero(now));
    const std::vector<MapBox> boxes = changedBoxes(before, now);
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_TRUE(isIn(boxes, 300.5 / 512, 40.5 / 512));
    EXPECT_TRUE(isIn(boxes, 298.5 / 512, 42.5 / 512));
    EXPECT_FALSE(isIn(boxes, 297.5 / 512, 40.5 / 512));
    EXPECT_EQ(tilesIn(now, boxes), (std::vector<TilePlace>{{2, 0}}));
    EXPECT_EQ(tilesThatDiffer(before, now), (std::vector<TilePlace>{{2, 0}}));
    EXPECT_EQ(tilesIn(now, {kEverywhere}).size(), 16u);
    EXPECT_EQ(changedBoxes(Map({256, 256, 1, PixelType::F32}), now).front().x0, kEverywhere.x0);
}

}  // namespace
}  // namespace sward
