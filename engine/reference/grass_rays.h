// Rays through a field: every blade that the maps call for, posed and coloured where it stands by the shared numerics,
// met exactly (numerics/ribbon.h). No level of detail, no fading: a blade exists where the density reaches its
// threshold. How: a field repeats a patch, but paint and clumps lean each copy's blades another way. Embree holds one
// scene of boxes a patch, wide enough for every lean within a class (prefix of thresholds, mean lean, spread); a blade
// is posed when a ray meets its box, kept for a while, and tested in closed form. So memory does not grow with the
// field, and a cell seen once costs what was seen. Does not: ground, objects, light. Cost: 2 to 10 us a ray.
#pragma once
#include <memory>
#include <optional>

#include "core/jobs.h"
#include "reference/surface.h"
#include "scene/population.h"
#include "scene/project.h"
#include "world/ground.h"

namespace sward {

// What a thread remembers of cells and blades between rays: about 12 MB.
struct GrassMemory {
    GrassMemory();
    ~GrassMemory();
    struct Tables;
    std::unique_ptr<Tables> tables;
};

struct RayField;

class GrassRays {
  public:
    // Of the project's first GrassField as its wind bends it at a scene time; `p` must outlive it. A project without
    // grass or terrain has rays that meet nothing. Failed without memory or when cancelled.
    static Result<GrassRays> make(const Project& p, double time, const JobControl& control);
    GrassRays(GrassRays&&) noexcept;
    GrassRays& operator=(GrassRays&&) noexcept;
    ~GrassRays();
    // From any thread, each with a memory of its own.
    std::optional<Surface> closest(const Ray& ray, GrassMemory& memory) const;
    bool blocks(const Ray& ray, GrassMemory& memory) const;
    // Share of light from this elevation that grass at a place (a share of the terrain) leaves to the soil in the mean,
    // as shaders have it where they draw no shadows (grass/appearance.h).
    float lightLeft(const glm::dvec2& place, float sinElevation) const;

  private:
    explicit GrassRays(std::unique_ptr<RayField> field);
    std::unique_ptr<RayField> field_;
};

// --- for tests: what a scene of boxes promises
// Low and high corner, relative to the root, of what a blade can reach when its lean is within `spread` (m per m) of
// `lean` and its scale within `scale` of 1; all in the patch's own frame.
std::pair<glm::vec3, glm::vec3> leaningBounds(const Blade& blade, const glm::vec2& lean, float spread, float scale);

}  // namespace sward
