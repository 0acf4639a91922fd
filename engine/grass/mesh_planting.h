// Where blades stand on a mesh: a field's patches, repeated over the mesh's texture coordinates as they are over the
// terrain, thinned by the mesh's own density. The ray-traced truth and what draws blades one by one plant by it, so
// that both have the same blades.
// Does not: pose blades, which wind and paint lean (numerics/stand.h). Cost: 1 us a blade.
#pragma once
#include <array>
#include <functional>
#include <span>

#include "core/jobs.h"
#include "grass/mesh_grass_settings.h"
#include "mesh/carrier.h"
#include "scene/population.h"

namespace sward {

// What is planted on which mesh.
struct MeshPlanting {
    const MeshCarrier& carrier;
    const GrassyMesh& on;
    const GrassField& field;
    double uvLength;  // metres that one unit of texture coordinates is
};
// A triangle in a cell of the patch that it touches; triangle: its first index in the carrier's.
struct CellPart {
    int x, z;
    uint32_t triangle;
    // That by which parts are sorted.
    auto cell() const { return std::pair(x, z); }
};
// Where a blade stands: what the carrier's corners have, mixed, in the mesh's own lengths; not made unit again.
struct MeshRoot {
    glm::dvec3 position, normal, alongU, alongV, bend;
    glm::vec2 uv, inCell;  // inCell: metres
    int cellX, cellZ;
    glm::vec2 mirror;                 // of the cell's version of the patch
    uint32_t blade;                   // of the patch
    std::array<uint32_t, 3> corners;  // of its triangle: the mesh's vertices
    glm::vec2 weights;                // of the first two
    bool edged;                       // its part of the surface has an edge (CarrierVertex::part)
    float density, sownAt;            // of the place; the least at which the blade exists
};

// By cell, those of one cell by triangle. Errors: texture coordinates that run over too many cells.
Result<std::vector<CellPart>> cellsOf(const MeshPlanting& p);
// Calls visit for each blade of a species that the density lets grow, cell by cell. False: cancelled.
bool plantOn(const MeshPlanting& p, std::span<const CellPart> cells, const Species& species, const Patch& patch,
             const JobControl& control, const std::function<void(const MeshRoot&)>& visit);
// Blades that would stand on the mesh at a density of 1.
double bladesAsked(const MeshPlanting& p);

}  // namespace sward
