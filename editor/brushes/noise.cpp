// Moves each texel towards a random number between 0 and the brush's value, the same for every stamp with the same
// seed, so that painting longer brings the pattern out and never drifts. On maps of colours the number is the opacity
// of the brush's colour.
#include "brushes/colours.h"

namespace sward {
namespace {
// Integer mixing of a texel's place and the seed; uniform over 32 bits.
uint32_t texelHash(uint32_t x, uint32_t y, uint32_t seed) {
    uint32_t h = x * 0x8DA6B343u ^ y * 0xD8163841u ^ seed * 0xCB1AB31Fu;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return h ^ (h >> 15);
}
}  // namespace

std::shared_ptr<const Tile> applyNoise(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    const uint32_t seed = static_cast<uint32_t>(brush.seed);
    if (brush.colours)
        return layColour(map, tx, ty, stamp, brush, [&](int x, int y, double) {
            const uint32_t h = texelHash(static_cast<uint32_t>(x), static_cast<uint32_t>(y), seed);
            return static_cast<double>(brush.value) * (h >> 8) * 0x1p-24;
        });
    return paintTile(map, tx, ty, stamp, brush, [&](const auto& row) {
        using Real = std::remove_cvref_t<decltype(row.scale)>;
        const Real amount = row.scale * static_cast<Real>(brush.value) * static_cast<Real>(0x1p-24);
        changeTowards(row, [&](int i) {
            const uint32_t h = texelHash(static_cast<uint32_t>(row.x0 + i), static_cast<uint32_t>(row.y), seed);
            return amount * static_cast<Real>(h >> 8);
        });
    });
}

}  // namespace sward
