// Small maps and stamps on them, for tests of brushes.
// Does not: test anything itself.
#pragma once
#include <gtest/gtest.h>

#include <random>

#include "brushes/brush.h"

namespace sward::test {

inline Map mapOf(int width, int height, PixelType type, float value) {
    Map map({width, height, 1, type});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) map.set(x, y, 0, value);
    return map;
}
inline Map randomMap(int width, int height, PixelType type, unsigned seed) {
    Map map({width, height, 1, type});
    std::mt19937 random(seed);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) map.set(x, y, 0, static_cast<float>(random() % 65536) / 65535.0f);
    return map;
}
inline BrushSettings brushOf(float strength, float falloff = 0.5f, float value = 1) {
    BrushSettings b;
    b.strength = strength;
    b.falloff = falloff;
    b.value = value;
    return b;
}
inline void paint(Map& map, const char* mode, const Stamp& stamp, const BrushSettings& brush) {
    const BrushRow* row = findBrush(mode);
    ASSERT_NE(row, nullptr) << mode;
    applyStamp(map, *row, stamp, brush);
}
inline constexpr PixelType kTypes[] = {PixelType::U8, PixelType::U16, PixelType::F32};

}  // namespace sward::test
