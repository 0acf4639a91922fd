// Raises the map by the weight: 1 (one metre on heights) at full strength.
#include "brushes/paint.h"

namespace sward {

std::shared_ptr<const Tile> applyAdd(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    return paintTile(map, tx, ty, stamp, brush, [](const auto& row) {
        for (int i = 0; i < kTileSize; ++i) row.change[i] = row.scale * row.weight[i];
    });
}

}  // namespace sward
