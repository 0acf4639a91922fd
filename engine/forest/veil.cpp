#include "forest/veil.h"

namespace sward {
namespace {

void fullScreen() { glDrawArrays(GL_TRIANGLES, 0, 3); }

}  // namespace

void beginVeil(DrawContext& ctx, const std::string& owner, Veil& veil) {
    const ViewTargets& t = ctx.targets;
    const GLuint depthBefore = veil.depth.texture.id();
    copyDepth(ctx, owner, veil.depth);
    if (veil.depth.texture.id() != depthBefore || veil.color.width != t.width || veil.color.height != t.height ||
        veil.samples != t.samples) {
        veil.color = t.samples > 1 ? makeTexture2DMultisample(ctx.gpu, owner, GL_RGBA16F, t.width, t.height, t.samples)
                                   : makeTexture2D(ctx.gpu, owner, GL_RGBA16F, t.width, t.height);
        veil.samples = t.samples;
        veil.target = makeFramebuffer(veil.color.id(), veil.depth.texture.id(), "forest/veil");
        veil.depthAlone = makeFramebuffer(0, veil.depth.texture.id(), "forest/full");
    }
    if (!veil.noVertices.id()) veil.noVertices = makeVertexArray("forest/veil");
    const float nothing[] = {0, 0, 0, 0};
    glClearNamedFramebufferfv(veil.target.id(), GL_COLOR, 0, nothing);
    glBindFramebuffer(GL_FRAMEBUFFER, veil.target.id());
    glEnable(GL_BLEND);
    if (ctx.settings.mode == ViewMode::Overdraw)
        glBlendFunc(GL_ONE, GL_ONE);
    else
        glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    glDepthMask(GL_FALSE);
}

void closeFull(DrawContext& ctx, const Veil& veil, size_t program) {
    if (!ctx.use(program, depthConstants(ctx.targets))) return;
    glBindFramebuffer(GL_FRAMEBUFFER, veil.depthAlone.id());
    glBindTextureUnit(veil.samples > 1 ? TEX_FOREST_VEIL_SAMPLES : TEX_FOREST_VEIL, veil.color.id());
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    glBindVertexArray(veil.noVertices.id());
    fullScreen();
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GEQUAL);
    glBindFramebuffer(GL_FRAMEBUFFER, veil.target.id());
}

void endVeil(DrawContext& ctx, const Veil& veil, size_t program) {
    glBindFramebuffer(GL_FRAMEBUFFER, ctx.targets.scene.id());
    if (ctx.use(program, depthConstants(ctx.targets))) {
        glBindTextureUnit(veil.samples > 1 ? TEX_FOREST_VEIL_SAMPLES : TEX_FOREST_VEIL, veil.color.id());
        glBlendFunc(GL_ONE, ctx.settings.mode == ViewMode::Overdraw ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
        glDisable(GL_DEPTH_TEST);
        glBindVertexArray(veil.noVertices.id());
        fullScreen();
        glEnable(GL_DEPTH_TEST);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace sward
