// The one map type: an image in tiles of 128 x 128, immutable, shared, copied on write.
// Copying a Map copies tile pointers only, so undo, snapshots, autosave, background jobs, dirty upload, hashing and
// saving are one mechanism: keep a copy, compare tile pointers.
// Does not: read or write files (map_io.h), nor know what its channels mean.
// Row 0 is z = 0, column 0 is x = 0; texel centres lie at (i + 0.5) / width.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "maps/tile.h"

namespace sward {

inline constexpr int kTileSize = 128;
inline constexpr int kMaxMapSide = 16384;                // larger maps are refused
inline constexpr size_t kMaxMapBytes = size_t(1) << 30;  // and heavier ones

enum class PixelType : uint8_t { U8, U16, F32 };
// Bytes of one channel of a texel.
constexpr size_t pixelBytes(PixelType t) { return t == PixelType::U8 ? 1 : t == PixelType::U16 ? 2 : 4; }

struct MapInfo {
    int width = 0, height = 0;
    int channels = 1;  // 1 to 4
    PixelType type = PixelType::U16;
    bool operator==(const MapInfo&) const = default;
};

class Map {
  public:
    Map() = default;
    // Every texel zero. Sizes from 1 to kMaxMapSide.
    explicit Map(const MapInfo& info);

    // Size, channels and type; width and height 0 for a map that was never made.
    const MapInfo& info() const { return info_; }
    // True for a map that was never made: it has no texel.
    bool empty() const { return info_.width == 0; }
    // Tiles along x and along z; those at the far edges may be filled in part.
    int tilesX() const { return (info_.width + kTileSize - 1) / kTileSize; }
    int tilesY() const { return (info_.height + kTileSize - 1) / kTileSize; }

    // Identity of a tile: equal pointers mean equal texels. Zero tiles share one. It holds kTileSize * kTileSize
    // texels, rows first, channels interleaved; texels beyond the map's edge are zero.
    const std::shared_ptr<const Tile>& tile(int tx, int ty) const { return tiles_[index(tx, ty)]; }
    // Puts a tile of tileBytes() in place; tx in [0, tilesX()), ty in [0, tilesY()).
    void setTile(int tx, int ty, std::shared_ptr<const Tile> t) { tiles_[index(tx, ty)] = std::move(t); }
    // The tile's bytes to write to; copies the tile first if anyone else has it, or it lies in a file.
    std::byte* writeTile(int tx, int ty);
    // Bytes of a whole tile, and of one texel.
    size_t tileBytes() const { return size_t(kTileSize) * kTileSize * texelBytes(); }
    size_t texelBytes() const { return size_t(info_.channels) * pixelBytes(info_.type); }

    // One channel of a texel as a number: integers as [0,1], floats as they are. x, y are clamped to the map.
    float at(int x, int y, int c = 0) const;
    // Integers are clamped to [0,1] and rounded to nearest. x, y must be inside.
    void set(int x, int y, int c, float value);
    // Bilinear at (u, v) in [0,1] of the map, clamped at the edges; the same rule as the shaders (numerics/bilinear.h).
    float sample(double u, double v, int c = 0) const;
    // Whole rows, tightly packed, in the map's own pixel type: for reading and writing files. `out` has room for rows *
    // width * texelBytes() bytes.
    void readRows(int y0, int rows, void* out) const;
    // The other way: from `in`, laid out as readRows lays it out. y0 and y0 + rows must be inside.
    void writeRows(int y0, int rows, const void* in);

    // Hash over width, height, channels and pixels as saved (not over the pixel padding of edge tiles).
    uint64_t hash() const;
    // Mean of a channel over all texels, as at() gives them; 0 for an empty map.
    double mean(int c = 0) const;
    // True if both have the same info and every tile pointer agrees (no texel is read).
    bool sameTiles(const Map& other) const { return info_ == other.info_ && tiles_ == other.tiles_; }

  private:
    size_t index(int tx, int ty) const { return size_t(ty) * size_t(tilesX()) + size_t(tx); }
    MapInfo info_;
    std::vector<std::shared_ptr<const Tile>> tiles_;
};

// What a component holds for a map: its file, relative to the project's folder, and its texels.
struct MapField {
    std::string file;  // empty: not set; the consumer takes its stated constant
    Map map;           // empty exactly when file is
    // True if the field has a map.
    bool present() const { return !map.empty(); }
};

}  // namespace sward
