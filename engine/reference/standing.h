// What grows, one by one, as the ray-traced truth poses it: for exporters and whoever counts. No level of detail.
// Positions are metres from the terrain's corner. Does not: colour or draw. Cost: 0.3 us and 56 bytes a blade.
#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "core/jobs.h"
#include "scene/project.h"

namespace sward {

// A blade as it stands in a cell: relative to the cell's corner and to its base height. width 0: it does not exist
// there.
struct Posed {
    glm::vec3 root, control, tip;
    glm::vec2 facing;
    float width, lighter;
};
// On a mesh: relative to the mesh's origin, control and tip in axes of its own (columns: tangent, normal, bitangent).
struct PosedOnMesh {
    Posed blade;
    glm::mat3 axes;
};

// Blades of one species in one cell of the field that have any.
struct StandingCell {
    glm::dvec3 corner{0};
    std::vector<Posed> blades;
};
struct StandingSpecies {
    std::string field;  // entity
    const Species* species = nullptr;
    std::vector<StandingCell> cells;  // rows along z
};
// One species on one mesh.
struct StandingOnMesh {
    std::string entity;  // that holds the mesh
    const Species* species = nullptr;
    glm::dvec3 at{0};  // the mesh's origin
    std::vector<PosedOnMesh> blades;
};
// One that stands: relative to the terrain's corner.
struct StandingFlower {
    glm::vec3 root, stem;
    glm::vec2 facing;
    float half;  // of its head's width
    float second;
    uint32_t kind, grain;  // kind: number in flowersOf (frame/flower_image.h)
};

// What counts: roots within so many metres of a place, seen from above.
struct StandingWithin {
    glm::dvec2 at{0};
    double metres = std::numeric_limits<double>::infinity();
    bool holds(const glm::dvec2& root) const { return glm::distance(at, root) <= metres; }
};

// Every blade of the terrain's fields, as wind and forces bend it at a scene time; `p` must outlive the result. Stops
// with what it has once there are more than `most`. Errors as GrassRays::make.
Result<std::vector<StandingSpecies>> standingBlades(const Project& p, double time, const StandingWithin& within,
                                                    size_t most, JobControl& control);
// Every flower of all kinds. Errors as FlowerRays::make.
Result<std::vector<StandingFlower>> standingFlowers(const Project& p, double time, const JobControl& control);
// Every blade on meshes. Errors as MeshBlades::make.
Result<std::vector<StandingOnMesh>> standingOnMeshes(const Project& p, double time, const JobControl& control);

}  // namespace sward
