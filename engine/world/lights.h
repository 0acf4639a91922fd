// Which light is the sun, and where lights are at a time. Pure. Does not: say how bright they are (sky/sky.h,
// sky/lamps.h).
#pragma once
#include <glm/glm.hpp>

#include "scene/components.h"

namespace sward {

struct Project;

// The light of sunEntity (scene/components.h); null if there is none.
const Light* sunLight(const Project& project);

// Share of its turn that a light has made after `seconds` of scene time, in [0, 1); 0 if it stands still. Wrapped in
// double, so that it moves as evenly after days as at once (T-3).
double turnOf(const Light& light, double seconds);
// Unit vector towards a directional light.
glm::vec3 directionTo(const Light& light, double seconds);
// Where a point light is whose circle lies around `centre`.
glm::dvec3 placeOf(const Light& light, const glm::dvec3& centre, double seconds);

}  // namespace sward
