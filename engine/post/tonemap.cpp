#include "post/tonemap.h"

#include "frame/draw_context.h"

namespace sward {
namespace {

void resolve(DrawContext& ctx) {
    const ViewTargets& t = ctx.targets;
    if (t.samples > 1)
        glBlitNamedFramebuffer(t.scene.id(), t.resolve.id(), 0, 0, t.width, t.height, 0, 0, t.width, t.height,
                               GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void fullScreen(DrawContext& ctx) {
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

void bindView(const ViewTargets& t) {
    static_assert(TEX_DEPTH == TEX_SCENE + 1 && TEX_DEPTH_SAMPLES == TEX_SCENE + 2);
    const GLuint textures[] = {t.resolved.id(), t.samples > 1 ? 0 : t.depth.id(), t.samples > 1 ? t.depth.id() : 0};
    glBindTextures(TEX_SCENE, 3, textures);
}

void drawTonemap(DrawContext& ctx) {
    glBindFramebuffer(GL_FRAMEBUFFER, ctx.targets.final.id());
    if (!ctx.use(0, depthConstants(ctx.targets))) return;
    bindView(ctx.targets);
    fullScreen(ctx);
}

void drawDecal(DrawContext& ctx) {
    if (ctx.settings.decal.radius <= 0 || !ctx.use(0, depthConstants(ctx.targets))) return;
    bindView(ctx.targets);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    fullScreen(ctx);
    glDisable(GL_BLEND);
}

const ProgramRow kTonemapPrograms[] = {
    {"post/tonemap", "post/fullscreen.vert.glsl", "post/tonemap.frag.glsl", nullptr, depthVariants}};
const ProgramRow kDecalPrograms[] = {
    {"post/decal", "post/fullscreen.vert.glsl", "post/decal.frag.glsl", nullptr, depthVariants}};
const Pass kTonemapPasses[] = {{"post/resolve",
                                Stage::Post,
                                kViewMain | kViewReflection,
                                {.reads = {Slot::SceneColor}, .writes = {Slot::Resolved}},
                                {},
                                resolve},
                               {"post/tonemap",
                                Stage::Post,
                                kViewMain,
                                {.reads = {Slot::Resolved, Slot::SceneDepth}, .writes = {Slot::Image}},
                                kTonemapPrograms,
                                drawTonemap}};
const Pass kDecalPasses[] = {{"post/decal",
                              Stage::Decal,
                              kViewMain,
                              {.reads = {Slot::SceneDepth, Slot::Image}, .writes = {Slot::Image}},
                              kDecalPrograms,
                              drawDecal}};

}  // namespace

const EffectRow& tonemapEffect() {
    static const EffectRow row{"post/tonemap", {},      {},
                               kTonemapPasses, nullptr, "every picture needs its light brought to the screen"};
    return row;
}
const EffectRow& decalEffect() {
    static const EffectRow row{"post/decal", featureSet(Feature::Terrain),      {}, kDecalPasses,
                               nullptr,      "shows what the brush would touch"};
    return row;
}

}  // namespace sward
