#include "reference/surface.h"

#include <algorithm>

#include "core/numerics.h"
#include "maps/map.h"

namespace sward {
namespace {

// The two texels around x of n, and the second one's weight.
struct Taps {
    int a, b;
    float share;
};
Taps tapsAt(double x, int n, bool repeat) {
    x = (repeat ? x - std::floor(x) : std::clamp(x, 0.0, 1.0)) * n - 0.5;
    const double low = std::floor(x);
    const int i = static_cast<int>(low);
    const auto inside = [&](int k) { return repeat ? (k + n) % n : std::clamp(k, 0, n - 1); };
    return {inside(i), inside(i + 1), static_cast<float>(x - low)};
}

template <class F>
glm::vec4 bilinear(const Taps& x, const Taps& y, F texel) {
    return glm::mix(glm::mix(texel(x.a, y.a), texel(x.b, y.a), x.share),
                    glm::mix(texel(x.a, y.b), texel(x.b, y.b), x.share), y.share);
}

}  // namespace

glm::vec4 TexelGrid::at(double u, double v, bool repeat) const {
    return bilinear(tapsAt(u, width, repeat), tapsAt(v, height, repeat), [&](int x, int y) {
        return texels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    });
}

TexelGrid texelGridOf(const Rgba8& image) {
    TexelGrid p{image.width, image.height, {}};
    p.texels.reserve(image.pixels.size() / 4);
    for (size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
        const auto channel = [&](size_t c) { return static_cast<float>(image.pixels[i + c]) / 255; };
        p.texels.emplace_back(f32::srgbDecode3({channel(0), channel(1), channel(2)}), channel(3));
    }
    return p;
}

glm::vec4 paintedAt(const Map& map, const glm::dvec2& place, double tiling, bool srgb) {
    const MapInfo& info = map.info();
    return bilinear(tapsAt(place.x * tiling, info.width, true), tapsAt(place.y * tiling, info.height, true),
                    [&](int x, int y) {
                        glm::vec4 t(0, 0, 0, 1);
                        for (int c = 0; c < info.channels; ++c) t[c] = map.at(x, y, c);
                        return srgb ? glm::vec4(f32::srgbDecode3(glm::vec3(t)), t.w) : t;
                    });
}

}  // namespace sward
