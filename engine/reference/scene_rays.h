// A project as triangles for rays: its terrain and the objects that cast shadows.
// Does not: grass; what an image's alpha cuts out of an object counts as there.
// Positions are relative to the terrain's corner (to the world's origin without a terrain).
#pragma once
#include <optional>

#include "core/jobs.h"
#include "mesh/mesh.h"
#include "reference/ray_scene.h"
#include "scene/project.h"

namespace sward {

// The terrain in squares of two triangles, at most 1024 a side: the surface that rays meet, and on which points lie
// exactly.
struct TerrainSurface {
    glm::dvec2 size{1};
    int quadsX = 1, quadsZ = 1;
    std::vector<float> heights;  // (quadsX + 1) x (quadsZ + 1), z rows
    // The point of the triangles at terrain-relative metres, clamped to the terrain.
    glm::vec3 at(double x, double z) const;
    glm::vec3 normalAt(double x, double z) const;  // by central differences over a square; upward
    Triangles triangles() const;
};
// Heights at the corners of the squares; level ground is one square.
TerrainSurface terrainSurface(const Terrain& t);

// Objects of all Scatters, then trees of all Forests, and what each shows.
struct ScatteredTriangles {
    std::vector<std::string> files;  // of `instances.meshes`
    std::vector<Mesh> meshes;        // the same with their vertices' other parts
    TriangleInstances instances;
    std::vector<std::vector<float>> through;  // of each part of its meshes: light that shines through its leaves, as
                                              // a share of what is reflected; none: no light does
    std::vector<bool> casts;                  // by instance
    size_t firstTree = 0;                     // of the instances: from it on they are trees
};
// Those that cast shadows alone, or all. origin: of the positions, in the world. time: scene time (s) at which wind
// leans the trees; none: they stand upright. Errors: a file that cannot be read.
Result<ScatteredTriangles> scatteredTriangles(const Project& p, const glm::dvec3& origin, bool castersAlone,
                                              std::optional<double> time = std::nullopt);

struct SceneTriangles {
    std::vector<Triangles> meshes;
    TriangleInstances scattered;
};
// What of a project is made into triangles: all, or without objects whose light is traced (hasTracedLight).
enum class SolidsTaken { All, WithoutTraced };
// The terrain (if it is not level) and every object that casts shadows. An object's file is read from the project's
// folder. Errors: a file that cannot be read; Failed when cancelled.
Result<SceneTriangles> sceneTriangles(const Project& p, const JobControl& control,
                                      SolidsTaken taken = SolidsTaken::All);

// Names what sceneTriangles would make, by content: terrain, objects' places and the times of their files.
uint64_t sceneTrianglesHash(const Project& p, SolidsTaken taken = SolidsTaken::All);

}  // namespace sward
