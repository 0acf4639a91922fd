// The tiles of a forest, eight or 32: which trees lie in each, and which across each kind of edge (Decaudin and Neyret
// 2004, section 7). A tree whose circle crosses an edge belongs to that edge and stands wherever an edge of its family
// and colour is; no circle crosses two, so that nothing crosses a corner. Trees keep their distance from each other
// however tiles are laid. Places are drawn one after the other in random order (darts), as many on edges and within
// tiles as the area asks that they have to themselves: no place near an edge is favoured. Pure. Does not: say which
// tile lies where on a terrain (numerics/forest.h, world/forest_stand.h), or grow trees.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "scene/forest.h"

namespace sward {

// A tree as it stands in a tile or across an edge.
struct TileTree {
    glm::dvec2 at{0};      // x, z in metres from its cell's corner (i, j)
    uint32_t species = 0;  // of Forest::species
    float size = 1;        // factor of its species' height
    float headingDeg = 0;  // turn about the upright
};
enum class EdgeFamily { Row, Slant, Across };  // H, S, D of numerics/forest.h

struct ForestTiles {
    double edge = 16;                                          // metres
    double circle = 2;                                         // metres: radius of every tree's circle
    int colors = 2;                                            // of each family's edges: 2 or 4
    std::array<std::vector<std::vector<TileTree>>, 3> onEdge;  // by family and colour
    std::vector<std::array<std::vector<TileTree>, 2>> inside;  // by tile cell (x + colors y), then down, up
    double asked = 0, placed = 0;                              // trees in all tiles
    float highest = 0;                                         // metres that the tallest tree rises
    int cells() const { return colors * colors; }
    const std::vector<TileTree>& within(int cell, bool up) const {
        return inside[static_cast<size_t>(cell)][up ? 1 : 0];
    }
    const std::vector<TileTree>& across(EdgeFamily f, int color) const {
        return onEdge[static_cast<size_t>(f)][static_cast<size_t>(color)];
    }
};
// The tiles of a forest; the same for equal fields of species, density and seed. A tile may hold fewer trees than are
// asked for where they find no room, or beyond kMostInside and kMostOnEdge: `placed` says how many.
ForestTiles forestTiles(const Forest& forest);

// What a tile is made of: where it lies among the cells that repeat, and its edges' colours.
struct ForestTile {
    int cell = 0;  // x + colors y
    bool up = true;
    std::array<int, 3> colors{};  // of its edges, by EdgeFamily
};
// The tile of a triangle of the lattice's cell (i, j), and of one of the colors x colors cells that repeat.
ForestTile tileAt(int i, int j, bool up, uint32_t seed, int colors);
ForestTile storedTile(int cell, bool up, int colors);
// The edge of a family of a triangle in cell (i, j): the cell that its trees count from.
glm::ivec2 edgeOwner(int i, int j, bool up, EdgeFamily family);

}  // namespace sward
