#include "frame/object_light.h"

#include "shared/objects.h"

namespace sward {

uint32_t firstLightOf(const DrawContext& ctx, Entity e) {
    if (!ctx.shared.objectLight) return NO_OBJECT_LIGHT;
    const auto found = ctx.shared.objectLight->first.find(e.index);
    return found == ctx.shared.objectLight->first.end() ? NO_OBJECT_LIGHT : found->second;
}

void bindObjectLight(const DrawContext& ctx) {
    if (ctx.shared.objectLight && ctx.shared.objectLight->vertices.id())
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_OBJECT_LIGHT, ctx.shared.objectLight->vertices.id());
}

}  // namespace sward
