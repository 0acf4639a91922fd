// Where a Scatter's objects do not stand: on the width of paths, on objects that are entities of their own, and within
// a gap beside both. An object counts where it is low over the ground: a tree by its trunk, a lamp on a table not at
// all; its outline is as exact as mesh/footprint.h. Does not: keep objects of one Scatter off those of another.
// Cost: a few milliseconds an object that is new, then under 1 us a place.
#pragma once
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mesh/footprint.h"
#include "scene/ground_path.h"
#include "scene/project.h"
#include "scene/scatter.h"
#include "world/ground.h"

namespace sward {

inline constexpr double kLowM = 0.5;  // metres over the ground up to which an object is in the way

// Places are metres from the terrain's corner along x and z.
struct KeepOff {
    struct Strip {
        GroundCurve curve;
        double half;    // of its width and the gap, metres
        GroundBox box;  // around all of it
    };
    struct Standing {
        std::shared_ptr<const Footprint> outline;
        glm::dvec2 at;
        double scale, reach;  // metres from `at` beyond which it is nowhere
    };
    std::vector<Strip> paths;
    std::vector<Standing> objects;
    double gap = 0;  // metres beside objects

    // Whether nothing may stand at this place.
    bool holds(double x, double z) const;
};

// Footprints by what they were made of, kept from call to call.
using Footprints = std::map<std::string, std::shared_ptr<const Footprint>>;

// What `scatter` of the project keeps off; nothing if it keeps off nothing. Objects whose files cannot be read are left
// out: who draws them says so.
KeepOff keepOffOf(const Project& project, const Ground& ground, const Scatter& scatter, Footprints& outlines);
// What it follows from, as a text: another one, another KeepOff.
std::string keepOffInputs(const Project& project, const Ground& ground, const Scatter& scatter);

}  // namespace sward
