// Presses grass down: turns the map's forces towards a press and a push along the stroke's heading, both as strong as
// the brush is, whatever was there before; its falloff mixes both at the edge. Without a heading (a click) the push
// goes out from the stamp's middle, where it is none, and is whole from half the radius on.
#include <algorithm>

#include "brushes/paint.h"

namespace sward {
namespace {

constexpr double kInner = 0.5;  // radii out to which a click's push grows

// Of length at most 1, at a texel `x`, `y` radii from the stamp's middle.
std::pair<double, double> apart(double x, double y) {
    const double far = std::hypot(x, y), push = std::min(far / kInner, 1.0);
    return far > 1e-9 ? std::pair{x / far * push, y / far * push} : std::pair{0.0, 0.0};
}

}  // namespace

std::shared_ptr<const Tile> applyPress(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    const double length = std::hypot(stamp.headingX, stamp.headingZ),
                 strength = std::clamp<double>(brush.strength, 0, 1);
    if (!usableBrush(stamp, brush) || !std::isfinite(length)) return map.tile(tx, ty);
    const bool goes = length > 1e-9;
    const double x = goes ? stamp.headingX / length : 0, z = goes ? stamp.headingZ / length : 0;
    BrushSettings whole = brush;
    whole.strength = 1;
    return paintTile<4>(map, tx, ty, stamp, whole, [&](const auto& row) {
        const double down = (row.y + 0.5 - stamp.y) / stamp.radiusY;
        pressTowards(row, [&](int i) {
            const auto [px, pz] = goes ? std::pair{x, z} : apart((row.x0 + i + 0.5 - stamp.x) / stamp.radiusX, down);
            return PaintedForce{px * strength, pz * strength, strength, strength};
        });
    });
}

}  // namespace sward
