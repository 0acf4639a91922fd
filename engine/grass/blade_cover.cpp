#include "grass/blade_cover.h"

#include <algorithm>
#include <cmath>

namespace sward {

AlphaMoments alphaMoments(const Rgba8& image) {
    if (image.pixels.empty()) return {1, 0.5, 1.0 / 3, 0.25};
    const auto w = static_cast<size_t>(image.width), h = static_cast<size_t>(image.height);
    AlphaMoments out{};
    for (size_t y = 0; y < h; ++y) {
        double alpha = 0;
        for (size_t x = 0; x < w; ++x) alpha += image.pixels[4 * (y * w + x) + 3];
        const double v = (static_cast<double>(y) + 0.5) / static_cast<double>(h);
        for (size_t k = 0; k < out.size(); ++k)
            out[k] += alpha / (255.0 * static_cast<double>(w * h)) * std::pow(v, static_cast<double>(k));
    }
    // An image that is clear shows nothing, whatever its middle is.
    return out[0] > 1e-6 ? out : AlphaMoments{1e-6, 0.5e-6, 1e-6 / 3, 0.25e-6};
}

glm::vec3 meanColor(const Rgba8& image) {
    glm::dvec3 sum(0);
    double weights = 0;
    const size_t texels = image.pixels.size() / 4, across = static_cast<size_t>(std::max(image.width, 1));
    for (size_t i = 0; i < texels; ++i) {
        const uint8_t* texel = &image.pixels[4 * i];
        const double v = (static_cast<double>(i / across) + 0.5) / image.height, weight = (1 + 3 * v) * texel[3];
        sum += weight * glm::dvec3(f32::srgbDecode3(glm::vec3(texel[0], texel[1], texel[2]) / 255.0f));
        weights += weight;
    }
    return weights > 0 ? glm::vec3(sum / weights) : glm::vec3(0.5f);
}

std::vector<float> alphaAlong(const Rgba8& image, int parts) {
    std::vector<float> out(static_cast<size_t>(parts), 1.0f);
    if (image.pixels.empty()) return out;
    for (int i = 0; i < parts; ++i) {
        const int from = std::min(i * image.height / parts, image.height - 1),
                  to = std::max((i + 1) * image.height / parts, from + 1);
        double alpha = 0;
        for (int y = from; y < to; ++y)
            for (int x = 0; x < image.width; ++x)
                alpha += image.pixels[static_cast<size_t>(4 * (y * image.width + x) + 3)];
        out[static_cast<size_t>(i)] = static_cast<float>(alpha / (255.0 * image.width * (to - from)));
    }
    return out;
}

void setCover(SpeciesGlobals& g, const AlphaMoments& m) {
    // The spline is control times 2v(1 - v) and tip times v^2; the reach is its derivative, weighted.
    g.middle = glm::vec2(2 * (m[1] - m[2]), m[2]) / static_cast<float>(m[0]);
    g.reach = {2 * (m[0] - 2 * m[1]), 2 * m[1]};
    g.covered = static_cast<float>(m[0]);
    g.middleRow = static_cast<float>(m[1] / m[0]);
    // The straight line through what a square curve is there and at the tip has the curve's mean over what is seen of
    // blades among others: from a fourth at the root to all at the tip.
    g.lightRow = static_cast<float>((m[1] + 2 * m[2] - 3 * m[3]) / std::max(m[0] + 2 * m[1] - 3 * m[2], 1e-9));
}

}  // namespace sward
