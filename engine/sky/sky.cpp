#include "sky/sky.h"

#include "frame/draw_context.h"
#include "sky/daylight.h"

namespace sward {
namespace {

struct SkyState : EffectState {
    SkySums sums;
};

void runSun(DrawContext& ctx) { addSun(ctx.globals, ctx.project, ctx.settings.time); }
void runSky(DrawContext& ctx) {
    const bool inAir = has(ctx.plan.features, Feature::Atmosphere);
    SkySums& sums = ctx.own<SkyState>().sums;
    addSky(ctx.globals, ctx.project, ctx.settings.time, sums, inAir ? ctx.shared.air : nullptr);
    ctx.shared.skyTilt = sums.tilt;
}
void runHaze(DrawContext& ctx) { addHaze(ctx.globals, ctx.project); }

void drawDome(DrawContext& ctx) {
    if (!ctx.use()) return;
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

const System kSunSystems[] = {{"sky/sun", {.writes = {Slot::Sun}}, runSun, true}};
const System kSkySystems[] = {
    {"sky/ambient", {.reads = {Slot::Sun, Slot::Air}, .writes = {Slot::Sun, Slot::SkyLight}}, runSky, true}};
const System kHazeSystems[] = {{"sky/haze", {.writes = {Slot::Haze}}, runHaze, true}};
const ProgramRow kDomePrograms[] = {{"sky/dome", "sky/dome.vert.glsl", "sky/dome.frag.glsl", nullptr}};
const Pass kDomePasses[] = {
    {"sky/dome", Stage::Sky, kViewMain | kViewReflection, {.appends = {Slot::SceneColor}}, kDomePrograms, drawDome}};

}  // namespace

const EffectRow& sunEffect() {
    static const EffectRow row{"sky/sun", featureSet(Feature::Sun),           kSunSystems, {},
                               nullptr,   "a light shines from one direction"};
    return row;
}
const EffectRow& skyEffect() {
    static const EffectRow row{
        "sky/dome",
        featureSet(Feature::Sky),
        kSkySystems,
        kDomePasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<SkyState>(); },
        "the sky lights the scene and is seen where nothing stands before it"};
    return row;
}
const EffectRow& hazeEffect() {
    static const EffectRow row{
        "sky/haze",   featureSet(Feature::Fog),
        kHazeSystems, {},
        nullptr,      "what is far fades into the horizon, and land is not drawn where nothing of it is left"};
    return row;
}

}  // namespace sward
