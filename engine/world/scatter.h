// Where a Scatter's objects stand: darts thrown one after the other, each of which stays where none of those before it
// lies within the distance (random sequential adsorption: no place is favoured). How many darts give the number asked
// for: numerics of its jamming by Ricci, Schaaf and Talbot 1992, within 1%, up to nine tenths of the densest. A dart,
// its turn in the order and all that it becomes are hashes of its cell and number: the same seed gives the same objects
// whoever evaluates what first, and what changes somewhere moves nothing far away. Pure. Does not: read meshes, draw.
// Cost: 1 us a dart, of which an object takes 1 to 30, the more the nearer they stand to the densest.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "scene/project.h"
#include "scene/scatter.h"
#include "world/ground.h"
#include "world/keep_off.h"

namespace sward {

struct ScatteredObject {
    glm::dvec3 at{0};   // its origin in the world
    glm::mat3 turn{1};  // rotation, without the scale
    float scale = 1;
    uint32_t mesh = 0;  // of Scatter::meshes
};
struct Scattering {
    std::vector<ScatteredObject> objects;
    double asked = 0;   // that the density asks for on slopes and heights that are allowed
    uint64_t hash = 0;  // over all objects
};
// Nothing without a terrain, or where more than kMostScattered are asked for. None stands where `off` is in the way.
Scattering scatterOver(const Scatter& scatter, const Ground& ground, const KeepOff& off = {});
// The same of a scatter of the project, which keeps off what the project has.
Scattering scatterIn(const Project& project, const Scatter& scatter, const Ground& ground);

// What to say where fewer stand than nine tenths of those asked for; empty where enough do.
std::string shortfall(const std::string& entity, const Scatter& scatter, const Scattering& made);

// Darts a square metre so that `perM2` objects stay that keep `distance` (m); perM2 at most kDensestScatter /
// distance^2, beyond which it is taken as that.
double dartsFor(double perM2, double distance);

// Every entity's Scatter that asks for objects, in the order of names.
std::vector<std::pair<std::string, const Scatter*>> scattersOf(const Project& p);

// Scatterings by entity, evaluated anew only when the rule or the ground changed.
class ScatterMemory {
  public:
    // `scatter` is the entity's in the project; what is returned is the caller's as long as it likes.
    std::shared_ptr<const Scattering> of(const Project& project, const Ground& ground, const std::string& entity,
                                         const Scatter& scatter);
    // Forgets those of entities that have none any more.
    void keepOnly(const std::vector<std::pair<std::string, const Scatter*>>& all);

  private:
    struct Entry {
        Scatter rule;
        Terrain terrain;
        glm::dvec3 origin{0};
        bool there = false;  // a terrain
        std::string off;     // what it keeps off
        std::shared_ptr<const Scattering> made;
    };
    std::map<std::string, Entry> entries_;
    Footprints outlines_;
};

}  // namespace sward
