// Light that comes from all around to points of objects, and to the ground beside them, by rays: as much less of the
// sky's as ground and objects hide of it, and what these throw back of sun and sky, in their colours. Linear in sun,
// sky and plain: their colours and strengths may change without tracing anew. Directions are the same for all points,
// so that neighbours differ by what they see alone; where one meets something a path goes on by chance, up to kBounces
// times. What grows on the terrain colours it (world/land.h); trees stand as without wind.
// Does not: light of lamps; grass on objects.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "core/jobs.h"
#include "scene/rows.h"

namespace sward {

// Light from all around on a surface, divided by pi, as factors.
struct AroundFactors {
    glm::vec3 sky{0};     // of FrameGlobals::skyLight
    glm::vec3 sun{0};     // of FrameGlobals::sunLight
    glm::vec3 ground{0};  // of FrameGlobals::groundLight, from the plain beyond the terrain
};
// The light of the frame that they are factors of, each divided by pi.
struct AroundLights {
    glm::vec3 sky{0}, sun{0}, ground{0};
    bool operator==(const AroundLights&) const = default;
};
// Light by these factors, divided by pi.
glm::vec3 lightBy(const AroundFactors& f, const AroundLights& l);
// The share of the open sky's light that is left after such a change; above 1 where more is thrown onto it than hidden.
glm::vec3 shareAfter(const AroundFactors& change, const AroundLights& l);

class AroundTracer {
  public:
    // Takes a copy of the project (maps share their tiles). seconds: scene time of the sun. Errors: a file that cannot
    // be read; Failed without memory or when cancelled.
    static Result<AroundTracer> make(const Project& p, const Tables& tables, double seconds, const JobControl& control);
    // May be moved, not copied.
    AroundTracer(AroundTracer&&) noexcept;
    AroundTracer& operator=(AroundTracer&&) noexcept;
    ~AroundTracer();
    // At a point of a surface, at terrain-relative metres; n: unit; seed: of the paths. From any thread.
    AroundFactors at(const glm::dvec3& position, const glm::vec3& n, uint32_t seed) const;
    // What objects whose light is traced (hasTracedLight, world/placement.h) change of the sky's light on the ground at
    // terrain-relative metres; the place is clamped to the terrain. None where it lies within one of them: no light
    // reaches it. From any thread.
    std::optional<AroundFactors> changeOnGround(double x, double z) const;
    // Of the project's own sun and sky.
    const AroundLights& lights() const;

  private:
    struct Impl;
    explicit AroundTracer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace sward
