// What metrics read: two pictures of one size as they are shown, and how much each pixel counts.
// Values are sRGB-encoded in [0,1]; linear images are tone-mapped first (Khronos PBR Neutral, as the renderer does)
// unless they are wanted as they are. RGB only: alpha is ignored, gray stands for three equal channels. Pixels that are
// not finite are counted and located, weigh nothing, and stay not-a-number in every map of errors.
// A traced picture brings the scatter of its rays along, so that metrics can tell it from what the scene has.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "maps/map_io.h"

namespace sward {

struct Picture {
    int width = 0, height = 0;
    bool linear = false;            // values are as they are in a linear file, neither tone-mapped nor encoded
    std::vector<glm::vec3> pixels;  // first row on top
    // By how much rays scatter each pixel's channels: the variance of the value, known of traced pictures alone. Empty:
    // none, or none is known; 0: of a pixel of one ray, or without.
    std::vector<glm::vec3> noise = {};
};
// Picture of an image file: one to four channels become three. `linear`: values are taken as they are; else those of a
// linear file (EXR) are tone-mapped and encoded.
Picture pictureOf(const Image& image, bool linear);
// RGB floats before tone mapping, as Renderer::readLinear and the reference give them.
Picture pictureOfLinear(int width, int height, const std::vector<float>& rgb);
// The same of a traced one, whose standard errors are known: `error` is the standard error of each linear value, as
// many as `rgb` has. Encoding bends what it scatters: the noise is what the value moves by where all channels move by
// their error at once (the rays of a pixel mostly miss in all three), and half of what the bend takes from the mean of
// scattered values is given back, to the second order.
Picture tracedPicture(int width, int height, const std::vector<float>& rgb, const std::vector<float>& error);
// Of files: the image and the standard errors beside it, equally large; `linear` as for pictureOf.
Picture tracedPicture(const Image& image, const Image& error, bool linear);

struct PicturePair {
    Picture image, truth;       // not-a-number in both where either is not finite
    std::vector<float> weight;  // a pixel's share of grass; 1 without a mask; 0 where either picture is not finite
    double weightSum = 0;
    uint64_t nonFinite = 0;                // pixels, in either picture
    int nonFiniteX = -1, nonFiniteY = -1;  // the first of them
};
// mask: a share of grass in [0,1] a pixel (clamped; not finite counts as 0), or empty: all pixels count.
// Failed if the sizes differ, naming both, or if no pixel counts; Unsound if one is linear and the other is not.
Result<PicturePair> pairPictures(Picture image, Picture truth, const std::vector<float>& mask = {});

// One value a pixel; not-a-number where there is none.
using ErrorMap = std::vector<float>;
inline constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();
// Mean over the pixels that have a value, by their weight. Not-a-number if none has.
double weightedMean(const ErrorMap& map, const std::vector<float>& weight);

}  // namespace sward
