#include "water/surface.h"

#include "water/lake.h"
#include "world/wind.h"

namespace sward {
namespace {

constexpr const char* kOwner = "water/surface";

struct SurfaceView : EffectState {
    Buffer block;
    bool seen = false;
};

void update(DrawContext& ctx) {
    SurfaceView& s = ctx.ofView<SurfaceView>();
    const Water& water = *waterOf(ctx.project);
    const auto square = waterInView(ctx, water);
    s.seen = square.has_value();
    WaterGlobals g = waterGlobals(water, windOf(ctx.project), ctx.eye, ctx.settings.time);
    g.mirrorScale = {ctx.shared.reflection ? ctx.shared.reflectionScale.x : 0, ctx.shared.reflectionScale.y};
    const glm::vec4 seen = square.value_or(glm::vec4(0));
    g.low = {seen.x, seen.y}, g.high = {seen.z, seen.w};
    writeBuffer(ctx.gpu, s.block, kOwner, sizeof(g), &g);
}

// Dimmed by what the fragment's second output says, and its first added: alpha stays.
void beginBlending() {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_SRC1_COLOR, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    glTextureBarrier();  // the depth that is tested is read as well, and nobody writes it meanwhile
}
// A function that asks for a second colour may not stay, although nothing blends: Mesa refuses every later draw into
// more than one image.
void endBlending() {
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ZERO, GL_ONE, GL_ZERO);
}

void draw(DrawContext& ctx) {
    SurfaceView& s = ctx.ofView<SurfaceView>();
    if (ctx.settings.mode != ViewMode::Final || !ctx.use(0, depthConstants(ctx.targets)) || !s.seen) return;
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_WATER, s.block.id());
    glBindTextureUnit(ctx.targets.samples > 1 ? TEX_DEPTH_SAMPLES : TEX_DEPTH, ctx.targets.depth.id());
    if (ctx.shared.reflection) glBindTextureUnit(TEX_REFLECTION, ctx.shared.reflection);
    beginBlending();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    endBlending();
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

const System kSystems[] = {{"water/ripples", {.reads = {Slot::Ground, Slot::Reflection}}, update}};
const ProgramRow kPrograms[] = {
    {"water/surface", "water/surface.vert.glsl", "water/surface.frag.glsl", nullptr, depthVariants}};
const Pass kPasses[] = {{"water/surface",
                         Stage::Water,
                         kViewMain,
                         {.reads = {Slot::SceneDepth, Slot::Reflection, Slot::Shadows}, .appends = {Slot::SceneColor}},
                         kPrograms,
                         draw}};

}  // namespace

const EffectRow& waterEffect() {
    static const EffectRow row{
        "water/surface",
        featureSet(Feature::Water, Feature::Terrain),
        kSystems,
        kPasses,
        nullptr,
        "water stands where the ground is below its level",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<SurfaceView>(); }};
    return row;
}

}  // namespace sward
