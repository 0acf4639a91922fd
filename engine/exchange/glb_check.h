// Whether a .glb is sound, read anew from its bytes: a check of our own, since Khronos' validator does not know
// EXT_mesh_gpu_instancing. Does not: check what the scene is; counts are compared by whoever knows them.
#pragma once
#include <set>
#include <string>

#include "exchange/glb_export.h"

namespace sward {

// Entities whose nodes instance flowers, and objects.
struct GlbNames {
    std::set<std::string> flowers, scatters;
};
// What the file holds, by its nodes. Failed error that names the first fault: what tinygltf refuses; lengths or offsets
// that are no multiples of 4; an accessor that leaves its view, or whose numbers are not finite or not within the least
// and greatest values that it says; positions without those; corners beyond the vertices; instances whose attributes
// differ in number, whose quaternions are not of length 1 (to 1e-4), or whose scale is not above 0. Nodes that instance
// a mesh count as what their name is of, else as blades; other meshes as ground where their node's name has a '/'.
Result<GlbCounts> checkGlb(const std::string& bytes, const GlbNames& names = {});

}  // namespace sward
