// Small maps of heights and brushes for them, for tests of sculpting.
// Does not: test anything itself.
#pragma once
#include "editor/brushes/stamped.h"
#include "tools/stroke.h"

namespace sward::test {

// Floats in metres, or integers over 0 to 10 m.
inline BrushSettings sculptor(PixelType type, float metres, float strength = 1, float falloff = 0) {
    BrushSettings b = brushOf(strength, falloff, metres);
    paintHeights(b, type == PixelType::F32 ? std::pair(0.0, 1.0) : std::pair(0.0, 10.0));
    return b;
}
inline double metresAt(const Map& map, int x, int y) {
    const double texel = static_cast<double>(map.at(x, y));
    return map.info().type == PixelType::F32 ? texel : 10 * texel;
}
// Level ground at this height.
inline Map levelLand(int side, PixelType type, double metres) {
    return mapOf(side, side, type, static_cast<float>(type == PixelType::F32 ? metres : metres / 10));
}
// All ground, metres times texels.
inline double volume(const Map& map) {
    double sum = 0;
    for (int y = 0; y < map.info().height; ++y)
        for (int x = 0; x < map.info().width; ++x) sum += metresAt(map, x, y);
    return sum;
}
inline constexpr PixelType kHeightTypes[] = {PixelType::U16, PixelType::F32};

}  // namespace sward::test
