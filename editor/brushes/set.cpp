// Moves the map towards the brush's value by the weight as a share of the way; on maps of colours towards its colour
// with the value for opacity.
#include <algorithm>

#include "brushes/colours.h"

namespace sward {
namespace {
// In steps of the map; whole ones where the map is of integers, so that full strength reaches it exactly.
float targetSteps(const MapInfo& info, const BrushSettings& brush) {
    if (info.type == PixelType::F32) return std::clamp(brush.value, brush.low, brush.high);
    const float scale = info.type == PixelType::U8 ? 255.0f : 65535.0f;
    return std::round(std::clamp(brush.value, 0.0f, 1.0f) * scale);
}
}  // namespace

std::shared_ptr<const Tile> applySet(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    if (brush.colours)
        return layColour(map, tx, ty, stamp, brush,
                         [to = colourSteps(map.info(), brush.value)](int, int, double) { return to; });
    const float target = targetSteps(map.info(), brush);
    return paintTile(map, tx, ty, stamp, brush,
                     [target](const auto& row) { changeTowards(row, [target](int) { return target; }); });
}

}  // namespace sward
