// Light from all around that comes past leaves to the vertices of a tree's mesh, as shares of the sky's and of the
// ground's on both sides of a surface. Counted are the leaves of its own crown, by its air (shade_map.h), and in a
// closed wood those of the others, as the mean of all that its tiles hold. Trunks and twigs hide nothing here but by
// their normals. Pure. Does not: light of the sun, which shadow maps have; light from leaf to leaf (lightFromLeaves,
// numerics/forest.h). Cost: 4 us a vertex on two cores, a tenth of that of meshes of a million; 12 bytes a vertex.
#pragma once
#include <span>

#include "forest/shade_map.h"

namespace sward {

// Leaves of a closed wood, by height, spread evenly over the ground.
struct WoodAir {
    double layer = 0.5;         // metres
    std::vector<double> below;  // m² of them on a m², from the ground up to each layer's bottom; the last is the top's
    // Of a column, from one height up to another.
    double between(double low, double high) const;
};
// airs: by species; those of a forest whose triangles all hold their trees. perHectare: trees asked for.
WoodAir woodAir(const ForestTiles& tiles, double perHectare, std::span<const TreeAir> airs);

// Air of what is flat in a mesh: its leaves.
TreeAir leafAir(const Mesh& mesh);

// Shares (255: all) of the light from above the horizon and from below it: on the side of the vertex's normal, then on
// the other one.
struct VertexShares {
    glm::u8vec4 alone{255};  // where no other tree stands; its own leaves shade the ground
    glm::u8vec4 among{255};  // in a closed wood, whose shade on the ground is not in it
    // Of one direction above the horizon, past its own leaves (127: all): the mean, and what a way gains by x and by z.
    glm::i8vec4 open{127, 0, 0, 0};
};
// By vertex of a mesh of the species with that air. verticalScale: Forest's.
std::vector<VertexShares> lightOnTree(const Mesh& mesh, const TreeAir& air, const WoodAir& wood,
                                      double verticalScale = 1);

// How full the wood stands around each tree, as a share of what perHectare asks, within one and a half of the tallest
// tree's height: the mean over all sides, and by how much more it does along x and z than against them. A tree counts
// by the angle that it takes of the view: by the inverse of its distance.
std::vector<glm::vec3> woodAround(const StandingForest& forest, double perHectare);

}  // namespace sward
