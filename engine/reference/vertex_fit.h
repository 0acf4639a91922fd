// Numbers at a mesh's vertices that come nearest, over its surface, to what was found at points of it: what lies
// between vertices counts, too, and a wall of four corners under a roof is as bright as its middle (Kavan, Bargteil and
// Sloan 2011, "Least squares vertex baking"). Does not: find anything. Cost: about 20 us a point.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace sward {

struct SurfacePoint {
    uint32_t triangle = 0;  // its first index in Mesh::indices
    glm::vec3 weights{0};   // of its corners; their sum is 1
    float counts = 1;       // how much a difference here counts
};
// As many points spread over a mesh by area; none where it has no area. The same seed gives the same points.
std::vector<SurfacePoint> pointsOver(const Mesh& mesh, size_t count, uint32_t seed);
double surfaceArea(const Mesh& mesh);  // of all triangles, in the mesh's own lengths, squared

// What is fitted: so many numbers at a place.
using FittedRow = std::array<float, 9>;
// One row a vertex, from one row a point: the least sum over the points of squared differences to what is mixed there
// of the corners', each as it counts, and over the edges of a twentieth of the squared differences of their ends, by
// which vertices without points near by have their neighbours' rows. Vertices of one place and normal have one row.
// Rows of 0 without points.
std::vector<FittedRow> fitVertices(const Mesh& mesh, std::span<const SurfacePoint> points,
                                   std::span<const FittedRow> found);

}  // namespace sward
