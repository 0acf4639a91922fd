#include "tools/brush_cost.h"

#include <algorithm>
#include <cmath>

#include "frame/renderer.h"
#include "model/document.h"
#include "scene/map_fields.h"
#include "tools/brush_target.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr double kMostTexels = 10000;  // under the brush, that are read
constexpr double kPi = 3.14159265358979323846;

// The species' blades per square metre; nothing if the map is no density.
std::optional<double> bladesPerM2Of(const ConstFieldRef& map) {
    const FieldRow* row = map.row->map->bladesPerM2;
    if (!row) return {};
    return static_cast<double>(*static_cast<const float*>(fieldBeside(map, *row).value));
}

std::optional<double> underBrush(const Document& doc, BrushBook& brushes, const std::optional<glm::dvec3>& ground) {
    const std::optional<ConstFieldRef> map = chosenMap(doc, brushes);
    if (!ground || brushes.tool == kViewTool || !map) return {};
    const std::optional<double> perM2 = bladesPerM2Of(*map);
    const Result<MapScale> scale = mapScale(doc.project(), *map);
    if (!perM2 || !scale) return {};
    const glm::dvec3 at = *ground - findGround(doc.project()).origin;
    return bladesInDisc(static_cast<const MapField*>(map->value)->map, *perM2, *scale, at.x, at.z,
                        static_cast<double>(currentBrush(brushes).radius));
}

// Densities of all species: erasing may paint each.
std::vector<ConstFieldRef> densities(const Document& doc) {
    std::vector<ConstFieldRef> maps = allMaps(doc.project(), doc.tables().components, true);
    std::erase_if(maps, [](const ConstFieldRef& m) { return !m.row->map->bladesPerM2; });
    return maps;
}

void beginCount(const Document& doc, BrushCost& c) {
    c.before.clear();
    for (const ConstFieldRef& m : densities(doc)) c.before[m.path] = static_cast<const MapField*>(m.value)->map;
    c.stroke.reset();
}

void countStroke(const Document& doc, BrushCost& c) {
    if (c.revision == doc.revision()) return;
    c.revision = doc.revision();
    double added = 0;
    for (const ConstFieldRef& m : densities(doc)) {
        const Map& now = static_cast<const MapField*>(m.value)->map;
        const auto before = c.before.find(m.path);
        const auto perM2 = bladesPerM2Of(m);
        const auto scale = mapScale(doc.project(), m);
        if (before == c.before.end() || !perM2 || !scale || now.empty()) continue;
        added += bladesAdded(before->second, now, *perM2, *scale);
    }
    c.stroke = added;
}

void keepGrassMs(const FrameStats& measured, BrushCost& c) {
    double ms = 0;
    for (const PassStats& p : measured.passes)
        if (p.name.starts_with("grass/")) ms += p.ms;
    if (ms > 0) c.grassMs = ms;
}

}  // namespace

double bladesInDisc(const Map& density, double bladesPerM2, const MapScale& scale, double x, double z, double radius) {
    if (density.empty()) return bladesPerM2 * kPi * radius * radius;
    const MapInfo& info = density.info();
    const double w = scale.width / info.width, d = scale.depth / info.height;  // of a texel, metres
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(4 * radius * radius / (w * d) / kMostTexels))));
    const auto first = [&](double v, double texel) { return static_cast<int>(std::floor((v - radius) / texel)); };
    const auto last = [&](double v, double texel) { return static_cast<int>(std::ceil((v + radius) / texel)); };
    const auto wrapped = [&](int i, int n) { return scale.repeats ? ((i % n) + n) % n : i; };
    double sum = 0;
    for (int ty = first(z, d); ty <= last(z, d); ty += step)
        for (int tx = first(x, w); tx <= last(x, w); tx += step) {
            const int mx = wrapped(tx, info.width), my = wrapped(ty, info.height);
            if (mx < 0 || my < 0 || mx >= info.width || my >= info.height) continue;
            if (std::hypot((tx + 0.5) * w - x, (ty + 0.5) * d - z) <= radius)
                sum += static_cast<double>(density.at(mx, my));
        }
    return sum * bladesPerM2 * w * d * step * step;
}

double bladesAdded(const Map& before, const Map& now, double bladesPerM2, const MapScale& scale) {
    const MapInfo& info = now.info();
    const double texels = static_cast<double>(info.width) * info.height,
                 perTexel = bladesPerM2 * scale.width * scale.depth / texels;
    if (!before.empty() && !(before.info() == info)) return 0;
    double sum = 0;
    for (int ty = 0; ty < now.tilesY(); ++ty)
        for (int tx = 0; tx < now.tilesX(); ++tx) {
            if (!before.empty() && before.tile(tx, ty) == now.tile(tx, ty)) continue;
            for (int y = ty * kTileSize; y < std::min((ty + 1) * kTileSize, info.height); ++y)
                for (int x = tx * kTileSize; x < std::min((tx + 1) * kTileSize, info.width); ++x)
                    sum +=
                        static_cast<double>(now.at(x, y)) - (before.empty() ? 1 : static_cast<double>(before.at(x, y)));
        }
    return sum * perTexel;
}

void followBrushCost(BrushCost& c, const Document& doc, BrushBook& brushes, const std::optional<glm::dvec3>& ground,
                     const FrameStats* measured) {
    if (!doc.isOpen()) {
        c = {};
        return;
    }
    if (measured) keepGrassMs(*measured, c);
    c.under = underBrush(doc, brushes, ground);
    if (doc.stroking()) {
        if (!c.stroking) beginCount(doc, c);
        countStroke(doc, c);
    } else if (c.stroking) {
        countStroke(doc, c);
        c.before.clear();  // tiles that only it held are given back
    } else if (c.stroke && c.revision != doc.revision()) {
        c.stroke.reset();  // undone, or something else was edited
    }
    c.stroking = doc.stroking();
}

std::optional<double> strokeMs(const BrushCost& c, uint64_t bladesInView) {
    const double inView = static_cast<double>(bladesInView);
    if (!c.stroke || c.grassMs <= 0 || inView <= 0) return {};
    return c.grassMs * std::max(*c.stroke / inView, -1.0);
}

}  // namespace sward
