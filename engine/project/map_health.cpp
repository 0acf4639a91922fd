#include "project/map_health.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/jobs.h"
#include "scene/map_fields.h"
#include "scene/tiling.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr size_t kFewestLevels = 16, kMostLevels = 256;
constexpr double kLeastStep = 8;         // of the map's own, between levels
constexpr double kClippedShare = 0.001;  // below it ground that merely touches both ends of its range is as meant
constexpr double kUsedShare = 0.25;      // of a range; below it a narrower one would give finer steps

// Counts texels of a tile, and remembers where those of the fullest tile lie.
struct Place {
    TexelFault* fault;
    size_t here = 0, most = 0;
    glm::dvec2 sum{0};

    void add(int x, int y) { ++here, sum += glm::dvec2(x + 0.5, y + 0.5); }
    void endTile(const MapInfo& info) {
        fault->count += here;
        if (here > most) {
            most = here;
            fault->worst = sum / static_cast<double>(here) / glm::dvec2(info.width, info.height);
        }
        here = 0, sum = {};
    }
};

template <class Visit>  // visit(x, y) for the texels of each tile, then endTile()
void eachTexel(const MapInfo& info, const Visit& visit, const auto& endTile) {
    for (int ty = 0; ty < info.height; ty += kTileSize)
        for (int tx = 0; tx < info.width; tx += kTileSize) {
            for (int y = ty; y < std::min(ty + kTileSize, info.height); ++y)
                for (int x = tx; x < std::min(tx + kTileSize, info.width); ++x) visit(x, y);
            endTile();
        }
}

// The distinct values of a channel, sorted; empty if there are more than kMostLevels.
std::vector<double> levelsOf(const Map& map) {
    std::set<float> seen;
    float last = NAN;
    const MapInfo& info = map.info();
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x) {
            const float value = map.at(x, y);
            if (value == last || !std::isfinite(value)) continue;
            seen.insert(last = value);
            if (seen.size() > kMostLevels) return {};
        }
    return {seen.begin(), seen.end()};
}

// The even step between the levels; 0 if there is none, or the map itself has hardly finer ones.
double stepOf(const std::vector<double>& levels, PixelType type) {
    if (levels.size() < kFewestLevels || type == PixelType::U8) return 0;
    double least = levels.back() - levels.front();
    for (size_t i = 1; i < levels.size(); ++i) least = std::min(least, levels[i] - levels[i - 1]);
    const double span = levels.back() - levels.front(), own = type == PixelType::U16 ? 1 / 65535.0 : span * 1e-6;
    if (least < kLeastStep * own) return 0;
    const double count = std::round(span / least), step = span / count, slack = std::max(0.02 * step, 1.01 * own);
    if (count >= kMostLevels) return 0;
    for (const double level : levels) {
        const double steps = (level - levels.front()) / step;
        if (std::abs(steps - std::round(steps)) * step > slack) return 0;
    }
    return step;
}

// Whether the texel is the first of a stair along the axis: level with the one after it, and beyond a step from two
// that are level. A slope that climbs with each texel has no stairs, however even it is.
bool beginsStair(const Map& map, int x, int y, int dx, int dy) {
    if (x < 2 * dx || y < 2 * dy || x + dx >= map.info().width || y + dy >= map.info().height) return false;
    const float here = map.at(x, y), before = map.at(x - dx, y - dy);
    return here != before && here == map.at(x + dx, y + dy) && before == map.at(x - 2 * dx, y - 2 * dy);
}

void countBands(const Map& map, TexelHealth& h) {
    const std::vector<double> levels = levelsOf(map);
    if (stepOf(levels, map.info().type) <= 0) return;
    Place stairs{&h.banded};
    eachTexel(
        map.info(),
        [&](int x, int y) {
            if (beginsStair(map, x, y, 1, 0) || beginsStair(map, x, y, 0, 1)) stairs.add(x, y);
        },
        [&] { stairs.endTile(map.info()); });
    if (h.banded.count > 0) h.levels = static_cast<int>(levels.size());
}

void countRange(const Map& map, TexelHealth& h) {
    const MapInfo& info = map.info();
    const bool integers = info.type != PixelType::F32 && info.channels == 1;
    h.low = INFINITY, h.high = -INFINITY;
    Place broken{&h.notFinite}, low{&h.atLow}, high{&h.atHigh};
    const auto visit = [&](int x, int y) {
        bool finite = true;
        for (int c = 0; c < info.channels; ++c) finite = finite && std::isfinite(map.at(x, y, c));
        if (!finite) return broken.add(x, y);
        const float value = map.at(x, y);
        h.low = std::min(h.low, value), h.high = std::max(h.high, value);
        if (integers && value <= 0) low.add(x, y);
        if (integers && value >= 1) high.add(x, y);
    };
    eachTexel(info, visit, [&] { broken.endTile(info), low.endTile(info), high.endTile(info); });
}

// --- what is told of a map

struct Told {
    const Project& p;
    const ConstFieldRef& field;
    const Map& map;
    const TexelHealth& health;
    glm::dvec2 metres;  // that the map covers once
    std::vector<MapFinding>& out;

    double percent(size_t count) const {
        return 100.0 * static_cast<double>(count) / static_cast<double>(health.texels);
    }
    void add(MapFault fault, bool meant, const TexelFault& at, std::string message) const {
        out.push_back({field.path, fault, meant, std::move(message), at.worst * metres});
    }
};

void tellClipped(const Told& t, bool heights, const glm::dvec2& range) {
    for (const bool high : {false, true}) {
        const TexelFault& at = high ? t.health.atHigh : t.health.atLow;
        if (at.count == 0 || at.count == t.health.texels) continue;
        const double percent = t.percent(at.count);
        if (heights)
            t.add(MapFault::Clipped, percent < 100 * kClippedShare, at,
                  fmt::format("{:.2g} % of the ground is at the end of heightRange, {:.6g} m: it is cut off there",
                              percent, high ? range.y : range.x));
        else
            t.add(MapFault::Clipped, true, at, fmt::format("{:.3g} % of it is {}", percent, high ? 1 : 0));
    }
}

void tellUnused(const Told& t, const glm::dvec2& range) {
    const double used = static_cast<double>(t.health.high - t.health.low), span = std::abs(range.y - range.x);
    if (!(used > 0) || used >= kUsedShare) return;
    t.add(MapFault::UnusedRange, true, {},
          fmt::format(
              "heights use {:.2g} % of heightRange: its steps are {:.2g} mm, and {:.2g} mm with a range of {:.4g} "
              "m",
              100 * used, 1000 * span / 65535, 1000 * span * used / 65535, span * used));
}

void tellOf(const Told& t) {
    const MapRow& row = *t.field.row->map;
    const bool heights = row.kind == MapKind::Heights;
    if (t.health.notFinite.count > 0)
        t.add(MapFault::NotFinite, false, t.health.notFinite,
              fmt::format("{} texels are no finite numbers", t.health.notFinite.count));
    const bool ranged = row.heightRange && t.map.info().type != PixelType::F32;
    const glm::dvec2 range =
        ranged ? *static_cast<const glm::dvec2*>(fieldBeside(t.field, *row.heightRange).value) : glm::dvec2(0, 1);
    if (row.kind == MapKind::Amounts || heights) tellClipped(t, heights, range);
    if (t.health.levels > 0)
        t.add(
            MapFault::Banded, !heights, t.health.banded,
            fmt::format("{} values an even step apart: an image of 8 bits in finer texels; {}", t.health.levels,
                        heights ? "slopes are stairs; smooth it, or import the image in 16 bits" : "edges have steps"));
    if (ranged) tellUnused(t, range);
}

// Of the first terrain, for maps of other entities than its own.
glm::dvec2 metresOf(const Project& p, const ConstFieldRef& map) {
    const Terrain* own = p.registry.get<Terrain>(findEntity(p, map.entity));
    const Terrain* terrain = own ? own : findGround(p).terrain;
    return terrain ? tilingOf(*terrain, mapTiling(map)).metres : glm::dvec2(1);
}

}  // namespace

TexelHealth healthOf(const Map& map) {
    TexelHealth h;
    h.texels = size_t(map.info().width) * size_t(map.info().height);
    countRange(map, h);
    if (map.info().channels == 1 && map.info().type != PixelType::U8) countBands(map, h);
    return h;
}

std::vector<MapFinding> mapFindings(const Project& p, std::span<const ComponentRow> rows, JobControl* control) {
    std::vector<MapFinding> out;
    const std::vector<ConstFieldRef> maps = allMaps(p, rows);
    for (size_t i = 0; i < maps.size() && !(control && control->cancelled()); ++i) {
        const ConstFieldRef& field = maps[i];
        if (control) control->setProgress(static_cast<double>(i) / static_cast<double>(maps.size()));
        const Map& map = static_cast<const MapField*>(field.value)->map;
        if (map.empty()) continue;
        const TexelHealth health = healthOf(map);
        tellOf({p, field, map, health, field.row->map->onMesh ? glm::dvec2(1) : metresOf(p, field), out});
    }
    return out;
}

}  // namespace sward
