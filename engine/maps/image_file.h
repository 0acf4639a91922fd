// Image files by rows: the one place behind which OpenImageIO stands. Used by map_io.cpp only.
// PNG, EXR and TIFF, told apart by their first bytes, whatever their name.
// Does not: check limits beyond what a Map can hold, convert, or repair.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/error.h"
#include "maps/map.h"

namespace sward {

// Reads rows of a file in its own type (half floats as F32), channels interleaved, first row on top.
class ImageReader {
  public:
    // Reads the header only. Unsound error if the file cannot be read, is of another format, damaged, of size 0,
    // beyond kMaxMapSide or kMaxMapBytes, has more than four channels, or another type than 8- or 16-bit integers and
    // floats. Sizes are checked before the library sees the file.
    static Result<std::unique_ptr<ImageReader>> open(const std::filesystem::path& file);
    virtual ~ImageReader() = default;
    virtual const MapInfo& info() const = 0;
    // Rows in order: y0 = 0 first, then where the last call ended; `out` takes rows * width texels.
    virtual Status readRows(int y0, int rows, void* out) = 0;
};

// Size and channels against the limits; `file` is named in the error.
Status checkLimits(const std::filesystem::path& file, int64_t width, int64_t height, int64_t channels,
                   size_t bytesPerChannel);

// Encodes an image as "png", "exr" or "tif" and returns the file's bytes. rows(y0, n, out) fills n rows.
// PNG takes integers only.
Result<std::string> encodeImage(const std::string& format, const MapInfo& info,
                                const std::function<void(int, int, void*)>& rows);

}  // namespace sward
