// The table of brushes, and how a stroke becomes stamps and a stamp tiles.
#include "brushes/brush.h"

#include "brushes/paint.h"
#include "core/jobs.h"

namespace sward {
namespace {
constexpr unsigned kLaid = bitOf(MapKind::Amounts) | bitOf(MapKind::Colours), kDirections = bitOf(MapKind::Directions),
                   kForces = bitOf(MapKind::Forces), kHeights = bitOf(MapKind::Heights),
                   kFlat = kLaid | kDirections | kForces;
constexpr BrushRow kBrushes[] = {
    {.name = "add",
     .label = "Add",
     .help = "More of the map: more blades. Lays colour over what is there",
     .apply = applyAdd,
     .kinds = kLaid,
     .onHeights = "raise"},
    {.name = "subtract",
     .label = "Subtract",
     .help = "Less of the map: fewer blades, less lean, less pressed, less colour",
     .apply = applySubtract,
     .kinds = kFlat,
     .onHeights = "lower"},
    {.name = "set",
     .label = "Set",
     .help = "Paints towards a value, or towards a colour of an opacity",
     .apply = applySet,
     .kinds = kLaid,
     .onHeights = "flatten"},
    {.name = "smooth",
     .label = "Smooth",
     .help = "Evens out what is painted, and the ground",
     .apply = applySmooth,
     .kinds = kFlat | kHeights},
    {.name = "noise",
     .label = "Noise",
     .help = "Roughens towards random values, or the ground into bumps; the same for the same seed",
     .apply = applyNoise,
     .kinds = kLaid | kHeights},
    {.name = "comb",
     .label = "Comb",
     .help = "Lays the grass the way the stroke goes",
     .apply = applyComb,
     .kinds = kDirections,
     .follows = true},
    {.name = "direction",
     .label = "Direction",
     .help = "Lays the grass towards an angle",
     .apply = applyDirection,
     .kinds = kDirections},
    {.name = "press",
     .label = "Press",
     .help = "Presses the grass down and pushes it the way the stroke goes, as a roller does; a click pushes it apart",
     .apply = applyPress,
     .kinds = kForces,
     .follows = true},
    {.name = "raise",
     .label = "Raise",
     .help = "Raises the ground by metres a stamp",
     .apply = applyRaise,
     .kinds = kHeights},
    {.name = "lower",
     .label = "Lower",
     .help = "Lowers the ground by metres a stamp",
     .apply = applyLower,
     .kinds = kHeights},
    {.name = "flatten",
     .label = "Flatten",
     .help = "Levels the ground to the height where the stroke begins, or to a height",
     .apply = applyFlatten,
     .kinds = kHeights,
     .levels = true},
    {.name = "ramp",
     .label = "Ramp",
     .help = "An even slope from where the drag begins to where it ends",
     .apply = applyRamp,
     .kinds = kHeights,
     .spans = true},
    {.name = "erode",
     .label = "Erode",
     .help = "Rain washes gullies into the ground, and slopes that are too steep slide",
     .apply = nullptr,
     .kinds = kHeights,
     .applyWhole = applyErode},
    {.name = "imprint",
     .label = "Imprint",
     .help = "Stamps an image into the ground: a click sets heights by its shape times a height",
     .apply = applyImprint,
     .kinds = kHeights,
     .once = true},
};
}  // namespace

std::span<const BrushRow> brushRows() { return kBrushes; }

const char* kindName(MapKind kind) {
    constexpr const char* names[] = {"amounts", "directions", "forces", "colours", "heights"};
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

const BrushRow* findBrush(const std::string& name, MapKind kind) {
    const BrushRow* row = findBrush(name);
    return row && row->onHeights && kind == MapKind::Heights ? findBrush(row->onHeights) : row;
}

TileRange stampTiles(const MapInfo& info, const Stamp& s) {
    // A stamp smaller than a texel reaches one texel around its centre.
    const double rx = std::max(s.radiusX, 1.0) * s.reach + s.spread, ry = std::max(s.radiusY, 1.0) * s.reach + s.spread;
    if (!(s.radiusX > 0 && s.radiusY > 0) || info.width <= 0 || info.height <= 0) return {};
    const double x0 = s.x + std::min(s.acrossX, 0.0) - rx, x1 = s.x + std::max(s.acrossX, 0.0) + rx,
                 y0 = s.y + std::min(s.acrossY, 0.0) - ry, y1 = s.y + std::max(s.acrossY, 0.0) + ry;
    if (!(x1 > 0 && y1 > 0 && x0 < info.width && y0 < info.height)) return {};
    const auto tileOf = [](double texel, int size) {
        return static_cast<int>(std::clamp(texel, 0.0, size - 1.0)) / kTileSize;
    };
    return {tileOf(x0, info.width), tileOf(y0, info.height), tileOf(x1, info.width) + 1, tileOf(y1, info.height) + 1};
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
    if (row.applyWhole) return row.applyWhole(map, stamp, brush);
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
