// Painting heights: metres as steps of the map. Does not: know any mode.
#pragma once
#include <algorithm>
#include <cmath>

#include "brushes/paint.h"

namespace sward {

// Steps of a map, `scale` of them in 1 (PixelTraits), that a metre is; below 0 where the range runs downwards.
inline double stepsPerMetre(double scale, const BrushSettings& brush) { return scale / brush.metres.y; }

// A height in metres as the map can hold it, in its steps: within [low, high] or the range of its integers, and whole
// steps there, so that full strength reaches it exactly.
inline double heightSteps(const MapInfo& info, double metres, const BrushSettings& brush) {
    const double value = (metres - brush.metres.x) / brush.metres.y;
    if (info.type == PixelType::F32) return std::clamp<double>(value, brush.low, brush.high);
    return std::round(std::clamp(value, 0.0, 1.0) * (info.type == PixelType::U8 ? 255 : 65535));
}

}  // namespace sward
