// Raises the map by the weight: 1 at full strength. Lays colour over what is there by the
// weight; opacity goes as far as the brush's value, and never down.
#include <algorithm>

#include "brushes/colours.h"

namespace sward {

std::shared_ptr<const Tile> applyAdd(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    if (brush.colours)
        return layColour(
            map, tx, ty, stamp, brush,
            [most = colourSteps(map.info(), brush.value)](int, int, double before) { return std::max(before, most); });
    return paintTile(map, tx, ty, stamp, brush, [](const auto& row) {
        for (int i = 0; i < kTileSize; ++i) row.change[i] = row.scale * row.weight[i];
    });
}

}  // namespace sward
