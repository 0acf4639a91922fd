#include "forest/veil.h"

namespace sward {
namespace {

void makeVeil(DrawContext& ctx, const std::string& owner, Veil& veil) {
    const ViewTargets& t = ctx.targets;
    veil.color = makeTexture2D(ctx.gpu, owner, GL_RGBA16F, t.width, t.height);
    veil.nearest = makeTexture2D(ctx.gpu, owner, GL_R32F, t.width, t.height);
    veil.depth = makeTexture2D(ctx.gpu, owner, GL_DEPTH_COMPONENT32F, t.width, t.height);
    veil.target = makeFramebuffer(veil.color.id(), veil.depth.id(), "forest/veil");
    glNamedFramebufferTexture(veil.target.id(), GL_COLOR_ATTACHMENT1, veil.nearest.id(), 0);
    const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glNamedFramebufferDrawBuffers(veil.target.id(), 2, both);
    veil.depthAlone = makeFramebuffer(0, veil.depth.id(), "forest/full");
    if (!veil.noVertices.id()) veil.noVertices = makeVertexArray("forest/veil");
}

// A full-screen pass that writes depth alone.
void drawDepth(const Veil& veil) {
    glBindFramebuffer(GL_FRAMEBUFFER, veil.depthAlone.id());
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    glBindVertexArray(veil.noVertices.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GEQUAL);
    glBindFramebuffer(GL_FRAMEBUFFER, veil.target.id());
}

}  // namespace

bool useVeil(DrawContext& ctx, const VeilPrograms& programs) {
    return ctx.use(programs.full) && ctx.use(programs.over) && ctx.use(programs.behind, depthConstants(ctx.targets));
}

void beginVeil(DrawContext& ctx, const std::string& owner, Veil& veil, const VeilPrograms& programs) {
    const ViewTargets& t = ctx.targets;
    if (veil.color.width != t.width || veil.color.height != t.height) makeVeil(ctx, owner, veil);
    glDisable(GL_BLEND);
    if (ctx.use(programs.behind, depthConstants(t))) {
        glBindTextureUnit(t.samples > 1 ? TEX_DEPTH_SAMPLES : TEX_DEPTH, t.depth.id());
        drawDepth(veil);
    }
    const float nothing[] = {0, 0, 0, 0};
    for (const GLint buffer : {0, 1}) glClearNamedFramebufferfv(veil.target.id(), GL_COLOR, buffer, nothing);
    glEnable(GL_BLEND);
    if (ctx.settings.mode == ViewMode::Overdraw)
        glBlendFunc(GL_ONE, GL_ONE);
    else
        glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    glBlendEquationi(1, GL_MAX);
}

void closeFull(DrawContext& ctx, const Veil& veil, const VeilPrograms& programs) {
    if (!ctx.use(programs.full)) return;
    glBindTextureUnit(TEX_FOREST_VEIL, veil.color.id());
    drawDepth(veil);
}

void endVeil(DrawContext& ctx, const Veil& veil, const VeilPrograms& programs) {
    glBindFramebuffer(GL_FRAMEBUFFER, ctx.targets.scene.id());
    glBlendEquation(GL_FUNC_ADD);
    if (ctx.use(programs.over)) {
        glBindTextureUnit(TEX_FOREST_VEIL, veil.color.id());
        glBindTextureUnit(TEX_FOREST_NEAREST, veil.nearest.id());
        glBlendFunc(GL_ONE, ctx.settings.mode == ViewMode::Overdraw ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
        glBindVertexArray(veil.noVertices.id());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace sward
