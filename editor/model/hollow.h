// A hollow in the ground, as for a pond: heights lowered in a round bowl, and what grows there thinned to nothing.
// Does not: fill it with water.
#pragma once
#include <glm/glm.hpp>
#include <span>

#include "model/document.h"
#include "world/water.h"

namespace sward {

struct Hollow {
    glm::dvec2 middle{0};  // x, z in the world
    double radius = 5;     // metres to its rim
    double floor = -1.2;   // metres, in the terrain's heights, of its middle; lower ground stays as low as it is
    double bareBelow = 0;  // metres, in the terrain's heights: no blade or flower stands lower within the rim
};
// The lowest place along a rim: water up to it stays within.
struct RimLow {
    double height = 0;  // metres, in the terrain's heights: of the ground, or of the water that stands over it
    bool wet = false;   // water stands there
};
// middle: x, z relative to the terrain's corner; radius in metres.
RimLow lowestAlongRim(const Terrain& t, std::span<const WaterPlace> waters, const glm::dvec2& middle, double radius);
// One undo step. A height map is made where there is none; integer heights become floats. Usage error: the scene has
// no ground, or its heights repeat.
Status digHollow(Document& document, const Hollow& hollow);

}  // namespace sward
