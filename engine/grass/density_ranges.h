// Lowest and highest density within cells, kept from frame to frame: a view asks for nearly the same cells as the one
// before, and a cell may hold hundreds of texels. Pure; not for several threads at once.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "maps/map.h"
#include "scene/tiling.h"

namespace sward {

struct DensityRanges {
    Map map;  // that they are of
    Tiling tiling;
    double side = 0;  // of a cell, metres
    std::unordered_map<uint64_t, std::pair<float, float>> cells;
};

// Forgets all that is not of this map, laid out so, in cells of this side; and all, where it got too much.
void keepRangesOf(DensityRanges& r, const Map& map, const Tiling& tiling, double side);

// Of the cell (x, z); find() says it where it is not known yet.
template <class Find>
std::pair<float, float> rangeOf(DensityRanges& r, int x, int z, const Find& find) {
    const uint64_t cell = uint64_t{static_cast<uint32_t>(x)} << 32 | static_cast<uint32_t>(z);
    if (const auto known = r.cells.find(cell); known != r.cells.end()) return known->second;
    return r.cells.emplace(cell, find()).first->second;
}

}  // namespace sward
