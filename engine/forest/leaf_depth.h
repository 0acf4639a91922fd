// How much deeper in a forest's air its leaves lie than the middles of the parts that hold them. Leaves hang in clumps
// smaller than a part, and a leaf is shaded first of all by its own clump: the mean over leaves of the light that comes
// through the finest texels is less than what comes to the part's middle through the mean of the parts around, deep in
// crowns by a third. (Clumping within a part makes what passes through more, clumpedDepth, and what its leaves get
// less.) Pure. Does not: say how much light comes to the part (volume_bake.h, lightThrough). Cost: 0.3 us a texel that
// holds leaves.
#pragma once
#include "forest/shade_map.h"
#include "forest/volume_bake.h"

namespace sward {

// Optical depth (not above kMostLeafDepth) through the air from lattice coordinates uv, so many metres above the
// ground, along a way (unit, y up), as far as `reach` metres; nothing is above and below the air.
double depthAlong(const ForestAir& air, const glm::dvec2& uv, double height, const glm::dvec3& way, double reach);
inline constexpr double kMostLeafDepth = 12;

struct LeafDepths {
    std::vector<float> deeper;  // by part of the air, as ForestAir::deeper
    float litSeen = 0;          // as ForestAir::litSeen
};
// Over two parts' length, in the mean of directions above the horizon. Parts without leaves have their neighbours'
// mean, by their leaves, so that what is read between parts is a leaf's, too. fine: the same cells in parts a whole
// number of times smaller along each axis.
LeafDepths leafDepths(const ForestAir& fine, const ForestAir& air);

// How much more the leaves of a tree that light from above reaches face it than all its leaves do (factor of what they
// take of it): in a clump the outer leaves are lit, and they face outwards. air: the tree's own. 1 without leaves.
float litFacing(const Mesh& mesh, const TreeAir& air);

}  // namespace sward
