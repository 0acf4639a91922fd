// Rays through all fields of grass: every blade that the maps call for, posed and coloured where it stands by the
// shared numerics, met exactly (numerics/ribbon.h). No level of detail, no fading: a blade exists where the density
// reaches its threshold. How: a field repeats a patch, but paint and clumps lean each copy's blades another way. Embree
// holds one scene of boxes a patch, wide enough for every lean within a class (prefix of thresholds, mean lean,
// spread); a blade is posed when a ray meets its box, kept for a while, and tested in closed form. Cells that many rays
// ask for get boxes of their own (posed_cells.h), up to a budget. So memory does not grow with the field, and a cell
// seen once costs what was seen. Does not: ground, objects, light. Cost: 2 to 10 us a ray.
#pragma once
#include <memory>
#include <optional>

#include "core/jobs.h"
#include "reference/surface.h"
#include "scene/population.h"
#include "scene/project.h"
#include "world/ground.h"

namespace sward {

// What a thread remembers of cells and blades between rays: about 16 MB.
struct GrassMemory {
    GrassMemory();
    ~GrassMemory();
    struct Tables;
    std::unique_ptr<Tables> tables;
};

struct RayField;
// Of a scene's fields in the order of their names, those whose bits are set (FieldBits{1} << number).
using FieldBits = uint32_t;
inline constexpr FieldBits kAllFields = ~FieldBits{0};

class GrassRays {
  public:
    // Of all of the project's fields as its wind bends them at a scene time; `p` must outlive it. A project without
    // grass or terrain has rays that meet nothing. Failed without memory or when cancelled; Unsound if there are too
    // many.
    static Result<GrassRays> make(const Project& p, double time, const JobControl& control);
    GrassRays(GrassRays&&) noexcept;
    GrassRays& operator=(GrassRays&&) noexcept;
    ~GrassRays();
    // From any thread, each with a memory of its own.
    std::optional<Surface> closest(const Ray& ray, GrassMemory& memory) const;
    // Whether a blade of one of these fields is in the ray's way.
    bool blocks(const Ray& ray, GrassMemory& memory, FieldBits of = kAllFields) const;
    // Share of light from `towards` (unit) that the grass of these fields leaves to soil of this normal at a place (a
    // share of the terrain) in the mean, as shaders have it where they draw no shadows (grass/appearance.h).
    float lightLeft(const glm::dvec2& place, const glm::vec3& towards, const glm::vec3& normal,
                    FieldBits of = kAllFields) const;

  private:
    GrassRays();
    std::vector<std::unique_ptr<RayField>> fields_;
};

// --- for tests: what a scene of boxes promises
// Low and high corner, relative to the root, of what a blade can reach when its lean is within `spread` (m per m) of
// `lean` and its scale within `scale` of 1; all in the patch's own frame.
std::pair<glm::vec3, glm::vec3> leaningBounds(const Blade& blade, const glm::vec2& lean, float spread, float scale);

}  // namespace sward
