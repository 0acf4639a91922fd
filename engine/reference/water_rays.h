// The water's surface as rays meet it: a plane with every ripple, which throws part of the light back and lets the rest
// in, bent. Does not: count from below (light that leaves the water goes straight), nor know what lies in it.
#pragma once
#include <optional>

#include "reference/surface.h"
#include "scene/project.h"
#include "world/water.h"
#include "world/wind.h"

namespace sward {

// Where a ray enters water.
struct WaterMet {
    glm::dvec3 at{0};
    double t = 0;
    glm::vec2 slope{0};
    glm::vec3 normal{0, 1, 0};
    float mirror = 0;                   // share of the light that is thrown back
    double level = 0;                   // of that water,
    glm::vec3 color{0}, extinction{0};  // and what is in it (WaterGlobals)
};

class WaterRays {
  public:
    // Of the project's waters over its terrain, about an eye (relative to the terrain's corner); `p` must outlive them.
    static WaterRays make(const Project& p, double time, const glm::dvec3& eye);
    // A ray that comes down from above and meets the surface before `far`.
    std::optional<WaterMet> enters(const Ray& ray, double far) const;

  private:
    const Terrain* terrain_ = nullptr;
    const Wind* wind_ = nullptr;
    const Map* gusts_ = nullptr;
    Map made_;
    WindGlobals blows_{};
    std::vector<WaterPlace> places_;
    std::vector<WaterGlobals> globals_;  // by place
    glm::dvec3 eye_{0};
};

}  // namespace sward
