// Operations over whole maps that scripts would be too slow for texel by texel: fill, noise, blur, curve.
// Does not: know metres beyond the extent it is given, undo or Lua. All run on all cores and give the same bits on any
// number of them.
#pragma once
#include <array>
#include <utility>
#include <vector>

#include "maps/map.h"

namespace sward {

// Which channels an operation changes.
using Channels = std::array<bool, 4>;
inline constexpr Channels kAllChannels{true, true, true, true};

// Every texel gets the same value; channels beyond the map's are ignored.
void fillMap(Map& map, const std::array<float, 4>& value);

enum class NoiseMode { Add, Multiply, Set };
struct NoiseSettings {
    double scale = 1;   // metres between the bumps of the first octave, > 0
    int octaves = 4;    // 1 to 16; each next has half the size and half the strength
    double amount = 1;  // see noiseMap
    int seed = 0;
    NoiseMode mode = NoiseMode::Add;
    bool seamless = false;  // the map's last texels go on with its first ones; the scale is rounded so that it does
};
// Smooth gradient noise n in [0,1] with mean 1/2, over a map of width x depth metres.
// Add: value + amount (2n - 1). Multiply: value (1 + amount (2n - 1)). Set: amount n.
void noiseMap(Map& map, double width, double depth, const NoiseSettings& settings, const Channels& channels);

// A bell of standard deviation radius / 2 texels, as three boxes; beyond the edge the map goes on as there, or, where
// it repeats, with its other side. Radius 0 changes nothing.
void blurMap(Map& map, double radiusX, double radiusY, const Channels& channels, bool repeats = false);

// Replaces each value by that of the polyline through the points (value, result), sorted by value, at least one;
// beyond the ends it is level.
void curveMap(Map& map, const std::vector<std::pair<double, double>>& points, const Channels& channels);

}  // namespace sward
