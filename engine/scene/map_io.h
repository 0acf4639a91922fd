// Maps from and to files: PNG 8/16, EXR half or float, TIFF, R16 with a JSON sidecar.
// Headers are checked against kMaxMapSide and kMaxMapBytes before any pixel is read.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "scene/map.h"

namespace sward {

struct MapWish {
    int channels = 1;
    bool isHeight = false;                // 8-bit files are refused
    std::optional<PixelType> type;        // convert to this; default: the file's own
    bool flip = false;                    // first row is z = max
    std::optional<std::pair<double, double>> range;  // full scale of integers, or floats mapped to [0,1] when importing to an integer map
};
// repaired: non-finite texels replaced by the nearest finite one are counted and located in it.
Result<Map> readMap(const std::filesystem::path& file, const MapWish& wish, std::vector<std::string>* repaired = nullptr);
// Format by extension. PNG refuses float maps, EXR writes float. Writes to a temporary beside it, fsyncs, renames.
Status writeMap(const std::filesystem::path& file, const Map& map, bool flip = false);
// RGBA8 image, first row on top: screenshots, renders, heat maps. linear EXR: writeImageExr with 3 or 4 floats a pixel.
Status writeImagePng(const std::filesystem::path& file, int width, int height, int channels, const std::vector<uint8_t>& pixels);
Status writeImageExr(const std::filesystem::path& file, int width, int height, int channels, const std::vector<float>& pixels);
struct Image {
    int width = 0, height = 0, channels = 0;
    bool linear = false;                  // from a float file
    std::vector<float> pixels;            // [0,1] from integer files
};
// Any image the same limits allow.
Result<Image> readImage(const std::filesystem::path& file);

}  // namespace sward
