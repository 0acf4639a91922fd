// Moves ground towards a height by the weight as a share of the way: flatten towards the brush's value in metres; ramp
// towards the heights that the stamp has at its two ends, in between by how far along the way a place lies.
#include "brushes/heights.h"

namespace sward {

std::shared_ptr<const Tile> applyFlatten(const Map& map, int tx, int ty, const Stamp& stamp,
                                         const BrushSettings& brush) {
    const double target = heightSteps(map.info(), static_cast<double>(brush.value), brush);
    return paintTile(map, tx, ty, stamp, brush, [target](const auto& row) {
        using Real = std::remove_cvref_t<decltype(row.scale)>;
        changeTowards(row, [to = static_cast<Real>(target)](int) { return to; });
    });
}

std::shared_ptr<const Tile> applyRamp(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    const double x = stamp.acrossX / stamp.radiusX, y = stamp.acrossY / stamp.radiusY, length2 = x * x + y * y;
    const double begin = heightSteps(map.info(), stamp.beginHeight, brush),
                 end = heightSteps(map.info(), stamp.endHeight, brush);
    if (!std::isfinite(length2) || !std::isfinite(begin) || !std::isfinite(end)) return map.tile(tx, ty);
    return paintTile(map, tx, ty, stamp, brush, [&](const auto& row) {
        using Real = std::remove_cvref_t<decltype(row.scale)>;
        const double down = (row.y + 0.5 - stamp.y) / stamp.radiusY;
        changeTowards(row, [&](int i) {
            const double right = (row.x0 + i + 0.5 - stamp.x) / stamp.radiusX;
            const double share = length2 > 0 ? unitPart((right * x + down * y) / length2) : 0;
            return static_cast<Real>(begin + (end - begin) * share);
        });
    });
}

}  // namespace sward
