// What tests measure of pictures: linear ones have three floats a pixel, as Renderer::readLinear gives them.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
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

// How two shown pictures of one size differ, in words; empty: not at all.
inline std::string difference(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
    size_t values = 0;
    int most = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        const int by = std::abs(int{a[i]} - int{b[i]});
        values += by > 0, most = std::max(most, by);
    }
    if (a.size() == b.size() && values == 0) return "";
    return std::to_string(values) + " of " + std::to_string(a.size()) + " values (and " + std::to_string(b.size()) +
           "), by " + std::to_string(most) + " levels at most";
}

}  // namespace sward::test
