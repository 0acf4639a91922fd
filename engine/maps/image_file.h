// Image files by rows: the one place behind which OpenImageIO stands. Used by map_io.cpp, and to write images into
// objects.
// PNG, EXR and TIFF, told apart by their first bytes, whatever their name.
// Does not: check limits beyond what a Map can hold, convert, or repair.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/error.h"
#include "maps/map.h"

namespace sward {

// Reads rows of a file, channels interleaved, first row on top. 8 and 16-bit integers without a sign are shares of
// their full scale, and stay what they are. All else comes as F32: floats of any size, and integers with a sign or of
// 32 bits by their values, as those of elevation models, which are metres.
class ImageReader {
  public:
    // Reads the header only. Unsound error if the file cannot be read, is of another format, damaged, of size 0,
    // beyond kMaxMapSide or kMaxMapBytes, has more than four channels, channels of different sizes, or integers of 64
    // bits. Sizes are checked before the library sees the file.
    static Result<std::unique_ptr<ImageReader>> open(const std::filesystem::path& file);
    virtual ~ImageReader() = default;
    virtual const MapInfo& info() const = 0;
    // ImageHead::noData, in the file's own numbers.
    virtual std::optional<double> noData() const = 0;
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
