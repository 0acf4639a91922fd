// How far apart two images are. RGB only, alpha ignored; values sRGB-encoded in [0,1]; linear images are tone-mapped first
// (Khronos PBR Neutral, as the renderer does) unless `linear` is asked for.
// Pixels that are not finite are counted and located, and left out of every mean.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/map_io.h"

namespace sward {

struct Difference {
    double rmse = 0;          // over all channels
    double psnr = 0;          // dB of a peak of 1; infinite for equal images
    uint64_t pixels = 0;      // compared
    uint64_t nonFinite = 0;   // left out, in either image
    int nonFiniteX = -1, nonFiniteY = -1;  // the first of them
};
// Failed if the sizes differ, naming both, or if no pixel is left.
Result<Difference> compareImages(const Image& a, const Image& b, bool linear);
// RGB8 of the largest channel difference a pixel, from black over red and yellow to white at a difference of 0.5.
std::vector<uint8_t> heatmap(const Image& a, const Image& b, bool linear);

}  // namespace sward
