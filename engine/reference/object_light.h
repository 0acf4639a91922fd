// Light that comes to objects from all around, traced once at the vertices of their meshes, and what they change of it
// on the ground about them (reference/around_tracer.h, reference/ground_around.h). Techniques draw objects, the grass
// on them, the ground and what grows there by it; without it light from all around is as on open level ground, of a
// meadow. Does not: light of lamps; grass on objects, which shades what is below by itself (grass/mesh_grass.h); what
// rolls; meshes of more than kMostLitVertices. Cost on two cores: 1 s for the 32,000 vertices of rockery, 17 s for the
// 510,000 of park, most of them of leaves. 36 bytes a vertex in the cache folder, 8 on the GPU.
#pragma once
#include "reference/ground_around.h"

namespace sward {

inline constexpr size_t kMostLitVertices = 131072;  // of a mesh: a denser one is lit as on open ground

struct TracedObject {
    Entity entity = kNoEntity;
    std::vector<AroundFactors> vertices;  // as its mesh has them
};
struct TracedAround {
    std::vector<TracedObject> objects;  // of all that hasTracedLight (world/placement.h), in the order of placedMeshes;
                                        // those with too many vertices have none
    std::vector<GroundTile> ground;
};
// seconds: scene time of the sun; trees stand as without wind. Errors: a file that cannot be read; Failed without
// memory or when cancelled.
Result<TracedAround> traceObjectLight(const Project& p, const Tables& tables, double seconds, JobControl& control);
// Row of the effect "objects/light": runs in scenes with Objects that ask for ObjectLight. In the editor it traces
// beside the pictures, and objects are lit as they were until then.
const EffectRow& objectLightEffect();

}  // namespace sward
