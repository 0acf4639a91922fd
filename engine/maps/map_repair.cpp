#include "maps/map_repair.h"

#include <cmath>
#include <cstring>

#include "core/jobs.h"

namespace sward {
namespace {

constexpr int kFar = 1 << 20;  // farther than any map is wide

// For each texel of a column the row of the nearest finite one, or -1 - kFar where the column has none.
void nearestInColumn(const Map& map, int c, int x, std::vector<int32_t>& rowOf) {
    const int w = map.info().width, h = map.info().height;
    int last = -kFar;
    for (int y = 0; y < h; ++y) {
        if (std::isfinite(map.at(x, y, c))) last = y;
        rowOf[size_t(y) * size_t(w) + size_t(x)] = last;
    }
    last = 2 * kFar;
    for (int y = h - 1; y >= 0; --y) {
        int32_t& row = rowOf[size_t(y) * size_t(w) + size_t(x)];
        if (row == y) last = y;
        if (last - y < y - row) row = last;
    }
}

int64_t squared(int64_t v) { return v * v; }

// For one row: the column of the nearest finite texel for each x, as the lower envelope of one parabola a column.
void nearestInRow(const int32_t* rowOf, int w, int y, std::vector<int>& columnOf) {
    const auto gap = [&](int i) { return int64_t(std::abs(rowOf[i] - y)); };
    const auto distance = [&](int x, int i) { return squared(x - i) + squared(gap(i)); };
    // The first x at which column u is nearer than column i < u.
    const auto crossing = [&](int i, int u) {
        const int64_t numerator = squared(u) - squared(i) + squared(gap(u)) - squared(gap(i)),
                      denominator = 2 * int64_t(u - i);
        return (numerator >= 0 ? numerator / denominator : -((-numerator + denominator - 1) / denominator)) + 1;
    };
    std::vector<int> site{0};
    std::vector<int64_t> from{0};
    for (int u = 1; u < w; ++u) {
        while (!site.empty() && distance(int(from.back()), site.back()) > distance(int(from.back()), u)) {
            site.pop_back();
            from.pop_back();
        }
        const int64_t start = site.empty() ? 0 : crossing(site.back(), u);
        if (start >= w) continue;
        site.push_back(u);
        from.push_back(start);
    }
    columnOf.resize(size_t(w));
    for (int x = w - 1; x >= 0; --x) {
        columnOf[size_t(x)] = site.back();
        if (from.back() == x && site.size() > 1) {
            site.pop_back();
            from.pop_back();
        }
    }
}

// Reads from `old`, writes to `map`. False if the channel has no finite texel.
bool repairChannel(Map& map, const Map& old, int c) {
    const int w = map.info().width, h = map.info().height;
    std::vector<int32_t> rowOf(size_t(w) * size_t(h));
    for (int x = 0; x < w; ++x) nearestInColumn(old, c, x, rowOf);
    bool any = false;
    std::vector<int> columnOf;
    for (int y = 0; y < h; ++y) {
        const int32_t* row = rowOf.data() + size_t(y) * size_t(w);
        nearestInRow(row, w, y, columnOf);
        for (int x = 0; x < w; ++x) {
            const int sx = columnOf[size_t(x)], sy = row[sx];
            const bool found = sy >= 0 && sy < h;
            any |= found;
            if (!std::isfinite(old.at(x, y, c))) map.set(x, y, c, found ? old.at(sx, sy, c) : 0.0f);
        }
    }
    return any;
}

bool tileFinite(const Tile& tile) {
    // An exponent of all ones is NaN or infinity: a test on bits needs no branch and vectorises.
    const TileTexels texels = tile.texels();
    const size_t n = texels.size() / sizeof(uint32_t);
    uint32_t bad = 0;
    for (size_t i = 0; i < n; ++i) {
        uint32_t bits;
        std::memcpy(&bits, texels.data() + i * sizeof bits, sizeof bits);
        bad |= static_cast<uint32_t>((bits & 0x7f800000u) == 0x7f800000u);
    }
    return bad == 0;
}

bool texelFinite(const Map& map, int x, int y) {
    for (int c = 0; c < map.info().channels; ++c)
        if (!std::isfinite(map.at(x, y, c))) return false;
    return true;
}

bool allFinite(const Map& map) {
    std::atomic<bool> finite{true};
    parallelFor(size_t(map.tilesY()), [&](size_t ty) {
        for (int tx = 0; tx < map.tilesX() && finite; ++tx)
            if (!tileFinite(*map.tile(tx, int(ty)))) finite = false;
    });
    return finite;
}

float converted(float value, bool toFloat, const std::pair<double, double>& range) {
    const double span = range.second - range.first;
    if (toFloat) return static_cast<float>(range.first + double(value) * span);
    return span == 0 ? 0.0f : static_cast<float>((double(value) - range.first) / span);
}

}  // namespace

TexelRepair repairTexels(Map& map) {
    TexelRepair repair;
    if (map.empty() || map.info().type != PixelType::F32 || allFinite(map)) return repair;
    std::vector<bool> bad(size_t(map.info().channels), false);
    for (int y = 0; y < map.info().height; ++y)
        for (int x = 0; x < map.info().width; ++x) {
            if (texelFinite(map, x, y)) continue;
            if (repair.count++ == 0) repair.firstX = x, repair.firstY = y;
            for (size_t c = 0; c < bad.size(); ++c) bad[c] = bad[c] || !std::isfinite(map.at(x, y, int(c)));
        }
    const Map old = map;
    for (size_t c = 0; c < bad.size(); ++c)
        if (bad[c]) repair.anyFinite &= repairChannel(map, old, int(c));
    return repair;
}

Map convertMap(const Map& map, PixelType type, const std::optional<std::pair<double, double>>& range) {
    const PixelType from = map.info().type;
    if (from == type) return map;
    MapInfo info = map.info();
    info.type = type;
    Map out(info);
    const bool ranged = range && (from == PixelType::F32 || type == PixelType::F32);
    const std::pair<double, double> scale = ranged ? *range : std::pair(0.0, 1.0);
    parallelFor(size_t(map.tilesY()), [&](size_t band) {
        const int y0 = int(band) * kTileSize, y1 = std::min(y0 + kTileSize, info.height);
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < info.width; ++x)
                for (int c = 0; c < info.channels; ++c) {
                    const float v = map.at(x, y, c);
                    out.set(x, y, c, ranged ? converted(v, type == PixelType::F32, scale) : v);
                }
    });
    return out;
}

}  // namespace sward
