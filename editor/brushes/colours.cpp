#include "brushes/colours.h"

#include <algorithm>

namespace sward {

PaintedColour colourOfTexel(const double* texel) {
    const double opacity = std::clamp(texel[3], 0.0, 1.0);
    return {glm::dvec3(texel[0], texel[1], texel[2]) * opacity, opacity};
}

void texelOfColour(const PaintedColour& colour, double* texel) {
    texel[3] = colour.opacity < 1e-9 ? 0 : std::min(colour.opacity, 1.0);
    if (texel[3] == 0) return;
    for (int c = 0; c < 3; ++c) texel[c] = std::clamp(colour.color[c] / texel[3], 0.0, 1.0);
}

void mixColour(const PaintedColour& to, double w, double* texel) {
    const PaintedColour from = colourOfTexel(texel);
    if (!(from.opacity > 0 || to.opacity > 0)) return;
    texelOfColour({from.color + (to.color - from.color) * w, from.opacity + (to.opacity - from.opacity) * w}, texel);
}

double colourSteps(const MapInfo& info, float value) {
    const double v = std::clamp<double>(value, 0, 1);
    if (info.type == PixelType::F32) return v;
    const double scale = info.type == PixelType::U8 ? 255 : 65535;
    return std::round(v * scale) / scale;
}

}  // namespace sward
