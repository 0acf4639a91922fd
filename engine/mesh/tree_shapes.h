// Trees grown by a few numbers: trunk, branches and leaves as triangles, a part for each colour.
// Leaves lie about their twigs in all directions, so that a crown looks equally dense from everywhere.
// Does not: read files (mesh_io.h). The same numbers give the same tree on every machine.
#pragma once
#include <glm/glm.hpp>

#include "core/enum_names.h"
#include "mesh/mesh.h"

namespace sward {

enum class TreeKind {
    Conifer,    // a straight trunk, whorls of drooping branches, a pointed crown
    Broadleaf,  // a trunk that forks, a round crown of clumps of leaves
    Birch,      // a slender white trunk, sprays that hang
};
inline constexpr auto kTreeKinds = enumNames<TreeKind>("conifer", "broadleaf", "birch");

struct TreeShape {
    TreeKind kind = TreeKind::Conifer;
    float height = 12;   // metres, 0.1 to 150
    float crown = 0.3f;  // width of the crown as a share of the height, 0.05 to 2
    int leaves = 2400;   // two triangles each, 1 to 100,000
    glm::vec3 leafColor{0.055f, 0.115f, 0.03f};
    glm::vec3 barkColor{0.11f, 0.085f, 0.065f};
    uint32_t seed = 1;
};
// A tree that stands on the origin, upright. Its vertices lie within half the crown's width of the trunk's foot, seen
// from above, and between the ground and its height.
Mesh growTree(const TreeShape& shape);

// The same tree of fewer triangles: every leaf (a piece of at most `most` triangles that shares no vertex with others)
// is kept or dropped by a hash of its number, and those that are kept are enlarged about their middles, so that
// the area of leaves stays as it is (Cook, Halstead, Planck and Ryu 2007, stochastic simplification). keep: share of
// leaves, in ]0, 1]; 1 gives the mesh itself.
Mesh thinned(const Mesh& mesh, float keep, int most = 4);

}  // namespace sward
