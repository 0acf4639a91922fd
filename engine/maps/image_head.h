// What the headers of PNG, EXR and TIFF files declare, read without any library: a header of a few bytes can make a
// library take all memory before it hands the size out, and a library may read missing pixels as zeros.
#pragma once
#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "maps/map.h"

namespace sward {

// Tiles of a TIFF that are texels as a Map holds them: of kTileSize, not compressed, integers of this machine's order.
struct PlainTiles {
    MapInfo info;
    uint64_t directory = 0;        // where that begins which says so
    std::vector<uint64_t> places;  // in the file, rows first
};

struct ImageHead {
    std::string format;  // "png", "exr" or "tif"
    int64_t width = 0, height = 0;
    std::optional<double> noData;  // of a GeoTIFF: the value of texels of which nothing is known
    std::optional<PlainTiles> tiles;
};
// Unsound error if the file cannot be read, is empty or truncated within its header, or of none of these formats.
// The chunks of a PNG and the strips or tiles of a TIFF must lie within the file.
// directory: of a TIFF, where the one to read begins, if it is not the one that its head names.
Result<ImageHead> readImageHead(const std::filesystem::path& file, std::optional<uint64_t> directory = {});
// The part of it for TIFF. `in` is at any place; `size` is that of the file.
Result<ImageHead> readTiffHead(const std::filesystem::path& file, std::istream& in, uint64_t size,
                               std::optional<uint64_t> directory = {});

}  // namespace sward
