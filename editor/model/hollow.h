// A hollow in the ground, as for a pond: heights lowered in a round bowl, and what grows there thinned to nothing.
// Does not: fill it with water.
#pragma once
#include <glm/glm.hpp>

#include "model/document.h"

namespace sward {

struct Hollow {
    glm::dvec2 middle{0};  // x, z in the world
    double radius = 5;     // metres to its rim
    double depth = 1.2;    // metres below the lowest ground along its rim
    double bareBelow = 0;  // metres, in the terrain's heights: no blade or flower stands lower within the rim
};
// Metres of the lowest ground along a rim, in the terrain's heights: water up to it stays within. middle: x, z relative
// to the terrain's corner; radius in metres.
double lowestAlongRim(const Terrain& t, const glm::dvec2& middle, double radius);
// One undo step. A height map is made where there is none; integer heights become floats. Usage error: the scene has
// no ground, or its heights repeat.
Status digHollow(Document& document, const Hollow& hollow);

}  // namespace sward
