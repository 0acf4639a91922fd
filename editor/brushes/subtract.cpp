// Lowers the map by the weight: 1 at full strength. Of a direction it takes the weight's share
// away: the blades stand up again. So of a force: what is pressed rises; and of a colour's opacity: the colour itself
// stays.
#include "brushes/colours.h"

namespace sward {

std::shared_ptr<const Tile> applySubtract(const Map& map, int tx, int ty, const Stamp& stamp,
                                          const BrushSettings& brush) {
    if (map.info().channels == 2)
        return paintTile<2>(map, tx, ty, stamp, brush,
                            [](const auto& row) { turnTowards(row, [&](int, int) { return row.scale / 2; }); });
    if (brush.colours)
        return paintTile<4>(map, tx, ty, stamp, brush,
                            [](const auto& row) { colourTowards(row, [](int) { return PaintedColour{}; }); });
    if (map.info().channels == 4)
        return paintTile<4>(map, tx, ty, stamp, brush,
                            [](const auto& row) { pressTowards(row, [](int) { return PaintedForce{}; }); });
    return paintTile(map, tx, ty, stamp, brush, [](const auto& row) {
        for (int i = 0; i < kTileSize; ++i) row.change[i] = -row.scale * row.weight[i];
    });
}

}  // namespace sward
