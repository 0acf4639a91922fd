#include "water/reflection.h"

#include <glm/gtc/matrix_transform.hpp>

#include "water/lake.h"

namespace sward {
namespace {

constexpr const char* kOwner = "water/reflection";
constexpr float kMargin = 0.08f;  // of the picture beyond each edge, for ripples that look there
constexpr float kUnder = 0.04f;   // metres below the level at which the view is cut: no gap shows along the shore
constexpr float kBlades = 0.35f;  // share of the blades that is drawn where blades are; each is wider
constexpr float kAnisotropy = 8;

struct ReflectionState : EffectState {
    ViewTargets targets;
};

void ensureTargets(DrawContext& ctx, ReflectionState& s, float share) {
    const auto pixels = [&](int side) {
        return std::max(static_cast<int>(std::lround(static_cast<float>(side) * share * (1 + 2 * kMargin))), 8);
    };
    const int width = pixels(ctx.targets.width), height = pixels(ctx.targets.height);
    if (s.targets.width == width && s.targets.height == height && s.targets.samples == ctx.targets.samples) return;
    s.targets = {};
    s.targets = makeTargets(ctx.gpu, kOwner, {width, height, ctx.targets.samples, false, 0, false});
    glTextureParameterf(s.targets.resolved.id(), GL_TEXTURE_MAX_ANISOTROPY, kAnisotropy);
}

glm::dvec3 mirroredAt(const glm::dvec3& p, double height) { return {p.x, 2 * height - p.y, p.z}; }

void fill(ViewRequest& r, const DrawContext& ctx, ReflectionState& s, const Water& water) {
    const double height = ctx.shared.ground.origin.y + static_cast<double>(water.level);
    r.mirrored = true;
    r.camera = ctx.camera;
    r.camera.eye = mirroredAt(ctx.camera.eye, height);
    r.camera.target = mirroredAt(ctx.camera.target, height);
    const float shown = 1 / (1 + 2 * kMargin);
    r.viewProj =
        glm::scale(glm::mat4(1), {shown, shown, 1}) * ctx.globals.viewProj * glm::scale(glm::mat4(1), {1, -1, 1});
    r.cutAt = static_cast<float>(height - r.camera.eye.y) - kUnder;
    r.settings = ctx.settings;
    r.settings.width = s.targets.width, r.settings.height = s.targets.height;
    r.settings.part = {0, 0, s.targets.width,
                       static_cast<int>(std::lround(static_cast<double>(wholeHeight(ctx.settings)) * s.targets.height *
                                                    static_cast<double>(shown) / ctx.targets.height))};
    r.settings.coarse = true;
    r.settings.detail = ctx.settings.detail * kBlades;
    r.settings.decal = {};
    r.targets = &s.targets;
}

bool request(DrawContext& ctx, ViewRequest& wanted) {
    ReflectionState& s = ctx.own<ReflectionState>();
    const Water& water = *waterOf(ctx.project);
    if (ctx.settings.mode != ViewMode::Final || !(water.reflection > 0) || !waterInView(ctx, water)) return false;
    ensureTargets(ctx, s, std::clamp(water.reflection, 0.05f, 1.0f));
    fill(wanted, ctx, s, water);
    return true;
}

void drawn(DrawContext& ctx) {
    const GLuint mirrored = ctx.own<ReflectionState>().targets.resolved.id();
    glGenerateTextureMipmap(mirrored);
    ctx.shared.reflection = mirrored;
    ctx.shared.reflectionScale = glm::vec2(0.5f / (1 + 2 * kMargin));
}

const ViewRow kView{
    kViewReflection, "mirrored ", {.reads = {Slot::Ground}, .writes = {Slot::Reflection}}, request, drawn};

}  // namespace

const EffectRow& reflectionEffect() {
    static const EffectRow row{
        "water/reflection",
        featureSet(Feature::Water, Feature::WaterReflection, Feature::Terrain),
        {},
        {},
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<ReflectionState>(); },
        "water mirrors the scene: sky, ground, objects and grass are drawn once more, coarsely",
        nullptr,
        &kView};
    return row;
}

}  // namespace sward
