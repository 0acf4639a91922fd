#include "tools/brush_cost.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
    if (!ground || brushes.tool == kViewTool || !chosenMap(doc, brushes)) return {};
    const glm::dvec3 at = *ground - findGround(doc.project()).origin;
    std::optional<double> sum;
    for (const std::string& path : paintedMaps(doc, brushes)) {
        const Result<ConstFieldRef> map = findField(doc.project(), doc.tables().components, path);
        const std::optional<double> perM2 = map ? bladesPerM2Of(*map) : std::nullopt;
        if (!perM2) continue;
        const Result<MapScale> scale = mapScale(doc.project(), *map);
        if (!scale) continue;
        sum = sum.value_or(0) + bladesInDisc(static_cast<const MapField*>(map->value)->map, *perM2, *scale, at.x, at.z,
                                             static_cast<double>(currentBrush(brushes).radius));
    }
    return sum;
}

// How often a map lies on the terrain.
double repeatsOf(const Document& doc, const MapScale& scale) {
    const Terrain* terrain = findGround(doc.project()).terrain;
    return terrain && scale.repeats ? terrain->size.x * terrain->size.y / (scale.width * scale.depth) : 1;
}

void countStroke(const Document& doc, const std::map<std::string, Map>& before, BrushCost& c) {
    c.stroke.reset();
    for (const auto& [path, map] : before) {
        const Result<ConstFieldRef> field = findField(doc.project(), doc.tables().components, path);
        const auto perM2 = field ? bladesPerM2Of(*field) : std::nullopt;
        const Map* now = perM2 ? &static_cast<const MapField*>(field->value)->map : nullptr;
        if (!now || now->empty()) continue;
        const Result<MapScale> scale = mapScale(doc.project(), *field);
        if (!scale) continue;
        const BladeChange one = bladesChanged(map, *now, *perM2, *scale);
        const double times = repeatsOf(doc, *scale);
        if (!c.stroke) c.stroke = BladeChange{};
        c.stroke->added += times * one.added;
        c.stroke->removed += times * one.removed;
    }
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

BladeChange bladesChanged(const Map& before, const Map& now, double bladesPerM2, const MapScale& scale) {
    const MapInfo& info = now.info();
    const double texels = static_cast<double>(info.width) * info.height,
                 perTexel = bladesPerM2 * scale.width * scale.depth / texels;
    BladeChange sum;
    if (!before.empty() && !(before.info() == info)) return sum;
    for (int ty = 0; ty < now.tilesY(); ++ty)
        for (int tx = 0; tx < now.tilesX(); ++tx) {
            if (!before.empty() && before.tile(tx, ty) == now.tile(tx, ty)) continue;
            for (int y = ty * kTileSize; y < std::min((ty + 1) * kTileSize, info.height); ++y)
                for (int x = tx * kTileSize; x < std::min((tx + 1) * kTileSize, info.width); ++x) {
                    const double was = before.empty() ? 1 : static_cast<double>(before.at(x, y)),
                                 change = static_cast<double>(now.at(x, y)) - was;
                    (change > 0 ? sum.added : sum.removed) += std::abs(change);
                }
        }
    return {sum.added * perTexel, sum.removed * perTexel};
}

void followBrushCost(BrushCost& c, const Document& doc, BrushBook& brushes, const std::optional<glm::dvec3>& ground,
                     const FrameStats* measured) {
    if (!doc.isOpen()) {
        c = {};
        return;
    }
    if (measured) keepGrassMs(*measured, c);
    c.under = underBrush(doc, brushes, ground);
    if (std::exchange(c.revision, doc.revision()) == doc.revision()) return;
    const std::map<std::string, Map>* before = doc.strokeBefore();
    if (before)
        countStroke(doc, *before, c);
    else
        c.stroke.reset();  // undone, or something else was edited
}

std::optional<double> strokeMs(const BrushCost& c, uint64_t bladesInView) {
    const double inView = static_cast<double>(bladesInView);
    if (!c.stroke || c.grassMs <= 0 || inView <= 0) return {};
    return c.grassMs * std::max(c.stroke->sum() / inView, -1.0);
}

}  // namespace sward
