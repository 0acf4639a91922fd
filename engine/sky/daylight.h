// What sun, sky, haze and lamps give at a time, as the numbers that shaders read: for drawing, and for the ray-traced
// reference. Pure, but for the sky's sums, which are kept between frames. Does not: draw. Order: sun, then sky (which
// brings both into the camera's balance), then haze; a scene without one leaves it out.
#pragma once
#include <glm/glm.hpp>

#include "shared/frame.h"
#include "shared/light.h"

namespace sward {

struct Project;

// The sky integrated over its half, made anew only when sun or turbidity change.
struct SkySums {
    glm::vec3 sun{2};  // no direction: nothing integrated yet
    float turbidity = 0;
    glm::vec3 level{0};
    glm::vec3 horizon[5]{};  // of horizonLight, numerics/light.h
    float horizonMiddle = 0, horizonScale = 0;
};

// Each reads globals.mode.y, the camera's exposure factor. seconds: scene time.
void addSun(FrameGlobals& globals, const Project& project, double seconds);  // there must be one (world/lights.h)
void addSky(FrameGlobals& globals, const Project& project, double seconds, SkySums& sums);  // there must be a Sky
void addHaze(FrameGlobals& globals, const Project& project);                                // there must be a Fog
// Lights beside the sun, relative to the eye (sky/lamps.h).
LightsGlobals lampsAround(const Project& project, const glm::dvec3& eye, double seconds, float exposure);

}  // namespace sward
