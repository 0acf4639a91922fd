// How bright a linear colour is to the eye (ITU-R BT.709, 2015, item 3.2).
#pragma once
#include <glm/glm.hpp>

namespace sward {

// In the units of the colour, whose channels are linear red, green and blue of BT.709.
inline float luminance(const glm::vec3& c) { return glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }
inline double luminance(const glm::dvec3& c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

}  // namespace sward
