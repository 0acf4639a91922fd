// Light that comes to objects from all around, at their meshes' vertices, and what they leave of it on the ground, as
// passes read them (lib/object_light.glsl, lib/ground_around.glsl).
// Does not: find it (reference/object_light.h).
#pragma once
#include <map>

#include "frame/draw_context.h"

namespace sward {

struct ObjectLight {
    std::map<uint32_t, uint32_t> first;  // number of an object's first vertex, by Entity::index
    Buffer vertices;                     // uvec2 each: packHalf2x16 of red and green, and of blue
    Texture ground, cells;               // PackedGround::share and ::table (reference/ground_around.h); none: nothing
    glm::ivec2 from{0}, to{0};           // where its cells lie
    uint32_t slots = 0;                  // of the table
};

// Number of an entity's first vertex; NO_OBJECT_LIGHT: none was found, and light from all around is as on open ground.
uint32_t firstLightOf(const DrawContext& ctx, Entity e);
// Binds the vertices for the draws that follow, in scenes that have them.
void bindObjectLight(const DrawContext& ctx);

}  // namespace sward
