// Shadows that grass on objects throws onto ground, other objects and what grows there: its surface, as high over the
// mesh as rays that come in almost level meet blades, drawn into the shadow maps by its sides that look away from the
// light. Those lie behind the mesh: what faces the light on the mesh itself, and stands there, is shaded by its own
// means (grass/mesh_grass.h), while the outline that the light sees is the grass's.
// Does not: follow single blades, or the wind. Cost: 1 us a triangle when the mesh, or what grows there, was changed.
#pragma once
#include "frame/draw_context.h"
#include "grass/mesh_grass_settings.h"
#include "world/placement.h"

namespace sward {

struct MeshShadow {
    std::string version;  // of the mesh's file,
    Map density;          // and of what grows there: what this was made of
    float height = 0;
    Buffer vertices, indices;
    VertexArray mesh;
    uint32_t indexCount = 0;
    uint64_t hash = 0;  // of the vertices
    glm::vec3 centre{0};
    float radius = 0;
};
// Share of the height at which almost level rays meet blades where they grow so densely, in [0, 1].
float shadowHeight(float density);
// Brings it up to date. height: metres, where the density is 1; scale: metres that the mesh's unit is. `owner` is
// charged.
void updateMeshShadow(DrawContext& ctx, MeshShadow& s, const char* owner, const MeshCarrier& carrier,
                      const std::string& version, const MapField& density, float height, float scale);
// Adds it to the frame's casters, as number `instance` of `rows`.
void castMeshShadow(DrawContext& ctx, const MeshShadow& s, const PlacedMesh& placed, const Buffer& rows,
                    size_t instance);

}  // namespace sward
