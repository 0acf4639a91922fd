// Tiles of maps as floats, and where two states of a map differ: what layers are evaluated by.
// Does not: know layers (world/layer_coverage.h). A map lies on the terrain once here; places are shares of its sides.
#pragma once
#include <memory>
#include <vector>

#include "core/jobs.h"
#include "maps/map.h"

namespace sward {

inline constexpr size_t kTileTexels = size_t(kTileSize) * kTileSize;
using Numbers = std::vector<float>;  // of a tile, rows first: kTileTexels of them, times the map's channels

// As Map::at gives them, channels side by side; `out` has room for them.
void readTile(const Map& map, int tx, int ty, Numbers& out);

enum class NumberRange { Unit, Any };  // kept within 0 to 1, or as they are (floats only)
// A tile of these numbers; texels beyond the map's edge are zero. The one that stands there if it is the same.
std::shared_ptr<const Tile> makeTile(const Map& map, int tx, int ty, const Numbers& numbers, NumberRange range);
// Whether every texel is 0.
bool isZero(const Map& map);

// A part of the terrain, as shares of its sides; both ends belong to it.
struct MapBox {
    double x0, z0, x1, z1;
};
inline constexpr MapBox kEverywhere{-1e9, -1e9, 1e9, 1e9};

// Where maps differ, and as far around as a texel's neighbours read; everywhere if their sizes or types do.
std::vector<MapBox> changedBoxes(const Map& before, const Map& now);
// Whether (u, v) lies in one of them.
bool isIn(const std::vector<MapBox>& boxes, double u, double v);

struct TilePlace {
    int x, y;
    bool operator==(const TilePlace&) const = default;
};
// Tiles of the map that any of the boxes meets, rows first.
std::vector<TilePlace> tilesIn(const Map& map, const std::vector<MapBox>& boxes);
// Tiles that two maps of one size do not share, rows first.
std::vector<TilePlace> tilesThatDiffer(const Map& a, const Map& b);

// Calls numbers(tile, out) for each tile, on several threads, and puts what it wrote into the map.
template <class F>
void evaluateTiles(Map& map, const std::vector<TilePlace>& tiles, NumberRange range, const F& numbers) {
    std::vector<std::shared_ptr<const Tile>> made(tiles.size());
    parallelFor(tiles.size(), [&](size_t i) {
        Numbers out(kTileTexels * static_cast<size_t>(map.info().channels));
        numbers(tiles[i], out);
        made[i] = makeTile(map, tiles[i].x, tiles[i].y, out, range);
    });
    for (size_t i = 0; i < tiles.size(); ++i) map.setTile(tiles[i].x, tiles[i].y, std::move(made[i]));
}

}  // namespace sward
