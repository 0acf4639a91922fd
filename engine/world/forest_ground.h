// The ground under a forest's tiles: a triangle each, and which of them are cliffs. Triangles without area, or steeper
// than 87 degrees, have no volume (the paper asks for cliffs to be cut; hard case D-6): how many, is counted here.
// Pure. Does not: draw, or leave out trees, which Forest::slopeDeg does. Cost: 0.3 us a tile.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "world/forest_stand.h"

namespace sward {

// Corners on the ground, in the world, in the order of the tile's.
std::array<glm::dvec3, 3> groundUnder(const StandingForest& forest, const ForestTriangle& triangle,
                                      const Terrain& terrain);
// Whether a volume may stand over such a triangle (numerics/tilt.h, groundUsable).
bool mayStandOver(const std::array<glm::dvec3, 3>& ground);

// What one of a project's forests comes to.
struct ForestCount {
    std::string entity, technique;
    size_t trees = 0, tiles = 0;  // that stand; triangles that hold any
    size_t cliffs = 0;            // of those, on which far trees are not drawn
};
// In the order of names. The project as it is drawn (world/drawn_project.h).
std::vector<ForestCount> countForests(const Project& project);

}  // namespace sward
