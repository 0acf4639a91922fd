// Light that comes to objects from all around, traced once at the vertices of their meshes: as much less of the sky's
// as ground and other objects hide of it, and what these throw back of sun and sky, in their colours. Techniques draw
// objects, and the grass on them, by it; without it light from all around is as on open level ground, of a meadow.
// Directions are the same for all vertices, so that neighbours differ by what they see alone; where one meets something
// a path goes on by chance, up to kBounces times. What grows on the terrain colours it (world/land.h). Linear in sun,
// sky and plain: their colours and strengths may change without tracing anew.
// Does not: light of lamps; grass on objects, which shades what is below by itself (grass/mesh_grass.h); what rolls;
// meshes of more than kMostLitVertices. Cost on two cores: 1 s for the 32,000 vertices of rockery, 17 s for the 510,000
// of park, most of them of leaves. 36 bytes a vertex in the cache folder, 8 on the GPU.
#pragma once
#include <memory>

#include "core/jobs.h"
#include "scene/rows.h"
#include "world/placement.h"

namespace sward {

inline constexpr size_t kMostLitVertices = 131072;  // of a mesh: a denser one is lit as on open ground

// Light from all around on a surface, divided by pi, as factors.
struct AroundFactors {
    glm::vec3 sky{0};     // of FrameGlobals::skyLight
    glm::vec3 sun{0};     // of FrameGlobals::sunLight
    glm::vec3 ground{0};  // of FrameGlobals::groundLight, from the plain beyond the terrain
};
struct TracedObject {
    Entity entity = kNoEntity;
    std::vector<AroundFactors> vertices;  // as its mesh has them
};
// Objects with the bakeLight "traced" that stay where they are and whose meshes are small enough, in the order of
// placedMeshes. seconds: scene time of the sun; trees stand as without wind. Errors: a file that cannot be read; Failed
// without memory or when cancelled.
Result<std::vector<TracedObject>> traceObjectLight(const Project& p, const Tables& tables, double seconds,
                                                   JobControl& control);
// The same on a single point of a surface, at terrain-relative metres; n: unit.
class AroundTracer {
  public:
    // Takes a copy (maps share their tiles).
    static Result<AroundTracer> make(const Project& p, const Tables& tables, double seconds, const JobControl& control);
    AroundTracer(AroundTracer&&) noexcept;
    AroundTracer& operator=(AroundTracer&&) noexcept;
    ~AroundTracer();
    // From any thread. seed: of the paths.
    AroundFactors at(const glm::dvec3& position, const glm::vec3& n, uint32_t seed) const;

  private:
    struct Impl;
    explicit AroundTracer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

// Row of the effect "objects/light": runs in scenes with Objects that ask for ObjectLight. In the editor it traces
// beside the pictures, and objects are lit as they were until then.
const EffectRow& objectLightEffect();

}  // namespace sward
