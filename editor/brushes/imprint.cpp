// Stamps a picture into the ground: its light times the brush's value is a height over the stamp's base. Added it is
// the shape alone, as raise lays it; the others take the base along, within the ring, and fade by the falloff towards
// it. Without a shape the light is 1 everywhere.
#include "brushes/heights.h"

namespace sward {
namespace {

// The heights of a row towards which it is painted, in steps of its map and within its limits; whole ones where it is
// of integers, so that full strength reaches them exactly.
template <class Real>
struct Targets {
    Real from, step, low, high;  // at light 0; of light 1 more than that
    bool whole;

    Targets(const MapInfo& info, Real scale, const Stamp& stamp, const BrushSettings& b) {
        const double unit = static_cast<double>(scale) / b.metres.y;
        from = static_cast<Real>((stamp.beginHeight - b.metres.x) * unit);
        step = static_cast<Real>(static_cast<double>(b.value) * unit);
        whole = info.type != PixelType::F32;
        low = whole ? Real(0) : static_cast<Real>(b.low);
        high = whole ? scale : static_cast<Real>(b.high);
    }
    Real operator()(float light) const {
        const Real t = std::min(std::max(from + step * static_cast<Real>(light), low), high);
        return whole ? static_cast<Real>(static_cast<int>(t + Real(0.5))) : t;
    }
};

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
        const Targets<Real> target(map.info(), row.scale, stamp, brush);
        const bool higher = (brush.blend == HeightBlend::Maximum) != (brush.metres.y < 0);  // in steps
        if (brush.blend == HeightBlend::Replace)
            changeTowards(row, [&](int i) { return target(light[i]); });
        else if (higher)
            changeTowards(row, [&](int i) { return std::max(row.value[i], target(light[i])); });
        else
            changeTowards(row, [&](int i) { return std::min(row.value[i], target(light[i])); });
    });
}

}  // namespace sward
