// Directions: by their angles, and over a surface by chance. Does not: draw the chance.
#pragma once
#include <cmath>
#include <glm/glm.hpp>

#include "core/numerics.h"

namespace sward {

// Unit, towards an azimuth (radians from +x towards +z) at the sine of its elevation, in [-1, 1].
inline glm::vec3 raised(float azimuth, float sine) {
    const float level = std::sqrt(1 - sine * sine);
    return {level * std::cos(azimuth), sine, level * std::sin(azimuth)};
}

// Unit, on the side of n (unit), as likely as its cosine with n: what diffuse light asks for. share, turn: in [0, 1[.
inline glm::vec3 cosineAround(const glm::vec3& n, float share, float turn) {
    const float angle = f32::kTau * turn, r = std::sqrt(share);
    const glm::vec3 side =
        glm::normalize(std::abs(n.y) < 0.9f ? glm::cross(n, glm::vec3(0, 1, 0)) : glm::cross(n, glm::vec3(1, 0, 0)));
    return glm::normalize(side * (r * std::cos(angle)) + glm::cross(n, side) * (r * std::sin(angle)) +
                          n * std::sqrt(std::max(1 - share, 1e-8f)));
}

}  // namespace sward
