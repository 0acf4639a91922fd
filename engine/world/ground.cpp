#include "world/ground.h"

#include "core/numerics.h"
#include "scene/tiling.h"

namespace sward {

Ground findGround(const Project& p) {
    for (const auto& [name, e] : p.entities)
        if (const Terrain* t = p.registry.get<Terrain>(e)) {
            const Transform* at = p.registry.get<Transform>(e);
            return {t, at ? at->position : glm::dvec3(0)};
        }
    return {};
}

std::pair<double, double> heightScale(const Terrain& t) {
    if (t.height.map.info().type == PixelType::F32) return {0.0, 1.0};
    return {t.heightRange.x, t.heightRange.y - t.heightRange.x};
}

double terrainHeight(const Terrain& t, double x, double z) {
    if (!t.height.present()) return 0;
    const auto [offset, scale] = heightScale(t);
    return offset + scale * mirroredSample(t.height.map, tilingOf(t, t.heightTiling), x, z);
}

namespace {

// Where [a, b], in repeats, lies in [0, 1] of a map that is mirrored from repeat to repeat: one interval, whose ends
// are those of [a, b] or of the map.
std::pair<double, double> folded(double a, double b) {
    const double lo = f64::mirrorUnit(a), hi = f64::mirrorUnit(b);
    const bool passesBegin = std::floor(b / 2) > std::floor(a / 2),
               passesEnd = std::floor((b + 1) / 2) > std::floor((a + 1) / 2);
    return {passesBegin ? 0 : std::min(lo, hi), passesEnd ? 1 : std::max(lo, hi)};
}

std::pair<int, int> partsOf(const std::pair<double, double>& shares) {
    const auto part = [](double share) {
        return std::clamp(static_cast<int>(std::floor(share * kBoundsGrid)), 0, kBoundsGrid - 1);
    };
    return {part(shares.first), part(shares.second)};
}

}  // namespace

std::pair<float, float> HeightBounds::over(const glm::dvec2& size, double x0, double z0, double x1, double z1) const {
    if (parts.size() <= 1) return {low, high};
    const bool repeats = repeat.x > 0;
    if (repeats && x1 - x0 >= repeat.x && z1 - z0 >= repeat.y) return {low, high};
    const auto [firstX, lastX] =
        partsOf(repeats ? folded(x0 / repeat.x, x1 / repeat.x) : std::pair{x0 / size.x, x1 / size.x});
    const auto [firstZ, lastZ] =
        partsOf(repeats ? folded(z0 / repeat.y, z1 / repeat.y) : std::pair{z0 / size.y, z1 / size.y});
    float lo = high, hi = low;
    for (int z = firstZ; z <= lastZ; ++z)
        for (int x = firstX; x <= lastX; ++x) {
            const auto& [a, b] = parts[static_cast<size_t>(z) * kBoundsGrid + static_cast<size_t>(x)];
            lo = std::min(lo, a);
            hi = std::max(hi, b);
        }
    return {lo, hi};
}

namespace {

// Texels whose bilinear reach touches part i of n parts over `side` texels.
std::pair<int, int> reach(int i, int side) {
    const double scale = static_cast<double>(side) / kBoundsGrid;
    return {std::max(static_cast<int>(std::floor(i * scale - 0.5)), 0),
            std::min(static_cast<int>(std::ceil((i + 1) * scale + 0.5)), side - 1)};
}

std::pair<float, float> boundsOf(const Map& m, std::pair<int, int> xs, std::pair<int, int> ys) {
    float lo = m.at(xs.first, ys.first), hi = lo;
    for (int y = ys.first; y <= ys.second; ++y)
        for (int x = xs.first; x <= xs.second; ++x) {
            const float h = m.at(x, y);
            lo = std::min(lo, h);
            hi = std::max(hi, h);
        }
    return {lo, hi};
}

}  // namespace

void updateHeightBounds(HeightBounds& b, const Terrain& t) {
    if (!t.height.present()) {
        b = {};
        return;
    }
    const Map& m = t.height.map;
    const Tiling tiling = tilingOf(t, t.heightTiling);
    b.repeat = tiling.repeats ? tiling.metres : glm::dvec2(0);
    if (!b.parts.empty() && b.of.sameTiles(m) && b.scale == heightScale(t)) return;
    b.scale = heightScale(t);
    const auto [offset, scale] = b.scale;
    b.of = m;
    b.parts.resize(static_cast<size_t>(kBoundsGrid) * kBoundsGrid);
    b.low = std::numeric_limits<float>::max();
    b.high = -b.low;
    for (int z = 0; z < kBoundsGrid; ++z)
        for (int x = 0; x < kBoundsGrid; ++x) {
            const auto [lo, hi] = boundsOf(m, reach(x, m.info().width), reach(z, m.info().height));
            auto& part = b.parts[static_cast<size_t>(z) * kBoundsGrid + static_cast<size_t>(x)];
            part = {static_cast<float>(offset + scale * lo), static_cast<float>(offset + scale * hi)};
            b.low = std::min(b.low, part.first);
            b.high = std::max(b.high, part.second);
        }
}

}  // namespace sward
