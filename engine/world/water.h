// Which water stands in the scene, and its ripples: one evaluation for shaders and for the reference.
// Formulas: shaders/numerics/water.h. Places are metres relative to the terrain's corner. Does not: draw.
#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "scene/project.h"
#include "shared/water.h"
#include "world/ground.h"

namespace sward {

// A Water and the round place over which it stands where the ground is lower.
struct WaterPlace {
    const Water* water = nullptr;
    glm::dvec2 middle{0};                                     // x, z
    double radius = std::numeric_limits<double>::infinity();  // metres; infinite: over the whole terrain
};
// Every Water of the project, the lowest first. `p` must outlive what is returned.
std::vector<WaterPlace> watersOf(const Project& p, const Ground& ground);
// Whether x, z are within the place.
bool within(const WaterPlace& place, double x, double z);

// As shaders read it, but for low, high, what is mirrored and what hides it. eye: relative to the terrain's corner.
// wind: null in a calm, where every wave is 0. seconds: scene time, of any age. Waves: lengths from rippleSize down to
// a twentieth of it, up to 70 degrees off the wind, by the law of deep water (speed^2 = g / wave number); mean square
// of all slopes as Cox and Munk 1954 measured it on the open sea, 0.003 + 0.00512 speed, times the square of `ripples`.
// Extinction: pure water's (Pope and Fry 1997, at 610, 550 and 465 nm) and as much more, equal for all colours, as
// `clarity` says.
WaterGlobals waterGlobals(const WaterPlace& place, const Wind* wind, const glm::dvec3& eye, double seconds);

// Tells `g`, made of places[which], the terrain's place and which waters hide it: an eye sees the surface that its ray
// meets first, the higher one where two stand over each other, and of two as high the first. Of more than WATER_COVERS
// those that lie nearest. eye: as in waterGlobals.
void setCovers(WaterGlobals& g, const std::vector<WaterPlace>& places, size_t which, const Terrain& terrain,
               const glm::dvec3& eye);

// Slope (m per m) of the surface at x, z relative to the eye of `g`; share: rippleShare of the wind there.
glm::vec2 waterSlope(const WaterGlobals& g, const glm::vec2& at, float share);

}  // namespace sward
