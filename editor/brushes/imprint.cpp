// Stamps a picture into the ground: its light times the brush's value is a height over the stamp's base. Added it is
// the shape alone, as raise lays it; the others take the base along, within the ring, and fade by the falloff towards
// it. Without a shape the light is 1 everywhere.
#include "brushes/heights.h"

namespace sward {
namespace {

// In steps of a map; `downwards`: whose range runs downwards, so that more steps are less height.
double blended(HeightBlend blend, double before, double height, bool downwards) {
    if (blend == HeightBlend::Replace) return height;
    return (blend == HeightBlend::Maximum) != downwards ? std::max(before, height) : std::min(before, height);
}

}  // namespace

std::shared_ptr<const Tile> applyImprint(const Map& map, int tx, int ty, const Stamp& stamp,
                                         const BrushSettings& brush) {
    if (brush.blend == HeightBlend::Add) return applyRaise(map, tx, ty, stamp, brush);
    if (!std::isfinite(stamp.beginHeight)) return map.tile(tx, ty);
    const ShapeRows shape(stamp, brush, tx, ty);
    BrushSettings round = brush;
    round.shape.reset();
    return paintTile(map, tx, ty, stamp, round, [&](const auto& row) {
        using Real = std::remove_cvref_t<decltype(row.scale)>;
        alignas(64) float light[kTileSize];
        std::fill(light, light + kTileSize, 1.0f);
        if (shape.any()) shape.row(row.y - ty * kTileSize, light);
        changeTowards(row, [&](int i) {
            const double metres = stamp.beginHeight + static_cast<double>(brush.value) * static_cast<double>(light[i]);
            return static_cast<Real>(blended(brush.blend, static_cast<double>(row.value[i]),
                                             heightSteps(map.info(), metres, brush), brush.metres.y < 0));
        });
    });
}

}  // namespace sward
