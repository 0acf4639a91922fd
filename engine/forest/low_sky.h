// What trees farther away than their own shade (shade_map.h) hide of the low sky. A wood around a glade takes little of
// the light on level ground, which hardly sees the horizon, and several times as much from what stands upright, as
// grass does. Leaves are taken as columns on a grid; each cell looks in twelve directions around it.
// Pure. Does not: light that those trees send in the sky's place.
// Cost: 0.1 s for 96 x 96 cells, the most, on two cores; 8 bytes a cell.
#pragma once
#include <span>

#include "forest/shade_map.h"

namespace sward {

// A forest and the air of its species.
struct AiryForest {
    const StandingForest* forest;
    const std::vector<TreeAir>* airs;
    double verticalScale = 1;  // Forest's
};
LowSky lowSkyOf(const Terrain& terrain, const glm::dvec3& origin, std::span<const AiryForest> forests);

}  // namespace sward
