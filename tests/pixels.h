// What tests measure of a linear picture: three floats a pixel, as Renderer::readLinear gives them.
#pragma once
#include <vector>

namespace sward::test {

// Mean luminance.
inline double brightness(const std::vector<float>& pixels) {
    double sum = 0;
    for (size_t i = 0; i < pixels.size(); i += 3)
        sum += 0.2126 * static_cast<double>(pixels[i]) + 0.7152 * static_cast<double>(pixels[i + 1]) +
               0.0722 * static_cast<double>(pixels[i + 2]);
    return 3 * sum / static_cast<double>(pixels.size());
}
// Share of pixels in which green beats red: of grass, over soil that is red.
inline double covered(const std::vector<float>& pixels) {
    size_t n = 0;
    for (size_t i = 0; i < pixels.size(); i += 3) n += pixels[i + 1] > pixels[i];
    return 3.0 * static_cast<double>(n) / static_cast<double>(pixels.size());
}

}  // namespace sward::test
