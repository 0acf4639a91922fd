// A small picture of an image file or a map, with what it holds in numbers: to be looked at before it is taken.
// Does not: draw it. Cost: reading the file; 4096 x 4096 texels about half a second.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "maps/map.h"

namespace sward {

inline constexpr int kPreviewSide = 64;  // pixels of its longer side, at most

struct ImagePreview {
    std::string file;                   // whose it is; empty: none
    std::string error;                  // why there is no picture
    int width = 0, height = 0;          // pixels of the picture
    std::vector<uint32_t> pixels;       // 0xAABBGGRR, the file's upper row first
    MapInfo info;                       // of the image
    double low = 0, high = 0;           // the least and the greatest of its numbers, as Map::at gives them
    std::vector<std::string> repaired;  // what reading mended
};

// Of a file; what is wrong with it is in `error`.
ImagePreview previewOf(const std::string& file);
// Of a map: one channel from black (low) to white (high), two as red and green, three and four as they are.
ImagePreview previewOf(const Map& map);
// "1024 x 512, 16 bit, 1 channel, 0.12 to 0.87"
std::string describe(const ImagePreview& preview);

}  // namespace sward
