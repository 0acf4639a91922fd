// A mesh as the carrier of a shell of grass (Habel, Wimmer and Jeschke 2007, section 3): at each vertex the frame in
// which the shell stands, how fast texture coordinates run along the surface, and how the surface bends.
// Frames: hard case H-6. Tangents follow the texture coordinates; where these have no direction, the normal alone gives
// a frame. What two triangles of different handedness share (mirrored texture coordinates) is split. Triangles that
// have no area in texture coordinates, or none in space, carry nothing. Along edges where the surface ends, or breaks
// off to another normal, the shell has a wall, a skirt, so that one sees its grass from the side.
// Does not: place the mesh, or know which grass grows. Cost: about 1 us a triangle, once a file; 110 bytes a vertex.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "mesh/mesh.h"

namespace sward {

// Lengths are the mesh's own. The shell reaches from lift 0, the surface, to lift 1.
struct CarrierVertex {
    glm::vec3 position;
    glm::vec3 normal;  // unit
    glm::vec2 uv;
    glm::vec3 alongU, alongV;  // in the surface: by how much u and v grow, a length; never 0
    glm::vec3 bend;            // curvature (1 / length; above 0: like a ball's outside) along the tangent, mixed, along
                               // the bitangent of carrierFrame: the mean over some edges around
    float lift = 1;
    glm::vec4 chart{0};  // of the part of the texture coordinates that hangs together with it: least u, v, greatest
    uint32_t of = 0;     // the mesh's vertex that it was
    float part = 0;      // number, from 1, of the part of the surface that goes on smoothly; below 0: it has an edge
};
struct MeshCarrier {
    std::vector<CarrierVertex> vertices;
    std::vector<uint32_t>
        indices;                  // three a triangle, counter-clockwise from outside: first the surface's, then skirts'
    size_t surface = 0;           // of the indices
    size_t parts = 0;             // of the surface
    double area = 0, uvArea = 0;  // of the triangles that carry
    size_t unmapped = 0, mirrored = 0;  // triangles without area in texture coordinates; of the other handedness
    std::vector<std::pair<glm::vec3, glm::vec3>>
        boxes;  // least and greatest of each kBoxIndices of the surface's indices
};
inline constexpr size_t kBoxIndices = 3 * 64;
MeshCarrier carrierOf(const Mesh& mesh);
// The surface's vertex nearest to a point: what its corners have, mixed (the chart and part are the triangle's). Of a
// carrier that carries something.
CarrierVertex nearestOn(const MeshCarrier& carrier, const glm::vec3& point);

// The shell's own axes: unit, square to the normal and to each other. A mirrored carrier's bitangent points the other
// way round.
struct CarrierFrame {
    glm::vec3 tangent, bitangent;
};
CarrierFrame carrierFrame(const glm::vec3& normal, const glm::vec3& alongU, const glm::vec3& alongV);
// Lengths of the mesh that one unit of texture coordinates is in the mean; 0 where nothing carries.
double lengthOfUv(const MeshCarrier& carrier);

}  // namespace sward
