// A forest that stands higher or lower than its trees were baked (Forest::verticalScale, the paper's s_z: Decaudin and
// Neyret 2004, section 5): all that light needs is asked of the baked air. What is stretched upwards hides what it hid
// before, along ways that are stretched with it, so that depths through leaves are those along the baked ways; only
// how leaves face is another. (The paper's factor s_z of the path between slices is that for level views; seen from
// above as many leaves lie behind each other as before.)
// Does not: stretch trees (world/forest_stand.h, turnOf) or slices (forest/slicing.h). Pure.
#pragma once
#include <glm/glm.hpp>

#include "mesh/facing.h"

namespace sward {

// The way (unit) through what is baked that a way (unit) takes where it stands `scale` times as high (above 0). At 1
// the same, to the last bit.
glm::dvec3 bakedWay(const glm::dvec3& way, double scale);
// How areas face once all is `scale` times as high: upright ones grow by that, level ones stay. At 1 the same.
Facing stretched(const Facing& facing, float scale);

}  // namespace sward
