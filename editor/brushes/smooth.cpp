// Moves the map towards its own mean around each texel: a square that reaches an eighth of the brush's radius, at least
// one texel and at most kMostReach. Reads the map as it was before the stamp; beyond the edge the map goes on as there.
// Directions are evened out as vectors: those that agree keep their strength, opposite ones cancel. So are forces, as
// they act, and colours as they show, times their opacity. Cost: two running sums over the tile and its margin,
// whatever the radius.
#include <algorithm>

#include "brushes/colours.h"

namespace sward {
namespace {

constexpr int kMostReach = 32;                     // texels to either side; (2 * 32 + 1)^2 * 65535 fits an int
constexpr int kWide = kTileSize + 2 * kMostReach;  // a tile with its largest margin

int reachOf(double radius) {
    return std::clamp(static_cast<int>(std::lround(std::min(radius, 1e4) / 8)), 1, kMostReach);
}

// Integers are summed exactly; floats in double. So a flat map stays exactly as it is, but for forces, to a
// ten-millionth.
template <class T>
using Sum = std::conditional_t<std::is_floating_point_v<T>, double, int>;
// Colours take doubles throughout: their means are divided by each other, and a flat map must stay as it is.
template <class T>
using Mean = std::conditional_t<std::is_same_v<T, double>, double, float>;

// n texels of a row of the map from x0 on, of each what `valueOf` makes of its channels; columns and rows beyond the
// edge repeat it.
template <class T, int Channels, class V, class ValueOf>
void readRow(const Map& map, const ValueOf& valueOf, int x0, int y, int n, V* out) {
    const int width = map.info().width;
    y = std::clamp(y, 0, map.info().height - 1);
    const int from = std::clamp(-x0, 0, n - 1), to = std::clamp(width - x0, from + 1, n);
    for (int i = from; i < to;) {
        const int x = x0 + i, run = std::min(kTileSize - x % kTileSize, to - i);
        const T* in = reinterpret_cast<const T*>(map.tile(x / kTileSize, y / kTileSize)->look()) +
                      (y % kTileSize * kTileSize + x % kTileSize) * Channels;
        for (int k = 0; k < run; ++k) out[i + k] = valueOf(in + k * Channels);
        i += run;
    }
    std::fill(out, out + from, out[from]);
    std::fill(out + to, out + n, out[to - 1]);
}

// sums += add - drop, over all columns: the margin's zeros cost less than a loop of unknown length.
template <class T>
void slide(const T* add, const T* drop, Sum<T>* __restrict sums) {
    for (int x = 0; x < kWide; ++x) sums[x] += static_cast<Sum<T>>(add[x]) - static_cast<Sum<T>>(drop[x]);
}

template <class T>
void meansAcross(const Sum<T>* sums, int reach, double share, Mean<T>* __restrict means) {
    alignas(64) Sum<T> squares[kTileSize];
    Sum<T> sum = 0;
    for (int x = 0; x < 2 * reach; ++x) sum += sums[x];
    for (int x = 0; x < kTileSize; ++x) {
        squares[x] = sum + sums[x + 2 * reach];
        sum = squares[x] - sums[x];
    }
    for (int x = 0; x < kTileSize; ++x) means[x] = static_cast<Mean<T>>(squares[x] * share);
}

// The means around the tile's texels, kTileSize rows of kTileSize.
template <class T, int Channels, class V, class ValueOf>
std::vector<Mean<V>> blurredTile(const Map& map, const ValueOf& valueOf, int tx, int ty, int reachX, int reachY) {
    const int columns = kTileSize + 2 * reachX, rows = kTileSize + 2 * reachY;
    const double share = 1.0 / ((2 * reachX + 1) * (2 * reachY + 1));
    std::vector<V> texels(size_t(rows + 1) * kWide);  // the first row stays zero: nothing drops out at the start
    std::vector<Mean<V>> means(size_t(kTileSize) * kTileSize);
    alignas(64) Sum<V> sums[kWide] = {};
    const auto row = [&](int y) { return &texels[size_t(y + 1) * kWide]; };
    for (int y = 0; y < rows; ++y) {
        readRow<T, Channels>(map, valueOf, tx * kTileSize - reachX, ty * kTileSize - reachY + y, columns, row(y));
        const int top = y - 2 * reachY;  // of the tile's rows, the one whose square ends here
        slide<V>(row(y), row(std::max(top - 1, -1)), sums);
        if (top >= 0) meansAcross<V>(sums, reachX, share, &means[size_t(top) * kTileSize]);
    }
    return means;
}

// What `blurred` makes of the map, told the type of its texels by a zero.
template <class Blurred>
auto byType(const Map& map, const Blurred& blurred) {
    switch (map.info().type) {
        case PixelType::U8:
            return blurred(uint8_t{});
        case PixelType::U16:
            return blurred(uint16_t{});
        case PixelType::F32:
            break;
    }
    return blurred(float{});
}

// Of one channel, in steps of the map.
template <int Channels>
std::vector<float> blurredChannel(const Map& map, int channel, int tx, int ty, const Stamp& stamp) {
    return byType(map, [&](auto zero) {
        using T = decltype(zero);
        const auto valueOf = [channel](const T* texel) { return texel[channel]; };
        return blurredTile<T, Channels, T>(map, valueOf, tx, ty, reachOf(stamp.radiusX), reachOf(stamp.radiusY));
    });
}

// Of what `partOf` makes of the four numbers in [0, 1] of a texel.
template <class V, class PartOf>
std::vector<Mean<V>> blurredPart(const Map& map, const PartOf& partOf, int tx, int ty, const Stamp& stamp) {
    return byType(map, [&](auto zero) {
        using T = decltype(zero);
        const auto valueOf = [&](const T* t) {
            const double scale = static_cast<double>(PixelTraits<T>::scale),
                         texel[4] = {t[0] / scale, t[1] / scale, t[2] / scale, t[3] / scale};
            return static_cast<V>(partOf(texel));
        };
        return blurredTile<T, 4, V>(map, valueOf, tx, ty, reachOf(stamp.radiusX), reachOf(stamp.radiusY));
    });
}

std::shared_ptr<const Tile> smoothForces(const Map& map, int tx, int ty, const Stamp& stamp,
                                         const BrushSettings& brush) {
    const auto part = [&](double PaintedForce::*p) {
        return blurredPart<float>(
            map, [p](const double* texel) { return forceOfTexel(texel).*p; }, tx, ty, stamp);
    };
    const std::vector<float> x = part(&PaintedForce::x), z = part(&PaintedForce::z), press = part(&PaintedForce::press),
                             share = part(&PaintedForce::share);
    return paintTile<4>(map, tx, ty, stamp, brush, [&](const auto& row) {
        const size_t from = size_t(row.y - ty * kTileSize) * kTileSize;
        pressTowards(row, [&](int i) {
            return PaintedForce{x[from + size_t(i)], z[from + size_t(i)], press[from + size_t(i)],
                                share[from + size_t(i)]};
        });
    });
}

std::shared_ptr<const Tile> smoothColours(const Map& map, int tx, int ty, const Stamp& stamp,
                                          const BrushSettings& brush) {
    std::vector<double> mean[4];
    for (int c = 0; c < 3; ++c)
        mean[c] = blurredPart<double>(
            map, [c](const double* texel) { return colourOfTexel(texel).color[c]; }, tx, ty, stamp);
    mean[3] = blurredPart<double>(
        map, [](const double* texel) { return colourOfTexel(texel).opacity; }, tx, ty, stamp);
    return paintTile<4>(map, tx, ty, stamp, brush, [&](const auto& row) {
        const size_t from = size_t(row.y - ty * kTileSize) * kTileSize;
        colourTowards(row, [&](int i) {
            const size_t at = from + size_t(i);
            return PaintedColour{{mean[0][at], mean[1][at], mean[2][at]}, mean[3][at]};
        });
    });
}

std::shared_ptr<const Tile> smoothDirections(const Map& map, int tx, int ty, const Stamp& stamp,
                                             const BrushSettings& brush) {
    const std::vector<float> mean[2] = {blurredChannel<2>(map, 0, tx, ty, stamp),
                                        blurredChannel<2>(map, 1, tx, ty, stamp)};
    return paintTile<2>(map, tx, ty, stamp, brush, [&](const auto& row) {
        const size_t from = size_t(row.y - ty * kTileSize) * kTileSize;
        turnTowards(row, [&](int i, int c) { return mean[c][from + size_t(i)]; });
    });
}

}  // namespace

std::shared_ptr<const Tile> applySmooth(const Map& map, int tx, int ty, const Stamp& stamp,
                                        const BrushSettings& brush) {
    const int channels = map.info().channels;
    if (!usableBrush(stamp, brush) || channels == 3) return map.tile(tx, ty);
    if (stamp.spread <= 0 && !ShapeRows(stamp, brush, tx, ty).reachesTile()) return map.tile(tx, ty);
    if (channels == 4 && brush.colours) return smoothColours(map, tx, ty, stamp, brush);
    if (channels == 4) return smoothForces(map, tx, ty, stamp, brush);
    if (channels == 2) return smoothDirections(map, tx, ty, stamp, brush);
    const std::vector<float> mean = blurredChannel<1>(map, 0, tx, ty, stamp);
    return paintTile(map, tx, ty, stamp, brush, [&](const auto& row) {
        const float* of = &mean[size_t(row.y - ty * kTileSize) * kTileSize];
        changeTowards(row, [of](int i) { return of[i]; });
    });
}

}  // namespace sward
