#include "water/surface.h"

#include "water/lake.h"
#include "world/wind.h"

namespace sward {
namespace {

constexpr const char* kOwner = "water/surface";

struct SurfaceState : EffectState {
    Buffer block;
    bool seen = false;
};

void update(DrawContext& ctx) {
    SurfaceState& s = ctx.own<SurfaceState>();
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
void endBlending() {
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void draw(DrawContext& ctx) {
    SurfaceState& s = ctx.own<SurfaceState>();
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

const System kSystems[] = {{"water/ripples", update}};
const ProgramRow kPrograms[] = {
    {"water/surface", "water/surface.vert.glsl", "water/surface.frag.glsl", nullptr,
     featureSet(Feature::WaterReflection, Feature::Wind, Feature::Gusts, Feature::ObjectShadows,
                Feature::TerrainShadows, Feature::Sun, Feature::Sky, Feature::Fog),
     depthVariants}};
const Pass kPasses[] = {
    {"water/surface", Stage::Water, kViewMain | kViewCompare, kSceneDepth, kSceneColor, kPrograms, draw}};

}  // namespace

const EffectRow& waterEffect() {
    static const EffectRow row{
        "water/surface",
        featureSet(Feature::Water, Feature::Terrain),
        kSystems,
        kPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<SurfaceState>(); },
        "water stands where the ground is below its level"};
    return row;
}

}  // namespace sward
