// Painting colours: texels of a colour and its opacity, mixed as they show, colour times opacity, so that the colour of
// what is transparent never comes to light (T. Porter and T. Duff, Compositing Digital Images, 1984). Colours are mixed
// as the map holds them, in sRGB, as image programs do. Does not: know what lies under the map.
#pragma once
#include <algorithm>

#include "brushes/paint.h"

namespace sward {

// As it shows: times its opacity.
struct PaintedColour {
    glm::dvec3 color{0};
    double opacity = 0;
};
// Of four numbers in [0, 1], those of a texel.
PaintedColour colourOfTexel(const double* texel);
void texelOfColour(const PaintedColour& colour, double* texel);  // of no opacity: the texel's own colour stays
// A colour of this opacity laid on a texel: the share w of the way to it.
void mixColour(const PaintedColour& to, double w, double* texel);
// A number in [0, 1] as the map can hold it: rounded to its steps, so that painting longer ends on it.
double colourSteps(const MapInfo& info, float value);

// The share of the way to target(i).
template <class Real, class Target>
void colourTowards(const PaintRow<Real>& row, const Target& target) {
    changeTexels(row, [&](int i, double w, double* texel) {
        if (w > 0) mixColour(target(i), w, texel);
    });
}

// Lays the brush's colour with opacityAt(x, y, opacity before) of each texel. What has no opacity, out to the stamp's
// spread, takes the colour at once; not with a value of 0, which lays nothing.
template <class OpacityAt>
std::shared_ptr<const Tile> layColour(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush,
                                      const OpacityAt& opacityAt) {
    glm::dvec3 color;
    for (int c = 0; c < 3; ++c) color[c] = colourSteps(map.info(), brush.color[c]);
    const double rx = std::max(stamp.radiusX, 1.0) + stamp.spread, ry = std::max(stamp.radiusY, 1.0) + stamp.spread;
    return paintTile<4>(map, tx, ty, stamp, brush, [&](const auto& row) {
        const double down = (row.y + 0.5 - stamp.y) / ry;
        changeTexels(row, [&](int i, double w, double* texel) {
            const int x = row.x0 + i;
            const double across = (x + 0.5 - stamp.x) / rx, opacity = texel[3];
            const bool reached = brush.value > 0 && across * across + down * down < 1 && x < map.info().width &&
                                 row.y < map.info().height;
            if (!(opacity > 0) && reached)
                for (int c = 0; c < 3; ++c) texel[c] = color[c];
            if (!(w > 0)) return;
            const double to = std::clamp(opacityAt(x, row.y, opacity), 0.0, 1.0);
            mixColour({color * to, to}, w, texel);
        });
    });
}

}  // namespace sward
