#include "grass/density_ranges.h"

namespace sward {
namespace {
constexpr size_t kMostCells = size_t{1} << 17;  // some 6 MB
}

void keepRangesOf(DensityRanges& r, const Map& map, const Tiling& tiling, double side) {
    if (r.side == side && r.tiling == tiling && r.map.sameTiles(map) && r.cells.size() < kMostCells) return;
    r = {map, tiling, side, {}};
}

}  // namespace sward
