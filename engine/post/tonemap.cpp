#include "post/tonemap.h"

#include "frame/draw_context.h"

namespace sward {
namespace {

void resolve(DrawContext& ctx) {
    const ViewTargets& t = ctx.targets;
    glDisable(GL_DEPTH_TEST);
    if (t.samples > 1) glBlitNamedFramebuffer(t.scene.id(), t.resolve.id(), 0, 0, t.width, t.height, 0, 0, t.width, t.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void fullScreen(DrawContext& ctx) {
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

void bindDepth(const DrawContext& ctx) { glBindTextureUnit(ctx.targets.samples > 1 ? TEX_DEPTH_SAMPLES : TEX_DEPTH, ctx.targets.depth.id()); }

void drawTonemap(DrawContext& ctx) {
    glBindFramebuffer(GL_FRAMEBUFFER, ctx.targets.final.id());
    if (!ctx.use(0, depthConstants(ctx.targets))) return;
    glBindTextureUnit(TEX_SCENE, ctx.targets.resolved.id());
    bindDepth(ctx);
    fullScreen(ctx);
}

void drawDecal(DrawContext& ctx) {
    if (ctx.settings.decal.radius <= 0 || !ctx.use(0, depthConstants(ctx.targets))) return;
    bindDepth(ctx);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    fullScreen(ctx);
    glDisable(GL_BLEND);
}

const ProgramRow kTonemapPrograms[] = {{"post/tonemap", "post/fullscreen.vert.glsl", "post/tonemap.frag.glsl", nullptr, {}, depthVariants}};
const ProgramRow kDecalPrograms[] = {{"post/decal", "post/fullscreen.vert.glsl", "post/decal.frag.glsl", nullptr, {}, depthVariants}};
const Pass kTonemapPasses[] = {{"post/resolve", Stage::Post, kViewMain | kViewReflection | kViewCompare, kSceneColor, kResolved, {}, resolve},
                               {"post/tonemap", Stage::Post, kViewMain | kViewCompare, kResolved | kSceneDepth, kImage, kTonemapPrograms, drawTonemap}};
const Pass kDecalPasses[] = {{"post/decal", Stage::Overlay, kViewMain, kSceneDepth | kImage, kImage, kDecalPrograms, drawDecal}};

}  // namespace

const EffectRow& tonemapEffect() {
    static const EffectRow row{"post/tonemap", {}, {}, kTonemapPasses, nullptr, "every picture needs its light brought to the screen"};
    return row;
}
const EffectRow& decalEffect() {
    static const EffectRow row{"post/decal", featureSet(Feature::Terrain), {}, kDecalPasses, nullptr, "shows what the brush would touch"};
    return row;
}

}  // namespace sward
