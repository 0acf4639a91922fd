// Maps from and to files: PNG 8/16, EXR half or float, TIFF 8/16/half/float, R16 with a JSON sidecar. From files also
// integers with a sign or of 32 bits, and double, as floats of the same values; a GeoTIFF's texels without data are
// replaced as those that are not finite.
// Headers are checked against kMaxMapSide and kMaxMapBytes before any pixel is read, so a refusal costs milliseconds.
// R16: 16-bit little-endian texels without a header, one channel; FILE.r16 goes with FILE.json (or FILE.r16.json):
// {"height", "range", "width"}, where range (optional) says what 0 and full scale stand for.
// An EXR's data window may start anywhere: its pixels are the map, wherever the display window lies.
// A file with an RGB image serves a wish for four channels, with alpha 1; no other count of channels stands for
// another. Channels are taken as they are: no colour conversion, and alpha is not multiplied in.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "maps/map.h"

namespace sward {

struct MapWish {
    int channels = 1;               // 0: any from 1 to 4
    bool isHeight = false;          // 8-bit files are refused
    std::optional<PixelType> type;  // convert to this; default: the file's own
    bool flip = false;              // first row is z = max
    bool mayStay =
        false;  // a large map's texels may stay in a file of tiles, which is ours: nobody else writes over it
    std::optional<uint64_t> directory;  // of a TIFF: readImageHead
    std::optional<std::pair<double, double>>
        range;  // full scale of integers, or floats mapped to [0,1] when importing to an integer map
};
// Unsound errors: unreadable, truncated, size 0, over a limit, another count of channels, heights of 8 bits.
// repaired: non-finite texels replaced by the nearest finite one (0 if none is) are counted and located in it, and a
// map of one texel is named.
// Maps that may stay in their file are not read but opened, where they are large, the file is of tiles (tile_file.h)
// and no flip or conversion is asked for. Cost: 4096 x 4096 heights about 0.5 s on two cores.
Result<Map> readMap(const std::filesystem::path& file, const MapWish& wish,
                    std::vector<std::string>* repaired = nullptr);
// What readMap would refuse of a map of this size; `file` is named in the error.
Status checkMapLimits(const std::filesystem::path& file, const MapInfo& info);
// The range that the sidecar of an R16 file states; nothing if it states none, is unsound, or the file is no R16.
std::optional<std::pair<double, double>> sidecarRange(const std::filesystem::path& file);
// Format by extension: .png, .exr (writes float), .tif, .tiff, .r16. With a range integer maps become floats lo to hi
// in an EXR, and float maps 16-bit integers in PNG and R16; without it PNG and R16 refuse float maps. A TIFF of more
// than kHeldTexels integers is one of tiles, unless it is flipped. Writes to a temporary beside it, fsyncs, renames.
// Failed error too, if not all texels can be read from the file in which they lie.
Status writeMap(const std::filesystem::path& file, const Map& map, bool flip = false,
                const std::optional<std::pair<double, double>>& range = {});
// RGBA8 image, first row on top: screenshots, renders, heat maps. linear EXR: writeImageExr with 3 or 4 floats a pixel.
Status writeImagePng(const std::filesystem::path& file, int width, int height, int channels,
                     const std::vector<uint8_t>& pixels);
Status writeImageExr(const std::filesystem::path& file, int width, int height, int channels,
                     const std::vector<float>& pixels);
struct Image {
    int width = 0, height = 0, channels = 0;
    bool linear = false;        // from a float file
    std::vector<float> pixels;  // [0,1] from integer files
};
// Any image the same limits allow; values that are not finite become 0, or stay where `keepNonFinite` asks for it.
Result<Image> readImage(const std::filesystem::path& file, bool keepNonFinite = false);
// Whether readImage would accept the file: all of it is decoded.
Status checkImage(const std::filesystem::path& file);

}  // namespace sward
