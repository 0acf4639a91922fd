// Flowers as rays meet them: every one that the maps call for, with no level of detail, by the formulas that shaders
// use (numerics/flower.h). A flower turns to whoever looks, so each ray meets it as it looks from there. Does not:
// shade. Cost: 64 bytes a flower and Embree's boxes, about as much again; 1 to 2 us a ray.
#pragma once
#include <memory>
#include <optional>

#include "core/jobs.h"
#include "reference/surface.h"
#include "scene/project.h"

namespace sward {

inline constexpr size_t kMostRayFlowers = 8'000'000;

struct RayFlowers;
class FlowerRays {
  public:
    // As wind and forces bend them at a scene time; `p` must outlive it. Without flowers or terrain rays meet nothing.
    // Failed: more than kMostRayFlowers, no memory, cancelled.
    static Result<FlowerRays> make(const Project& p, double time, const JobControl& control);
    FlowerRays(FlowerRays&&) noexcept;
    FlowerRays& operator=(FlowerRays&&) noexcept;
    ~FlowerRays();
    // From any thread.
    std::optional<Surface> closest(const Ray& ray) const;
    bool blocks(const Ray& ray) const { return closest(ray).has_value(); }

  private:
    explicit FlowerRays(std::unique_ptr<RayFlowers> flowers);
    std::unique_ptr<RayFlowers> flowers_;
};

}  // namespace sward
