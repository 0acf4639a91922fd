// Distances in a raster, exact, in one pass along each axis.
// Source: Felzenszwalb and Huttenlocher 2012, "Distance Transforms of Sampled Functions", algorithm 1.
// Does not: know what the raster shows. Cost: about 20 ns a texel.
#pragma once
#include <cstdint>
#include <vector>

namespace sward {

// Texels from each texel's centre to the centre of the nearest one that is `wanted`; infinity where there is none.
// `texels`: width * height of them, rows first.
std::vector<float> distancesTo(const std::vector<uint8_t>& texels, int width, int height, uint8_t wanted);

}  // namespace sward
