// The sizes that PNG and EXR headers declare, read without any library: a header of a few bytes can make a library
// take all memory before it hands the size out.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/error.h"

namespace sward {

struct ImageHead {
    std::string format;              // "png", "exr" or "tif"
    int64_t width = 0, height = 0;   // 0 with tif: not read here
};
// Unsound error if the file cannot be read, is empty or truncated within its header, or of none of these formats.
// A PNG is walked from chunk to chunk to its end, for a library notices only missing pixels.
Result<ImageHead> readImageHead(const std::filesystem::path& file);

}  // namespace sward
