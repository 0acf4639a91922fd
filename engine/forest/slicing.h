// How a forest's tiles are cut into slices: the prisms over their ground, parallel slices and such that face the eye
// (Decaudin and Neyret 2004, sections 5 and 6), and as many of them as the distance and the incidence ask.
// Pure. Does not: draw them (forest/texcells.h), or know what fills the volume.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "forest/stand.h"
#include "shared/forest.h"

namespace sward {

// What of a triangle does not change with the view.
struct Prism {
    std::array<glm::dvec3, 3> corner;  // on the ground, in the world
    glm::dvec3 centre{0};
    glm::dvec3 normal{0, 1, 0};  // unit
    double slope = 0;            // metres a metre
    glm::vec2 canopy{1};         // TileInView::canopy
    int rise = FOREST_LEVEL;     // TileInView::rise
    bool usable = true;          // forest may stand there (D-6): it has area, and is no cliff
};
// One a triangle of the stand, in its order.
std::vector<Prism> prismsOf(const ForestHere& here);
// Height of the prism's ground at a place of the world (m).
double planeAt(const Prism& p, const glm::dvec3& at);

// What a tile's slices have to hold: metres over its plane.
struct Reach {
    double low = 1e30, high = -1e30;
};
// How a tile's slices lie.
struct Slicing {
    std::array<double, 3> begin{};  // metres from each corner up to where slices begin
    double reach = 0;               // metres that they span, upwards
    int count = 0;
    int below = 0;      // how many of them lie below the eye: those come downwards, the others upwards
    double weight = 1;  // share of the light's path that they stand for
    bool tilted = false;
};
inline constexpr int kMostSlices = FOREST_MOST_SLICES - 1;  // of a tile

// Parallel to the ground, `slab` metres apart; eye: in the world.
Slicing regularSlices(const Prism& p, const Reach& r, const glm::dvec3& eye, double slab);
// One slice half way up, which shows all that the tile holds: what volumes are held against.
Slicing flatSlice(const Prism& p, const Reach& r, const glm::dvec3& eye);
// Tilted towards the eye, in the forms of numerics/tilt.h. view: from the eye; slant: the most that one rises across
// the tile, in heights of it.
Slicing tiltedSlices(const Prism& p, const Reach& r, const glm::dvec3& view, double slant, double slab);

// The shares of ways to slice a tile, for what they add up to 1. Over some degrees two are there, and the light's path
// is shared: regular and silhouette slices; and, where the eye looks level, silhouette slices as seen from above and
// from below, whose corners lie the slant apart (D-4).
struct SliceShares {
    double regular = 1, fromAbove = 0, fromBelow = 0;
};
SliceShares sliceShares(double silhouetteDeg, const glm::dvec3& normal, const glm::dvec3& view);

// The slabs' level of a tile, from 0 to `last`, a real number: where a slab covers kSlabPixels of what it is seen to
// cover. sine: of the angle at which the ground is seen; from above, slabs hide behind each other.
double levelAt(double slab, double last, double distance, double pixelAt1m, double sine);

}  // namespace sward
