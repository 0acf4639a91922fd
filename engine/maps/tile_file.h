// Large maps in files of tiles: TIFF, not compressed, in the tiles that a Map has, so that a tile can be read when it
// is looked at, and a map saved by what changed. Any program that reads tiled TIFF reads them. What changed is added at
// the file's end, with a directory that refers to old tiles and new ones; then the file's head refers to that directory
// (core/file_growth.h). What no directory refers to any more stays in the file until it would be twice as large as the
// map: then it is written anew. Does not: read other TIFFs (image_file.h), nor floats, which are looked through for
// what is no number.
#pragma once
#include <filesystem>

#include "core/error.h"
#include "core/file_growth.h"
#include "maps/image_head.h"
#include "maps/map.h"

namespace sward {

// Up to so many texels maps are read whole; larger ones of integers are kept in tiles.
inline constexpr size_t kHeldTexels = size_t(4096) * 4096;

// Whether a map is so large, and of integers: one that is kept in a file of tiles.
bool keptInTiles(const MapInfo& info);
// A map whose tiles lie in the file, which stays open as long as any of them lives. Tiles of one place are one. Unsound
// error if it cannot be opened.
Result<Map> openTiles(const std::filesystem::path& file, const PlainTiles& tiles);
// Unsound error, naming the file, if a texel of a map could not be read from it so far, or another program wrote over
// it in its place: then nobody knows what the map was.
Status tilesSound(const Map& map);
// The same after all texels were read.
Status checkTiles(const Map& map);
// A new file, flushed. The map's are integers. Failed error if it cannot be written, or not all of it can be read.
Status writeTiles(const std::filesystem::path& file, const Map& map);
// What writeTiles wrote, or another program in the same form, as its head refers to it; nothing if it is another file.
std::optional<PlainTiles> tilesOf(const std::filesystem::path& file, const MapInfo& info);
// Whether a file that holds `before` is to grow to hold `now`: not if too much of it changed or no longer counts.
bool worthGrowing(const std::filesystem::path& file, const Map& before, const Map& now);
// Adds what changed. tiles: of the file as it is, which holds `before`. Returns what makes it count.
Result<HeadSwitch> growTiles(FileGrowth& file, const PlainTiles& tiles, const Map& before, const Map& now);

}  // namespace sward
