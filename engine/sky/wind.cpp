#include "sky/wind.h"

#include <optional>

#include "frame/draw_context.h"
#include "world/wind.h"

namespace sward {
namespace {

struct WindView : EffectState {
    Buffer block;
    std::optional<double> time;  // of the frame before
};
struct GustsState : EffectState {
    Map made;
};

// Both are bound for the whole frame: nothing else uses the bindings.
void runWind(DrawContext& ctx) {
    WindView& s = ctx.ofView<WindView>();
    const Wind& wind = *windOf(ctx.project);
    const glm::dvec2 eye(ctx.eye.x, ctx.eye.z);
    const WindGlobals now = windGlobals(wind, eye, ctx.settings.time);
    const bool follows = has(ctx.plan.features, Feature::Temporal) && s.time;
    const WindGlobals winds[] = {now, follows ? windGlobals(wind, eye, *s.time) : now};
    s.time = ctx.settings.time;
    writeBuffer(ctx.gpu, s.block, "sky/wind", sizeof(winds), winds);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_WIND, s.block.id());
}
void runGusts(DrawContext& ctx) {
    const Wind& wind = *windOf(ctx.project);
    const Map& gusts = gustsOf(wind, ctx.own<GustsState>().made);
    const std::string path = entityOf(ctx.project, wind) + ".Wind.gusts";
    glBindTextureUnit(TEX_WIND, ctx.maps.get("sky/gusts", path, gusts, false, true));
}

const System kWindSystems[] = {{"sky/wind", {}, runWind}};
const System kGustSystems[] = {{"sky/gusts", {}, runGusts, true}};

}  // namespace

const EffectRow& windEffect() {
    static const EffectRow row{
        "sky/wind",
        featureSet(Feature::Wind),
        kWindSystems,
        {},
        nullptr,
        "wind blows, and what grows follows it",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<WindView>(); }};
    return row;
}
const EffectRow& gustsEffect() {
    static const EffectRow row{
        "sky/gusts",
        featureSet(Feature::Wind, Feature::Gusts),
        kGustSystems,
        {},
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<GustsState>(); },
        "the wind comes in gusts, from a picture"};
    return row;
}

}  // namespace sward
