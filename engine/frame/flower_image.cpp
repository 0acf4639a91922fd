#include "frame/flower_image.h"

#include "core/numerics.h"
#include "scene/technique.h"

namespace sward {
namespace {

constexpr int kPetals = 15;
constexpr float kCentre = 0.3f;  // radius, as a share of the head's

struct Texel {
    float petal = 0, centre = 0, light = 0, alpha = 0;
};

float inside(float distance, float pixel) { return std::clamp(0.5f - distance / pixel, 0.0f, 1.0f); }

// x, y in [-1, 1] over the head.
Texel headAt(float x, float y, float pixel) {
    const float r = std::sqrt(x * x + y * y), turn = std::atan2(y, x) / (2 * f32::kPi) + 1;
    const float n = turn * kPetals, a = std::abs(n - std::floor(n) - 0.5f) * 2;  // 0: along a petal; 1: between two
    const float own = f32::hashUnit(f32::hash2(static_cast<uint32_t>(std::floor(n)) % kPetals, 3u));
    const float length = (0.86f + 0.12f * own) * (1 - 0.16f * a * a),
                gap = (a - 1.02f + 0.42f * r * r * r) * r / kPetals * 3;
    Texel t;
    t.centre = inside(r - kCentre, pixel);
    const float petal = inside(std::max(r - length, gap), pixel);
    t.alpha = std::max(t.centre, petal);
    t.petal = 1 - t.centre;
    const float grain =
        f32::hashUnit(f32::hash2(static_cast<uint32_t>(x * 24 + 24), static_cast<uint32_t>(y * 24 + 24)));
    t.light = glm::mix(0.36f + 0.12f * (1 - a) + 0.05f * r, 0.52f - 0.7f * r * r + 0.1f * grain, t.centre);
    return t;
}

// A leaf from the stem outward and up. x in [-1, 1] across, y in [0, 1] down from the head; side: -1 or 1.
float leafDistance(float x, float y, float from, float side) {
    const float along = x * side, rise = from - y;
    const float t = along / 0.55f;
    if (t < 0 || t > 1) return 1;
    return std::abs(rise - 0.22f * t) - 0.05f * std::sin(f32::kPi * std::sqrt(t));
}

Texel stemAt(float x, float y, float pixel) {
    Texel t;
    const float stem = std::abs(x - 0.02f * std::sin(5 * y)) - 0.055f;
    t.alpha = std::max(inside(stem, pixel), std::max(inside(leafDistance(x, y, 0.95f, 1), pixel),
                                                     inside(leafDistance(x, y, 0.7f, -1), pixel)));
    t.light = 0.42f + 0.12f * (0.5f - std::abs(x));
    return t;
}

uint8_t byteOf(float v) { return static_cast<uint8_t>(std::lround(255 * std::clamp(v, 0.0f, 1.0f))); }

}  // namespace

Rgba8 makeFlowerImage(int width, int height) {
    Rgba8 out{width, height, {}};
    out.pixels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
    const float pixel = 2.0f / static_cast<float>(width);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const float x = (static_cast<float>(column) + 0.5f) * pixel - 1,
                        y = (static_cast<float>(row) + 0.5f) * pixel - 1;
            const Texel t =
                row < width ? headAt(x, y, pixel)
                            : stemAt(x, static_cast<float>(row - width) / static_cast<float>(height - width), pixel);
            for (const float v : {t.petal, t.centre, t.light}) out.pixels.push_back(byteOf(f32::srgbEncode(v)));
            out.pixels.push_back(byteOf(t.alpha));
        }
    dilateColor(out);
    return out;
}

FlowerImage flowerImage(const Project& p, const Flowers& f) {
    FlowerImage image;
    if (!f.texture.empty()) image.pixels = loadColorImage(p.dir / f.texture);
    image.made = image.pixels.pixels.empty();
    if (image.made) image.pixels = makeFlowerImage(64, 160);
    image.headShare = std::min(static_cast<float>(image.pixels.width) / static_cast<float>(image.pixels.height), 1.0f);
    return image;
}

FlowerGrid flowerGrid(const Flowers& f) {
    const double perM2 = std::max(static_cast<double>(f.flowersPerM2), 1e-12);
    FlowerGrid g;
    g.side = std::clamp(std::sqrt(16 / perM2), 0.25, 64.0);
    g.expected = static_cast<float>(perM2 * g.side * g.side);
    g.most = static_cast<uint32_t>(std::ceil(g.expected));
    return g;
}

std::string grassAmong(const Project& p, const std::string& flowers) {
    std::string among;
    for (const auto& [name, field] : fieldsOf(p)) {
        const auto grows = [](const Species& s) { return s.bladesPerM2 > 0; };
        if (!field.grows.onTerrain) continue;
        if (std::none_of(field.grows.species.begin(), field.grows.species.end(), grows)) continue;
        if (among.empty() || name == flowers) among = name;
    }
    return among;
}

std::vector<std::pair<std::string, const Flowers*>> flowersOf(const Project& p) {
    std::vector<std::pair<std::string, const Flowers*>> out;
    for (const auto& [name, e] : p.entities)
        if (const Flowers* f = p.registry.get<Flowers>(e); f && f->flowersPerM2 > 0 && f->headSize > 0)
            out.emplace_back(name, f);
    return out;
}

}  // namespace sward
