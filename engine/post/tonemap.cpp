#include "post/tonemap.h"

#include "frame/draw_context.h"

namespace sward {
namespace {

constexpr const char* kReads[] = {"const bool RESOLVED = false;\n", "const bool RESOLVED = true;\n"};
std::vector<std::string> readVariants() { return {kReads[0], kReads[1]}; }

// One sample is read where it is.
void resolve(DrawContext& ctx) {
    const ViewTargets& t = ctx.targets;
    if (t.samples > 1) resolveScene(t);
    glBindFramebuffer(GL_FRAMEBUFFER, t.final.id());
    glDisable(GL_DEPTH_TEST);
}

void fullScreen(DrawContext& ctx) {
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

void drawTonemap(DrawContext& ctx) {
    resolve(ctx);
    const bool resolved = ctx.targets.samples > 1;
    if (!ctx.use(0, kReads[resolved])) return;
    glBindTextureUnit(TEX_SCENE, ctx.targets.resolved.id());
    glBindTextureUnit(TEX_SAMPLES, ctx.targets.color.id());
    glBindTextureUnit(TEX_DEPTH, ctx.targets.depth.id());
    fullScreen(ctx);
}

void drawDecal(DrawContext& ctx) {
    if (ctx.settings.decal.radius <= 0 || !ctx.use()) return;
    glBindTextureUnit(TEX_DEPTH, ctx.targets.depth.id());
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    fullScreen(ctx);
    glDisable(GL_BLEND);
}

const ProgramRow kTonemapPrograms[] = {{"post/tonemap", "post/fullscreen.vert.glsl", "post/tonemap.frag.glsl", nullptr, {}, readVariants}};
constexpr ProgramRow kDecalPrograms[] = {{"post/decal", "post/fullscreen.vert.glsl", "post/decal.frag.glsl", nullptr, {}}};
const Pass kTonemapPasses[] = {{"post/tonemap", Stage::Post, kViewMain | kViewCompare, kSceneColor | kSceneDepth, kImage, kTonemapPrograms, drawTonemap}};
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
