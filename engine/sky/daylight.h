// What sun, sky, haze and lamps give at a time, as the numbers that shaders read: for drawing, and for the ray-traced
// reference. Pure, but for the sky's sums and tables, which are kept between frames. Does not: draw. Order: sun, haze,
// air (of a Sky of the model "atmosphere"), then sky, which brings sun and sky into the camera's balance; a scene
// without one leaves it out.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "shared/frame.h"
#include "shared/light.h"

namespace sward {

struct Project;
struct AirTables;

// The sky integrated over its half, made anew only when sun, turbidity or air change.
struct SkySums {
    glm::vec3 sun{2};  // no direction: nothing integrated yet
    float turbidity = 0;
    unsigned airChanges = 0;  // of the tables that it was made from
    glm::vec3 level{0};
    glm::vec3 tilt{0};  // how much brighter it is towards the horizon: as skyTilted has it, a colour each
    // Irradiance, divided by pi, of the glow around the sun on what faces it; all else of the sky is taken to be even.
    glm::vec3 glow{0};
    glm::vec3 horizon[5]{};  // of horizonLight, numerics/light.h
    float horizonMiddle = 0, horizonScale = 0;
};

// Radiance of a sky of tilt 1 at a sine of elevation, less that of an even one: both light level ground alike. A sky of
// level L and tilt t is taken to be L (1 + t skyTilted(y)): what stands upright has more light of it than of an even
// sky. t is chosen so that upright leaves among others have, in the mean, what they have of the sky; in [-1.5, 3].
inline float skyTilted(float sine) { return 2.0f / 3.0f - sine; }

// Each reads globals.mode.y, the camera's exposure factor. seconds: scene time.
void addSun(FrameGlobals& globals, const Project& project, double seconds);  // there must be one (world/lights.h)
void addHaze(FrameGlobals& globals, const Project& project);                 // there must be a Fog
void addAir(FrameGlobals& globals, const Project& project, double seconds, AirTables& tables);
// There must be a Sky; air: what addAir made, null for another model of sky.
void addSky(FrameGlobals& globals, const Project& project, double seconds, SkySums& sums, const AirTables* air);
// Illuminance (klx) of a sun in that direction on what faces it, as the sky's model has it, before the Light's own
// factors.
glm::vec3 sunKlx(const Project& project, const glm::vec3& sun);
// Lights beside the sun, relative to the eye (sky/lamps.h).
LightsGlobals lampsAround(const Project& project, const glm::dvec3& eye, double seconds, float exposure);
// Where they are in the world, in that order; of directional lights: unit vectors towards them.
std::vector<glm::dvec3> lampPlaces(const Project& project, double seconds);

}  // namespace sward
