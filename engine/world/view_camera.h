// A camera as pictures are taken from it, and what it sees of the ground. Pure. Does not: project or draw.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "scene/project.h"

namespace sward {

struct Ground;  // world/ground.h

// Where a picture is taken from. Positions are doubles: the GPU only sees differences to the eye.
struct ViewCamera {
    glm::dvec3 eye{0, 2, 0};
    glm::dvec3 target{0, 0, 1};
    float fovDeg = 55;
    float exposure = 0;
};

// The camera entity named so, or the first; null if there is none.
const Camera* findCamera(const Project& p, const std::string& name);
ViewCamera viewOf(const Camera& c);
// The ground under a window position (pixels from the top left), or nothing (sky).
std::optional<glm::dvec3> pickGround(const Project& p, const ViewCamera& c, int width, int height, double px,
                                     double py);
// The same on other ground than the scene's, such as it was before.
std::optional<glm::dvec3> pickGround(const Ground& ground, const ViewCamera& c, int width, int height, double px,
                                     double py);

}  // namespace sward
