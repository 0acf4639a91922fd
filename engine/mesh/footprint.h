// Where a mesh stands on the ground: the outline of what lies below some height, seen from above, as distances to it in
// a raster. Source: Jahrmann and Wimmer 2013, section 5.2 (the outline of the object that presses); distances:
// Felzenszwalb and Huttenlocher 2012. Does not: know the ground, nor what it does to grass (numerics/gust.h
// outlineForce). Every texel that a triangle touches counts as covered, so that the thinnest post leaves a mark: the
// outline is at most 0.8 texels too wide, and distances are off by at most 1.5. A texel is 1/128 of the mesh's longer
// side. Cost: at most 256 KB and a few milliseconds, more for large meshes.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "mesh/mesh.h"

namespace sward {

inline constexpr int kFootprintSide = 256;  // texels along the longer side, of which the mesh takes the middle half

struct Footprint {
    glm::vec2 low{0};              // of the raster: x, z in the turned mesh's units
    float texel = 0;               // its units a texel
    float farthest = 0;            // distance of the farthest place inside the outline from the mesh's origin
    int width = 0, height = 0;     // texels; none: the mesh has nothing so low
    std::vector<float> distances;  // at texels' centres, in its units, rows along x; below 0 inside
    // True if the mesh has nothing so low: nothing presses.
    bool empty() const { return distances.empty(); }
    // The raster's far corner: x, z in the turned mesh's units.
    glm::vec2 high() const { return low + texel * glm::vec2(width, height); }
};
// Of the mesh turned by `turn`: what of it lies at y <= top (infinity: all of it). What is not finite is left out.
Footprint makeFootprint(const Mesh& mesh, const glm::mat3& turn, float top);

// Distance to the outline and its slope (x, z) at a place, as the GPU's program has them: bilinear, the slope over two
// texels. Beyond the raster the distance to it is added.
glm::vec3 outlineAt(const Footprint& footprint, const glm::vec2& place);

}  // namespace sward
