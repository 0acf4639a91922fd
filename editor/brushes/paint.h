// What all brushes share: the weights of a stamp over a tile, and the loop that adds a change to its texels.
// Values and changes are counted in steps of the map's type: 0 to 255, 0 to 65535, or the float itself.
// Does not: know any mode; each brush gives its own change. Maps of one channel, of two that make a direction, of four
// that make a force; of colours: colours.h.
#pragma once
#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

#include "brushes/brush.h"
#include "brushes/shape.h"

namespace sward {

// A row of a tile, in the arithmetic of its map: float holds every step of the integers, double every sum of floats.
template <class T>
struct PixelTraits {
    using Real = std::conditional_t<std::is_same_v<T, float>, double, float>;
    static constexpr float scale = std::is_same_v<T, float> ? 1.0f : static_cast<float>(std::numeric_limits<T>::max());
};
template <class Real>
struct PaintRow {
    int x0, y;            // first texel, in the map
    Real scale;           // steps in 1
    const float* weight;  // kTileSize: strength times falloff, in [0,1]; 0 beyond the map's edge
    const Real* value;    // kTileSize times channels, interleaved: as before the stamp
    Real* change;         // as many: to be filled
};

// The falloff of a stamp, relative to a tile. With r the distance in radii and c = 1 - falloff the hard core:
// weight = smoothstep((1 - r^2) / (1 - c^2)). The edge is never narrower than a texel, and a stamp smaller than a texel
// paints a texel with a weight of its share of it: no stair steps, and nothing at all at radius 0. A brush with a shape
// takes the weight from that instead.
class StampWeights {
  public:
    StampWeights(const MapInfo& info, const Stamp& stamp, const BrushSettings& brush, int tx, int ty);
    // False if the row (0 to kTileSize - 1) lies beyond the stamp and its spread; else fills kTileSize weights.
    bool row(int y, float* weight) const;

  private:
    void along(float dy, float* weight) const;

    float centreX_, centreY_, invX_, invY_, invRange_, strength_;
    float farthest_;           // rows beyond this many radii, squared, are not painted
    float acrossX_, acrossY_;  // of a stamp from one place to another: the way between them, in radii
    ShapeRows shape_;
    bool spreads_ = false;  // rows beyond the shape are asked for, too
    int columns_, rows_;
};

// The loops below run over whole rows of a tile without branches, so that compilers make vector code of them.

// max(x, 0) and clamp(x, 0, 1), for floating point; exact but for what 1 - x rounds off.
template <class R>
R positivePart(R x) {
    return R(0.5) * (x + std::abs(x));
}
template <class R>
R unitPart(R x) {
    return positivePart(R(1) - positivePart(R(1) - x));
}

// Adds changes to integers: whole steps and, if the rest reaches the threshold, one more. Symmetric in sign.
template <int Values, class T>
void addSteps(const T* in, const float* change, float threshold, T* __restrict out) {
    constexpr int most = std::numeric_limits<T>::max();
    for (int i = 0; i < Values; ++i) {
        const int whole = static_cast<int>(change[i]);
        const float rest = change[i] - static_cast<float>(whole);
        const int up = rest >= threshold, down = rest <= -threshold;
        out[i] = static_cast<T>(std::min(std::max(in[i] + whole + up - down, 0), most));
    }
}
// Texels without a change keep their value, even one outside [low, high].
template <int Values>
void addFloats(const float* in, const double* change, double low, double high, float* __restrict out) {
    for (int i = 0; i < Values; ++i) {
        const double next = in[i] + change[i];
        const double kept = next < low ? low : next > high ? high : next;
        out[i] = change[i] == 0 ? in[i] : static_cast<float>(kept);
    }
}
// 1 - frac(1/2 + n * golden ratio): of n consecutive stamps the share rest of them reaches it, to within about one.
inline float roundingThreshold(uint32_t turn) {
    const uint32_t t = 0x80000000u + turn * 0x9E3779B9u;
    return 1.0f - static_cast<float>(t >> 8) * 0x1p-24f;
}
// False for settings that paint nothing, or that are not finite.
bool usableBrush(const Stamp& stamp, const BrushSettings& brush);

// The tile as changeOf(row) leaves it, for maps of this texel type; the old pointer if nothing changed.
template <int Channels, class T, class ChangeOf>
std::shared_ptr<const Tile> paintTyped(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush,
                                       const ChangeOf& changeOf) {
    using Real = typename PixelTraits<T>::Real;
    constexpr int kValues = kTileSize * Channels;
    const std::shared_ptr<const Tile>& old = map.tile(tx, ty);
    const StampWeights weights(map.info(), stamp, brush, tx, ty);
    const float threshold = roundingThreshold(stamp.turn);
    const TileTexels texels = old->texels();
    std::shared_ptr<Tile> fresh;
    alignas(64) float weight[kTileSize];
    alignas(64) Real value[kValues], change[kValues];
    alignas(64) T next[kValues];
    for (int y = 0; y < kTileSize; ++y) {
        if (!weights.row(y, weight)) continue;
        const T* in = reinterpret_cast<const T*>(texels.data()) + y * kValues;
        for (int i = 0; i < kValues; ++i) value[i] = static_cast<Real>(in[i]);
        changeOf(PaintRow<Real>{tx * kTileSize, ty * kTileSize + y, PixelTraits<T>::scale, weight, value, change});
        if constexpr (std::is_same_v<T, float>)
            addFloats<kValues>(in, change, brush.low, brush.high, next);
        else
            addSteps<kValues>(in, change, threshold, next);
        if (std::memcmp(in, next, sizeof next) == 0) continue;
        if (!fresh) fresh = std::make_shared<Tile>(*old);
        std::memcpy(fresh->write() + size_t(y) * sizeof next, next, sizeof next);
    }
    return fresh ? std::shared_ptr<const Tile>(std::move(fresh)) : old;
}

// Calls changeOf(PaintRow<float or double>) for each row that the stamp reaches, and adds what it filled in. Maps of
// another number of channels are left alone.
template <int Channels = 1, class ChangeOf>
std::shared_ptr<const Tile> paintTile(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush,
                                      const ChangeOf& changeOf) {
    if (!usableBrush(stamp, brush) || map.info().channels != Channels) return map.tile(tx, ty);
    switch (map.info().type) {
        case PixelType::U8:
            return paintTyped<Channels, uint8_t>(map, tx, ty, stamp, brush, changeOf);
        case PixelType::U16:
            return paintTyped<Channels, uint16_t>(map, tx, ty, stamp, brush, changeOf);
        case PixelType::F32:
            return paintTyped<Channels, float>(map, tx, ty, stamp, brush, changeOf);
    }
    return map.tile(tx, ty);
}

// Texels that eachBlock hands out at a time.
inline constexpr int kPaintBlock = 32;
static_assert(kTileSize % kPaintBlock == 0);

// Whether a stamp reaches any of kPaintBlock texels.
inline bool anyWeight(const float* weight) {
    uint32_t bits = 0;  // of all: none is below 0
    for (int i = 0; i < kPaintBlock; ++i) bits |= std::bit_cast<uint32_t>(weight[i]);
    return bits != 0;
}
// Calls body(from) for each block of the row that the stamp reaches, to fill the changes from there on; those of the
// others become 0. Half a tile's corner lies beyond a large ring.
template <class Real, class Body>
void eachBlock(const PaintRow<Real>& row, const Body& body) {
    for (int from = 0; from < kTileSize; from += kPaintBlock) {
        if (anyWeight(row.weight + from))
            body(from);
        else
            std::fill(row.change + from, row.change + from + kPaintBlock, Real(0));
    }
}

// change = (target - value) * weight, with target(i) in steps of the map.
template <class Real, class Target>
void changeTowards(const PaintRow<Real>& row, const Target& target) {
    for (int i = 0; i < kTileSize; ++i) row.change[i] = (target(i) - row.value[i]) * static_cast<Real>(row.weight[i]);
}
// The same for directions: target(i, c), c 0 for x and 1 for z.
template <class Real, class Target>
void turnTowards(const PaintRow<Real>& row, const Target& target) {
    for (int i = 0; i < 2 * kTileSize; ++i)
        row.change[i] = (target(i / 2, i % 2) - row.value[i]) * static_cast<Real>(row.weight[i / 2]);
}

// Of maps of four channels: mix(i, weight, texel) makes of each texel, four numbers in [0, 1], what it becomes.
template <class Real, class Mix>
void changeTexels(const PaintRow<Real>& row, const Mix& mix) {
    const double scale = static_cast<double>(row.scale);
    for (int i = 0; i < kTileSize; ++i) {
        double before[4] = {}, texel[4] = {};
        for (int c = 0; c < 4; ++c) before[c] = texel[c] = static_cast<double>(row.value[4 * i + c]) / scale;
        mix(i, static_cast<double>(row.weight[i]), texel);
        for (int c = 0; c < 4; ++c) row.change[4 * i + c] = static_cast<Real>((texel[c] - before[c]) * scale);
    }
}

// A force as it acts: push and press times their share.
struct PaintedForce {
    double x = 0, z = 0, press = 0, share = 0;
};
// Of four numbers in [0, 1], those of a texel; half a step of eight bits about 0.5 is no push, as for who reads the
// map.
PaintedForce forceOfTexel(const double* texel);
// The same for forces: target(i). What acts is mixed, so that what a texel of no share holds does not show.
void texelOfForce(const PaintedForce& force, double* texel);  // a push of no share: none
// Forces of a row towards target(i), by the weights of the stamp.
template <class Real, class Target>
void pressTowards(const PaintRow<Real>& row, const Target& target) {
    changeTexels(row, [&](int i, double w, double* texel) {
        const PaintedForce a = forceOfTexel(texel), b = target(i);
        if (!(w > 0 && (a.share > 0 || b.share > 0))) return;
        const auto mixed = [w](double from, double to) { return from + (to - from) * w; };
        texelOfForce({mixed(a.x, b.x), mixed(a.z, b.z), mixed(a.press, b.press), mixed(a.share, b.share)}, texel);
    });
}

// The modes; one file each.
using ApplyBrush = std::shared_ptr<const Tile>(const Map&, int, int, const Stamp&, const BrushSettings&);
ApplyBrush applyAdd, applySubtract, applySet, applySmooth, applyNoise, applyComb, applyDirection, applyPress,
    applyRaise, applyLower, applyFlatten, applyRamp, applyImprint;
void applyErode(Map& map, const Stamp& stamp, const BrushSettings& brush);

}  // namespace sward
