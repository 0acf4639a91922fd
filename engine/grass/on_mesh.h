// What all that draws grass on meshes has in common: the field that grows there, the mesh's own maps, and the place of
// the mesh. Does not: draw (grass/mesh_grass.h: by rays; grass/mesh_geometry.h: blade by blade).
#pragma once
#include <string>

#include "frame/draw_context.h"
#include "grass/field.h"
#include "grass/mesh_grass_settings.h"

namespace sward {

// Textures of a MeshGrass's maps, 0: it has none; and what programs are compiled for that draw with them.
struct MeshMaps {
    GLuint density = 0, vegetation = 0, orientation = 0;
    std::string features;  // featureConstants
};
// Those of a mesh on which a field grows. blades: near ones are drawn one by one.
MeshMaps mapsOn(DrawContext& ctx, const Field& field, const GrassyMesh& on, bool blades);
// Binds those that there are, over the field's own.
void bindMaps(const MeshMaps& maps);

// The field of that name in this view; null: there is none.
const Field* fieldNamed(const DrawContext& ctx, const std::string& name);

// Where a mesh stands: rows that take it to positions relative to the eye, and metres that its unit is.
struct MeshPlace {
    glm::vec4 rows[3] = {};
    float scale = 1;
    // Of a place in the mesh, relative to the eye.
    glm::vec3 operator()(const glm::vec3& at) const;
    // Of a direction in the mesh, unit.
    glm::vec3 turned(const glm::vec3& way) const;
    // Sets uniforms 10 to 12 to the rows, and 13 to the scale.
    void set() const;
};
// That of an entity's StaticMesh in this view, where the object is drawn.
MeshPlace placeOn(const DrawContext& ctx, Entity mesh);

// Whether all blades of a mesh are few enough to be drawn one by one: asked: bladesAsked (grass/mesh_planting.h).
inline constexpr double kMostDrawnOnMesh = 1e6;
// Whether a field's blades on a mesh are drawn one by one where they are near.
inline bool drawsBladesOn(const Field& field, double asked) {
    return field.draws(Feature::GrassMeshGeometry) && asked <= kMostDrawnOnMesh;
}

}  // namespace sward
