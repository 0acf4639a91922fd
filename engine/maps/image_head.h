// What the headers of PNG, EXR and TIFF files declare, read without any library: a header of a few bytes can make a
// library take all memory before it hands the size out, and a library may read missing pixels as zeros.
#pragma once
#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>

#include "core/error.h"

namespace sward {

struct ImageHead {
    std::string format;  // "png", "exr" or "tif"
    int64_t width = 0, height = 0;
    std::optional<double> noData;  // of a GeoTIFF: the value of texels of which nothing is known
};
// Unsound error if the file cannot be read, is empty or truncated within its header, or of none of these formats.
// The chunks of a PNG and the strips or tiles of a TIFF must lie within the file.
Result<ImageHead> readImageHead(const std::filesystem::path& file);
// The part of it for TIFF: the first directory. `in` is at any place; `size` is that of the file.
Result<ImageHead> readTiffHead(const std::filesystem::path& file, std::istream& in, uint64_t size);

}  // namespace sward
