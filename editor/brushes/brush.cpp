// The table of brushes, and how a stroke becomes stamps and a stamp tiles.
#include "brushes/brush.h"

#include "brushes/paint.h"
#include "core/jobs.h"

namespace sward {
namespace {
constexpr unsigned kLaid = bitOf(MapKind::Amounts) | bitOf(MapKind::Colours), kDirections = bitOf(MapKind::Directions),
                   kForces = bitOf(MapKind::Forces), kAll = kLaid | kDirections | kForces;
constexpr BrushRow kBrushes[] = {
    {"add", "Add", "Raises the map: more blades, higher ground. Lays colour over what is there", applyAdd, kLaid},
    {"subtract", "Subtract", "Lowers the map: fewer blades, lower ground, less lean, less pressed, less colour",
     applySubtract, kAll},
    {"set", "Set", "Paints towards a value, or towards a colour of an opacity", applySet, kLaid},
    {"smooth", "Smooth", "Evens out what is painted", applySmooth, kAll},
    {"noise", "Noise", "Roughens towards random values, the same for the same seed", applyNoise, kLaid},
    {"comb", "Comb", "Lays the grass the way the stroke goes", applyComb, kDirections, true},
    {"direction", "Direction", "Lays the grass towards an angle", applyDirection, kDirections},
    {"press", "Press",
     "Presses the grass down and pushes it the way the stroke goes, as a roller does; a click pushes it apart",
     applyPress, kForces, true},
};
}  // namespace

std::span<const BrushRow> brushRows() { return kBrushes; }

const char* kindName(MapKind kind) {
    constexpr const char* names[] = {"amounts", "directions", "forces", "colours"};
    return names[static_cast<size_t>(kind)];
}

bool paints(const BrushRow& row, MapKind kind) { return (row.kinds & bitOf(kind)) != 0; }

std::string brushesFor(MapKind kind) {
    std::vector<std::string> names;
    for (const BrushRow& row : kBrushes)
        if (paints(row, kind)) names.push_back(row.name);
    std::string out;
    for (size_t i = 0; i < names.size(); ++i) out += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
    return out;
}

const BrushRow* findBrush(const std::string& name) {
    for (const BrushRow& row : kBrushes)
        if (name == row.name) return &row;
    return nullptr;
}

TileRange stampTiles(const MapInfo& info, const Stamp& s) {
    // A stamp smaller than a texel reaches one texel around its centre.
    const double rx = std::max(s.radiusX, 1.0) + s.spread, ry = std::max(s.radiusY, 1.0) + s.spread;
    if (!(s.radiusX > 0 && s.radiusY > 0) || info.width <= 0 || info.height <= 0) return {};
    if (!(s.x + rx > 0 && s.y + ry > 0 && s.x - rx < info.width && s.y - ry < info.height)) return {};
    const auto tileOf = [](double texel, int size) {
        return static_cast<int>(std::clamp(texel, 0.0, size - 1.0)) / kTileSize;
    };
    return {tileOf(s.x - rx, info.width), tileOf(s.y - ry, info.height), tileOf(s.x + rx, info.width) + 1,
            tileOf(s.y + ry, info.height) + 1};
}

std::vector<std::pair<double, double>> stampsAlong(std::span<const std::pair<double, double>> points, double step,
                                                   double& carry) {
    std::vector<std::pair<double, double>> stamps;
    if (points.empty()) return stamps;
    if (carry <= 0) {
        stamps.push_back(points[0]);
        carry = step;
    }
    if (!(step > 0) || !std::isfinite(step)) return stamps;
    for (size_t i = 1; i < points.size(); ++i) {
        const auto [x0, z0] = points[i - 1];
        const double dx = points[i].first - x0, dz = points[i].second - z0;
        const double length = std::hypot(dx, dz);
        if (!(length > 0) || !std::isfinite(length)) continue;
        double at = carry;
        for (; at <= length; at += step) stamps.emplace_back(x0 + dx * (at / length), z0 + dz * (at / length));
        carry = at - length;
    }
    return stamps;
}

void applyStamp(Map& map, const BrushRow& row, const Stamp& stamp, const BrushSettings& brush) {
    const TileRange range = stampTiles(map.info(), stamp);
    const Map before = map;
    std::vector<std::shared_ptr<const Tile>> painted(range.count());
    const int columns = range.x1 - range.x0;
    const auto place = [&](size_t i) { return std::pair{range.x0 + int(i) % columns, range.y0 + int(i) / columns}; };
    parallelFor(painted.size(), [&](size_t i) {
        const auto [tx, ty] = place(i);
        painted[i] = row.apply(before, tx, ty, stamp, brush);
    });
    for (size_t i = 0; i < painted.size(); ++i) {
        const auto [tx, ty] = place(i);
        map.setTile(tx, ty, std::move(painted[i]));
    }
}

}  // namespace sward
