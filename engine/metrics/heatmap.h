// A map of errors as a picture: from black over violet and orange to pale yellow, evenly lighter as seen.
// Source of the colours: a path in CIE L*a*b* whose lightness rises linearly from 2 to 97 while its hue turns from
// violet to yellow; chroma is what sRGB holds. Does not: choose the scale.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "metrics/picture.h"

namespace sward {

// sRGB-encoded colour of t in [0,1], clamped.
glm::vec3 heatColor(double t);
// RGB8; `full` is the value that takes the brightest colour. What has no value is green, which the scale has not.
std::vector<uint8_t> heatmap(const ErrorMap& map, double full);

}  // namespace sward
