#include "metrics/heatmap.h"

#include <algorithm>
#include <array>

#include "core/numerics.h"

namespace sward {
namespace {

// L*a*b* (white D65) to linear sRGB.
glm::dvec3 rgbOfLab(const glm::dvec3& lab) {
    const auto cube = [](double t) { return t > 6.0 / 29 ? t * t * t : 3 * (6.0 / 29) * (6.0 / 29) * (t - 4.0 / 29); };
    const double y = (lab.x + 16) / 116;
    const glm::dvec3 v =
        glm::dvec3(0.9505, 1, 1.089) * glm::dvec3(cube(y + lab.y / 500), cube(y), cube(y - lab.z / 200));
    return {3.2406 * v.x - 1.5372 * v.y - 0.4986 * v.z, -0.9689 * v.x + 1.8758 * v.y + 0.0415 * v.z,
            0.0557 * v.x - 0.2040 * v.y + 1.0570 * v.z};
}
bool holds(const glm::dvec3& rgb) {
    return glm::min(glm::min(rgb.x, rgb.y), rgb.z) >= 0 && glm::max(glm::max(rgb.x, rgb.y), rgb.z) <= 1;
}

}  // namespace

glm::vec3 heatColor(double t) {
    t = std::clamp(t, 0.0, 1.0);
    const double lightness = 2 + 95 * t, hue = glm::radians(-60 + 160 * t);
    const glm::dvec2 direction(std::cos(hue), std::sin(hue));
    double chroma = 0;
    for (double reach = 40; reach > 0.5; reach /= 2) {
        const glm::dvec2 ab = (chroma + reach) * direction;
        if (holds(rgbOfLab({lightness, ab.x, ab.y}))) chroma += reach;
    }
    const glm::dvec2 ab = chroma * direction;
    return glm::vec3(f64::srgbEncode3(rgbOfLab({lightness, ab.x, ab.y})));
}

std::vector<uint8_t> heatmap(const ErrorMap& map, double full) {
    std::array<glm::vec3, 256> scale;
    for (size_t i = 0; i < scale.size(); ++i) scale[i] = heatColor(static_cast<double>(i) / 255);
    std::vector<uint8_t> out;
    out.reserve(map.size() * 3);
    for (const float e : map) {
        const glm::vec3 c = std::isfinite(e)
                                ? scale[static_cast<size_t>(std::lround(255 * std::clamp(e / full, 0.0, 1.0)))]
                                : glm::vec3(0, 1, 0);
        for (int i = 0; i < 3; ++i) out.push_back(static_cast<uint8_t>(std::lround(255 * c[i])));
    }
    return out;
}

}  // namespace sward
