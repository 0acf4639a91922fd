// Lays blades: turns the map's direction towards the stroke's heading (comb) or a fixed angle (direction). The brush's
// strength is the lean that is painted, whatever leaned there before; its falloff mixes both at the edge.
// Without a heading the comb paints nothing.
#include <algorithm>

#include "brushes/paint.h"

namespace sward {
namespace {

// The texel's value for one part of a direction of length at most 1; whole steps where the map is of integers.
float encoded(const MapInfo& info, double part) {
    const double value = 0.5 + 0.5 * part;
    if (info.type == PixelType::F32) return static_cast<float>(value);
    return static_cast<float>(std::round(value * (info.type == PixelType::U8 ? 255 : 65535)));
}

std::shared_ptr<const Tile> lay(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush,
                                double x, double z) {
    const double length = std::hypot(x, z);
    if (!usableBrush(stamp, brush) || !(length > 1e-9) || !std::isfinite(length)) return map.tile(tx, ty);
    const double lean = std::clamp<double>(brush.strength, 0, 1) / length;
    const float target[2] = {encoded(map.info(), x * lean), encoded(map.info(), z * lean)};
    BrushSettings whole = brush;
    whole.strength = 1;
    return paintTile<2>(map, tx, ty, stamp, whole,
                        [&](const auto& row) { turnTowards(row, [&](int, int c) { return target[c]; }); });
}

}  // namespace

std::shared_ptr<const Tile> applyComb(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    return lay(map, tx, ty, stamp, brush, stamp.headingX, stamp.headingZ);
}

std::shared_ptr<const Tile> applyDirection(const Map& map, int tx, int ty, const Stamp& stamp,
                                           const BrushSettings& brush) {
    const double angle = static_cast<double>(brush.angleDeg) * 3.14159265358979323846 / 180;
    return lay(map, tx, ty, stamp, brush, stamp.flipX ? -std::sin(angle) : std::sin(angle),
               stamp.flipZ ? std::cos(angle) : -std::cos(angle));
}

}  // namespace sward
