#include "water/surface.h"

#include <algorithm>

#include "water/lake.h"
#include "world/wind.h"

namespace sward {
namespace {

constexpr const char* kOwner = "water/surface";

struct SurfaceView : EffectState {
    struct Seen {
        Buffer block;
        GLuint reflected = 0;  // what it mirrors
        bool inView = false;
    };
    std::vector<Seen> waters;  // in the order of watersOf
};

void updateSurface(DrawContext& ctx) {
    SurfaceView& s = ctx.ofView<SurfaceView>();
    const std::vector<WaterPlace> places = watersOf(ctx.project, ctx.shared.ground);
    s.waters.resize(places.size());
    for (size_t i = 0; i < places.size(); ++i) {
        SurfaceView::Seen& seen = s.waters[i];
        const auto square = waterInView(ctx, places[i]);
        seen.inView = square.has_value();
        if (!square) continue;
        WaterGlobals g = waterGlobals(places[i], windOf(ctx.project), ctx.eye, ctx.settings.time);
        setCovers(g, places, i, *ctx.shared.ground.terrain, ctx.eye);
        g.low = {square->x, square->y}, g.high = {square->z, square->w};
        const Reflection r = i < ctx.shared.reflections.size() ? ctx.shared.reflections[i] : Reflection{};
        seen.reflected = r.texture;
        g.mirrorScale = r.scale, g.mirrorAt = r.at;
        g.mirrors = r.texture ? 1 : 0;
        writeBuffer(ctx.gpu, seen.block, kOwner, sizeof(g), &g);
    }
}

void drawSurface(DrawContext& ctx) {
    const SurfaceView& s = ctx.ofView<SurfaceView>();
    const bool any = std::any_of(s.waters.begin(), s.waters.end(), [](const auto& w) { return w.inView; });
    if (ctx.settings.mode != ViewMode::Final || !ctx.use(0, depthConstants(ctx.targets)) || !any) return;
    glBindTextureUnit(ctx.targets.samples > 1 ? TEX_DEPTH_SAMPLES : TEX_DEPTH, ctx.targets.depth.id());
    beginDimming();
    glTextureBarrier();  // the depth that is tested is read as well, and nobody writes it meanwhile
    for (const SurfaceView::Seen& water : s.waters) {
        if (!water.inView) continue;
        glBindBufferBase(GL_UNIFORM_BUFFER, UBO_WATER, water.block.id());
        if (water.reflected) glBindTextureUnit(TEX_REFLECTION, water.reflected);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        ctx.pass->draws += 1;
        ctx.pass->instances += 1;
    }
    endDimming();
}

const System kSystems[] = {{"water/ripples", {.reads = {Slot::Ground, Slot::Reflection}}, updateSurface}};
const ProgramRow kPrograms[] = {
    {"water/surface", "water/surface.vert.glsl", "water/surface.frag.glsl", nullptr, depthVariants}};
const Pass kPasses[] = {{"water/surface",
                         Stage::Water,
                         kViewMain,
                         {.reads = {Slot::SceneDepth, Slot::Reflection, Slot::Shadows}, .appends = {Slot::SceneColor}},
                         kPrograms,
                         drawSurface}};

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
