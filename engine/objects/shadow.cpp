#include "objects/shadow.h"

#include "objects/shadow_maps.h"
#include "shared/objects.h"

namespace sward {
namespace {

constexpr const char* kOwner = "objects/shadow";
constexpr int kMapSide = 2048;                                // texels of a map
constexpr double kSunReach[SHADOW_CASCADES] = {14, 60, 256};  // metres from the eye
constexpr double kSunSlack = 0.1;           // share of the reach that the eye may move before a map is drawn anew
constexpr double kHalf = 1.02 + kSunSlack;  // half a map's side, as a share of the reach: and room for taps

struct ShadowMap {
    glm::dvec3 centre{0};   // in the world
    uint64_t drawn = 0;     // hash of what it shows; 0: nothing yet
    bool mirrored = false;  // drawn for what water mirrors, whose places round otherwise
};
struct ShadowState : EffectState {
    ShadowMaps maps;  // SHADOW_CASCADES
    ShadowMap map[SHADOW_CASCADES];
    LightAxes axes;
};
// From a view's eye to the maps, which all views share.
struct ShadowView : EffectState {
    Buffer globals;
    ShadowGlobals values;
};

std::unique_ptr<EffectState> makeShadowState(DrawContext& ctx) {
    auto s = std::make_unique<ShadowState>();
    s->maps = makeShadowMaps(ctx.gpu, kOwner, kMapSide, SHADOW_CASCADES);
    return s;
}
std::unique_ptr<EffectState> makeShadowView(DrawContext& ctx) {
    auto s = std::make_unique<ShadowView>();
    s->globals = makeBuffer(ctx.gpu, kOwner, sizeof(ShadowGlobals), nullptr);
    return s;
}

// around: what is shaded; both in the world.
void aimMap(ShadowState& s, ShadowGlobals& values, int i, const glm::dvec3& around, const glm::dvec3& eye) {
    ShadowMap& map = s.map[i];
    if (map.drawn == 0 || glm::distance(map.centre, around) > kSunSlack * kSunReach[i]) {
        map.centre = around;
        map.drawn = 0;
    }
    const double half = kSunReach[i] * kHalf;
    values.cascades[i].toMap = mapAround(s.axes, map.centre, eye, half, kMapSide);
    values.cascades[i].reach = static_cast<float>(kSunReach[i]);
    values.cascades[i].texel = static_cast<float>(2 * half / kMapSide);
}

void aim(DrawContext& ctx) {
    ShadowState& s = ctx.own<ShadowState>();
    ShadowView& view = ctx.ofView<ShadowView>();
    const glm::vec3 sun = ctx.globals.sunDirection;
    if (ctx.globals.sunIsUp > 0) {
        if (s.axes.towards != sun || s.axes.origin != ctx.shared.ground.origin) {
            s.axes = axesAcross(sun, ctx.shared.ground.origin);
            for (ShadowMap& map : s.map) map.drawn = 0;
        }
        for (int i = 0; i < SHADOW_CASCADES; ++i) aimMap(s, view.values, i, ctx.around, ctx.camera.eye);
        view.values.texelShare = 1.0f / kMapSide;
        glNamedBufferSubData(view.globals.id(), 0, sizeof(ShadowGlobals), &view.values);
    }
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SHADOW, view.globals.id());
    glBindTextureUnit(TEX_SHADOW, s.maps.texture.id());
}

void drawMap(DrawContext& ctx, const ShadowState& s, int map) {
    beginShadowMap(s.maps, map);
    glUniform1i(1, map);
    for (const ShadowCaster& c : ctx.shared.casters)
        if (shadesWithin(s.axes, c, static_cast<float>(kSunReach[map]))) drawCaster(ctx, c);
}

void drawCascades(DrawContext& ctx) {
    ShadowState& s = ctx.own<ShadowState>();
    const uint64_t wanted = ctx.shared.castersHash | 1;
    // The mirror takes what the main view drew; the main view draws its own, so that it is the same without a mirror.
    const bool mirrored = ctx.globals.mirrored != 0;
    const auto stale = [&](const ShadowMap& map) { return map.drawn != wanted || (map.mirrored && !mirrored); };
    if (ctx.globals.sunIsUp <= 0 || std::none_of(std::begin(s.map), std::end(s.map), stale) || !ctx.use()) return;
    glViewport(0, 0, kMapSide, kMapSide);
    glEnable(GL_DEPTH_CLAMP);  // what stands nearer to the sun than the map still shades
    for (int i = 0; i < SHADOW_CASCADES; ++i) {
        if (!stale(s.map[i])) continue;
        drawMap(ctx, s, i);
        s.map[i].drawn = wanted;
        s.map[i].mirrored = mirrored;
    }
    glDisable(GL_DEPTH_CLAMP);
}

const System kSystems[] = {{"objects/aim", {.reads = {Slot::Sun, Slot::Ground}}, aim}};
const ProgramRow kPrograms[] = {{"objects/shadow", "objects/shadow.vert.glsl", "objects/shadow.frag.glsl", nullptr}};
const Pass kPasses[] = {{"objects/shadow",
                         Stage::Shadow,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::Casters}, .appends = {Slot::Shadows}},
                         kPrograms,
                         drawCascades}};

}  // namespace

const EffectRow& shadowEffect() {
    static const EffectRow row{"objects/shadow", featureSet(Feature::ObjectShadows),    kSystems,      kPasses,
                               makeShadowState,  "objects shade what lies behind them", makeShadowView};
    return row;
}

}  // namespace sward
