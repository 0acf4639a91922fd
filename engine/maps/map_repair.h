// Non-finite texels of float maps, and changes of pixel type. For map_io.cpp.
#pragma once
#include <optional>
#include <utility>

#include "maps/map.h"

namespace sward {

// What repairTexels found.
struct TexelRepair {
    size_t count = 0;            // texels with a NaN or infinite channel
    int firstX = 0, firstY = 0;  // the first of them, by rows
    bool anyFinite = true;       // false: some channel had no finite value at all, and is 0 now
};
// Replaces each non-finite channel of a texel by that of the nearest texel (Euclidean; ties: the smaller x) where it is
// finite. Method: the linear-time distance transform of Meijster, Roerdink and Hesselink 2000, with sites. Costs
// nothing but a scan where all is finite.
TexelRepair repairTexels(Map& map);

// The map in another type. Integers to floats: 0 and full scale become range (default 0, 1); floats to integers: range
// becomes 0 and full scale, values beyond are clamped. Between integers: rounded to nearest.
Map convertMap(const Map& map, PixelType type, const std::optional<std::pair<double, double>>& range = {});

}  // namespace sward
