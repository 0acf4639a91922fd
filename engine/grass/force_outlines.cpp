#include "grass/force_outlines.h"

#include "frame/draw_context.h"
#include "world/forces.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/force-outlines";

// The outline's distances as a texture, while a force has it.
struct OutlinesDrawn {
    std::shared_ptr<const Footprint> outline;
    Texture distances;
};
struct OutlinesState : EffectState {
    std::map<const Footprint*, OutlinesDrawn> outlines;
    VertexArray square;
};

std::unique_ptr<EffectState> makeOutlinesState(DrawContext&) {
    auto s = std::make_unique<OutlinesState>();
    s->square = makeVertexArray(kOwner);
    return s;
}

Texture upload(DrawContext& ctx, const Footprint& f) {
    Texture t = makeTexture2D(ctx.gpu, kOwner, GL_R32F, f.width, f.height);
    glTextureSubImage2D(t.id(), 0, 0, 0, f.width, f.height, GL_RED, GL_FLOAT, f.distances.data());
    return t;
}

void uploadOutlines(DrawContext& ctx) {
    OutlinesState& s = ctx.own<OutlinesState>();
    std::map<const Footprint*, OutlinesDrawn> kept;
    for (const Force& f : ctx.shared.forceTarget.forces) {
        if (!f.outline || kept.contains(f.outline.get())) continue;
        const auto known = s.outlines.find(f.outline.get());
        kept[f.outline.get()] =
            known != s.outlines.end() ? std::move(known->second) : OutlinesDrawn{f.outline, upload(ctx, *f.outline)};
    }
    s.outlines = std::move(kept);
}

void drawOne(DrawContext& ctx, const Force& f) {
    const Footprint& o = *f.outline;
    const glm::vec2 at(f.from - glm::dvec2(ctx.eye.x, ctx.eye.z)), size = o.high() - o.low;
    glUniform2f(0, at.x, at.y);
    glUniform1f(1, farOf(f));
    glUniform1f(2, f.share);
    glUniform1f(3, f.radius);
    glUniform1f(4, f.reach);
    glUniform2f(5, f.heading.x, f.heading.y);
    glUniform2f(6, o.low.x, o.low.y);
    glUniform2f(7, size.x, size.y);
    glUniform1f(8, f.scale);
    glUniform1f(9, o.texel);
    glBindTextureUnit(TEX_OBJECT, ctx.own<OutlinesState>().outlines.at(&o).distances.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

void drawOutlines(DrawContext& ctx) {
    const ForceTarget& target = ctx.shared.forceTarget;
    if (!ctx.use()) return;
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, target.side, target.side);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
    glBindVertexArray(ctx.own<OutlinesState>().square.id());
    for (const Force& f : target.forces)
        if (f.outline) drawOne(ctx, f);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

const System kSystems[] = {{"grass/force-outlines/upload", {.reads = {Slot::ForceList}}, uploadOutlines, true}};
const ProgramRow kPrograms[] = {
    {"grass/force-outlines", "grass/force_outlines.vert.glsl", "grass/force_outlines.frag.glsl", nullptr}};
const Pass kPasses[] = {{"grass/force-outlines",
                         Stage::Simulate,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::ForceList}, .appends = {Slot::Forces}},
                         kPrograms,
                         drawOutlines}};

}  // namespace

const EffectRow& forceOutlinesEffect() {
    static const EffectRow row{"grass/force-outlines",
                               featureSet(Feature::ForceOutlines, Feature::Forces, Feature::Grass, Feature::Terrain),
                               kSystems,
                               kPasses,
                               makeOutlinesState,
                               "an object presses on the grass in the shape of its outline"};
    return row;
}

}  // namespace sward
