// Light that comes to objects from all around, at their meshes' vertices, as passes read it (lib/object_light.glsl).
// Does not: find it (reference/object_light.h).
#pragma once
#include <map>

#include "frame/draw_context.h"

namespace sward {

struct ObjectLight {
    std::map<uint32_t, uint32_t> first;  // number of an object's first vertex, by Entity::index
    Buffer vertices;                     // uvec2 each: packHalf2x16 of red and green, and of blue
};

// Number of an entity's first vertex; NO_OBJECT_LIGHT: none was found, and light from all around is as on open ground.
uint32_t firstLightOf(const DrawContext& ctx, Entity e);
// Binds the vertices for the draws that follow, in scenes that have them.
void bindObjectLight(const DrawContext& ctx);

}  // namespace sward
