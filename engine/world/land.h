// The land beyond the terrain (Terrain.beyond): where it lies and what it sends, for drawing and for the truth. Its
// heights are those at the terrain's edge, and its colours those of soil and of grass as a dense canopy sends light;
// with `fade` both come to the terrain's mean over a quarter of its longer side. Maps that repeat go on repeating and
// do not fade. Does not: blades, flowers, water, trees; hills' shadows; hands and feet, which find the edge's height
// there. Cost: 0.2 ms to sum the means; drawn, some 50 to 150 nodes of the ground.
#pragma once
#include <span>

#include "scene/project.h"
#include "world/ground.h"

namespace sward {

inline constexpr double kLandReach =
    20000;  // metres beyond the edges: in clear air a hundredth of a degree below level

struct Land {
    double reach = 0;    // metres beyond the terrain's edges; 0: there is none
    float fade = 0;      // 1 / metres over which the mean comes; 0: it does not
    float level = 0;     // the edges' mean height, metres from the terrain's origin
    glm::vec3 mean{0};   // reflectance of most of the terrain, with what grows there
    glm::vec3 grass{0};  // of a dense canopy of its grass
};
// Of the project's terrain; reach 0 where there is none, or where its `beyond` is none.
Land landOf(const Project& p);
// Reflectance of ground whose soil is of this colour, at terrain-relative metres, with what grows there.
glm::vec3 groundSends(const Terrain& t, std::span<const GrassField* const> fields, double x, double z,
                      const glm::vec3& soil);
// Height at terrain-relative metres, beyond the edges too.
double landHeight(const Terrain& t, const Land& land, double x, double z);

}  // namespace sward
