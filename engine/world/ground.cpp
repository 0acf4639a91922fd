#include "world/ground.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/jobs.h"
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

bool sameGround(const Terrain& a, const Terrain& b) {
    return a.size == b.size && a.height.map.sameTiles(b.height.map) && a.heightRange == b.heightRange &&
           a.gridSpacing == b.gridSpacing && a.heightTiling == b.heightTiling && a.mapSize == b.mapSize;
}

double terrainHeight(const Terrain& t, double x, double z) {
    if (!t.height.present()) return 0;
    const auto [offset, scale] = heightScale(t);
    return offset + scale * mirroredSample(t.height.map, tilingOf(t, t.heightTiling), x, z);
}

glm::dvec3 terrainNormal(const Terrain& t, double x, double z) {
    if (!t.height.present()) return {0, 1, 0};
    const MapInfo& info = t.height.map.info();
    const glm::dvec2 covered = tilingOf(t, t.heightTiling).metres;
    const double dx = std::max(static_cast<double>(t.gridSpacing), covered.x / info.width),
                 dz = std::max(static_cast<double>(t.gridSpacing), covered.y / info.height);
    const double rx = terrainHeight(t, x + dx, z) - terrainHeight(t, x - dx, z),
                 rz = terrainHeight(t, x, z + dz) - terrainHeight(t, x, z - dz);
    return glm::normalize(glm::dvec3(-rx / (2 * dx), 1, -rz / (2 * dz)));
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

// Lowest and highest texel, in steps of its type; sixteen bytes of texels side by side.
template <class T>
struct Bounds {
    static constexpr int kLanes = 16 / sizeof(T);
    typedef T Lanes __attribute__((vector_size(16)));
    T low = std::numeric_limits<T>::max(), high = std::numeric_limits<T>::lowest();
    Lanes lows = Lanes{} + low, highs = Lanes{} + high;

    void add(const T* in, int count) {
        int i = 0;
        for (; i + kLanes <= count; i += kLanes) {
            Lanes v;
            std::memcpy(&v, in + i, sizeof v);
            lows = v < lows ? v : lows;
            highs = v > highs ? v : highs;
        }
        for (; i < count; ++i) low = std::min(low, in[i]), high = std::max(high, in[i]);
    }
    std::pair<T, T> all() {
        for (int i = 0; i < kLanes; ++i) low = std::min<T>(low, lows[i]), high = std::max<T>(high, highs[i]);
        return {low, high};
    }
};
template <class T>
std::pair<T, T> boundsOf(const Map& m, std::pair<int, int> xs, std::pair<int, int> ys) {
    Bounds<T> bounds;
    for (int ty = ys.first / kTileSize; ty <= ys.second / kTileSize; ++ty)
        for (int tx = xs.first / kTileSize; tx <= xs.second / kTileSize; ++tx) {
            const TileTexels texels = m.tile(tx, ty)->texels();
            const T* in = reinterpret_cast<const T*>(texels.data());
            const int left = tx * kTileSize, top = ty * kTileSize;
            const int x0 = std::max(xs.first - left, 0), x1 = std::min(xs.second + 1 - left, kTileSize),
                      y1 = std::min(ys.second + 1 - top, kTileSize);
            for (int y = std::max(ys.first - top, 0); y < y1; ++y) bounds.add(in + y * kTileSize + x0, x1 - x0);
        }
    return bounds.all();
}

// The same as Map::at gives it.
std::pair<float, float> boundsOf(const Map& m, std::pair<int, int> xs, std::pair<int, int> ys) {
    switch (m.info().type) {
        case PixelType::U8: {
            const auto [lo, hi] = boundsOf<uint8_t>(m, xs, ys);
            return {static_cast<float>(lo) / 255.0f, static_cast<float>(hi) / 255.0f};
        }
        case PixelType::U16: {
            const auto [lo, hi] = boundsOf<uint16_t>(m, xs, ys);
            return {static_cast<float>(lo) / 65535.0f, static_cast<float>(hi) / 65535.0f};
        }
        case PixelType::F32:
            break;
    }
    return boundsOf<float>(m, xs, ys);
}

bool differs(const Map& a, const Map& b, std::pair<int, int> xs, std::pair<int, int> ys) {
    for (int ty = ys.first / kTileSize; ty <= ys.second / kTileSize; ++ty)
        for (int tx = xs.first / kTileSize; tx <= xs.second / kTileSize; ++tx)
            if (a.tile(tx, ty) != b.tile(tx, ty)) return true;
    return false;
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
    const bool sameShape = !b.parts.empty() && b.of.info() == m.info() && b.scale == heightScale(t);
    if (sameShape && b.of.sameTiles(m)) return;
    b.scale = heightScale(t);
    const auto [offset, scale] = b.scale;
    const Map before = std::exchange(b.of, m);
    b.parts.resize(static_cast<size_t>(kBoundsGrid) * kBoundsGrid);
    parallelFor(b.parts.size(), [&, offset = offset, scale = scale](size_t i) {
        const auto xs = reach(static_cast<int>(i) % kBoundsGrid, m.info().width),
                   ys = reach(static_cast<int>(i) / kBoundsGrid, m.info().height);
        if (sameShape && !differs(before, m, xs, ys)) return;
        const auto [lo, hi] = boundsOf(m, xs, ys);
        b.parts[i] = {static_cast<float>(offset + scale * lo), static_cast<float>(offset + scale * hi)};
    });
    b.low = std::numeric_limits<float>::max();
    b.high = -b.low;
    for (const auto& [lo, hi] : b.parts) b.low = std::min(b.low, lo), b.high = std::max(b.high, hi);
}

}  // namespace sward
