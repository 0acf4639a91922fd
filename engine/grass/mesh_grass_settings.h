// Grass on objects: which meshes carry which field's species. A MeshGrass stands beside a StaticMesh; the blades are
// those of a GrassField, a patch repeated over the mesh's texture coordinates instead of over the terrain.
// Does not: draw (grass/mesh_grass.h), or trace (reference/mesh_blades.h).
#pragma once
#include <string>
#include <vector>

#include "mesh/carrier.h"
#include "scene/project.h"
#include "scene/technique.h"

namespace sward {

// Maps lie on the mesh's own texture coordinates, once a unit, and repeat beyond.
struct MeshGrass {
    std::string field;     // entity of the GrassField whose species grow; empty: the first by name
    float uvLength = 0;    // metres that one unit of texture coordinates is; 0: what it is in the mean
    MapField density;      // one channel: share of the species' bladesPerM2; absent: 1 everywhere
    MapField vegetation;   // RGBA: colour (sRGB) and opacity over the blades' own
    MapField orientation;  // two channels: direction along u, v in [0,1] about 0.5; its length is the strength
};
inline constexpr double kMaxMeshBlades = 4e6;  // that the ray-traced truth keeps of all meshes together

// The field's table.
ComponentRow meshGrassRow();

// A mesh that carries a field's grass.
struct GrassyMesh {
    std::string name;  // its entity's
    Entity entity;
    const MeshGrass* grows;
    std::string field;  // its entity's
};
// Of a project, in the order of their names: those with a mesh's file and a field that is there and has blades.
std::vector<GrassyMesh> grassyMeshes(const Project& project);
// Metres in the world that one unit of the carrier's texture coordinates is, of a mesh scaled so.
double uvLengthOf(const MeshGrass& grows, const MeshCarrier& carrier, double scale);
// What drawing and tracing say of an entity's mesh on which nothing can grow.
Error noTextureCoordinates(const std::string& entity, const std::string& file);
// What is said of triangles that stay bare; carrier.unmapped is above 0.
std::string unmappedTriangles(const std::string& file, const MeshCarrier& carrier);
// Whether a field grows on a mesh.
bool growsOnMeshes(const FieldEntity& field);

}  // namespace sward
