// Raises or lowers ground: the brush's value in metres, times the weight.
#include "brushes/heights.h"

namespace sward {
namespace {

std::shared_ptr<const Tile> raiseBy(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush,
                                    double metres) {
    return paintTile(map, tx, ty, stamp, brush, [&](const auto& row) {
        using Real = std::remove_cvref_t<decltype(row.scale)>;
        const Real steps = static_cast<Real>(metres * stepsPerMetre(static_cast<double>(row.scale), brush));
        for (int i = 0; i < kTileSize; ++i) row.change[i] = steps * static_cast<Real>(row.weight[i]);
    });
}

}  // namespace

std::shared_ptr<const Tile> applyRaise(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    return raiseBy(map, tx, ty, stamp, brush, static_cast<double>(brush.value));
}
std::shared_ptr<const Tile> applyLower(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    return raiseBy(map, tx, ty, stamp, brush, -static_cast<double>(brush.value));
}

}  // namespace sward
