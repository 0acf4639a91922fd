#include "post/far_blur.h"

#include "frame/draw_context.h"

namespace sward {
namespace {

constexpr const char* kOwner = "post/far-blur";

struct BlurView : EffectState {
    Texture across;  // blurred across only
    Framebuffer target;
};

void ensureTarget(DrawContext& ctx, BlurView& s) {
    const ViewTargets& t = ctx.targets;
    if (s.across.width == t.width && s.across.height == t.height) return;
    s.across = makeTexture2D(ctx.gpu, kOwner, GL_RGBA16F, t.width, t.height);
    s.target = makeFramebuffer(s.across.id(), 0, kOwner);
}

std::string constants(const ViewTargets& t, FarBlur blur) {
    return depthConstants(t) + fmt::format("const bool GAUSSIAN = {};\n", blur == FarBlur::Gaussian);
}
std::vector<std::string> variants() {
    std::vector<std::string> out;
    for (const std::string& depth : depthVariants())
        for (const char* kind : {"false", "true"})
            out.push_back(depth + fmt::format("const bool GAUSSIAN = {};\n", kind));
    return out;
}

void pass(DrawContext& ctx, GLuint from, GLuint target, int axis) {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glBindTextureUnit(TEX_SCENE, from);
    glUniform2i(0, axis == 0, axis == 1);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

// One blur is for the whole picture: of the fields that ask for some, the one that does so from the nearest on. The
// pass runs only where one does.
FarLook blurOf(const Project& project) {
    std::optional<FarLook> nearest;
    project.registry.each<FarLook>([&](Entity, const FarLook& look) {
        if (look.farBlur != FarBlur::None && (!nearest || look.farBlurDistance < nearest->farBlurDistance))
            nearest = look;
    });
    return nearest.value_or(FarLook{});
}

void drawBlurred(DrawContext& ctx) {
    if (ctx.settings.mode != ViewMode::Final) return;  // false colours are no picture
    BlurView& s = ctx.ofView<BlurView>();
    const ViewTargets& t = ctx.targets;
    const FarLook look = blurOf(ctx.project);
    if (!ctx.use(0, constants(t, look.farBlur))) return;
    ensureTarget(ctx, s);
    glBindTextureUnit(t.samples > 1 ? TEX_DEPTH_SAMPLES : TEX_DEPTH, t.depth.id());
    glUniform1f(1, look.farBlurDistance);
    pass(ctx, t.resolved.id(), s.target.id(), 0);
    pass(ctx, s.across.id(), t.resolve.id(), 1);
}

const ProgramRow kPrograms[] = {
    {"post/far-blur", "post/fullscreen.vert.glsl", "post/far_blur.frag.glsl", nullptr, variants}};
const Pass kPasses[] = {{"post/far-blur",
                         Stage::Post,
                         kViewMain,
                         {.reads = {Slot::Resolved, Slot::SceneDepth}, .writes = {Slot::Resolved}},
                         kPrograms,
                         drawBlurred}};

}  // namespace

const EffectRow& farBlurEffect() {
    static const EffectRow row{
        "post/far-blur",
        featureSet(Feature::FarBlur),
        {},
        kPasses,
        nullptr,
        "what is far is blurred, against sparkling",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<BlurView>(); }};
    return row;
}

}  // namespace sward
