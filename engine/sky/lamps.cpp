#include "sky/lamps.h"

#include "frame/draw_context.h"
#include "sky/daylight.h"

namespace sward {
namespace {

struct LampsView : EffectState {
    Buffer block;
};

// Bound once: nothing else uses the binding.
void runLamps(DrawContext& ctx) {
    LightsGlobals& all = ctx.shared.lights;
    all = lampsAround(ctx.project, ctx.camera.eye, ctx.settings.time, ctx.globals.exposure);
    ctx.shared.lampPlaces = lampPlaces(ctx.project, ctx.settings.time);
    Buffer& block = ctx.ofView<LampsView>().block;
    writeBuffer(ctx.gpu, block, "sky/lamps", sizeof(all), &all);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_LIGHTS, block.id());
}

const System kSystems[] = {{"sky/lamps", {.writes = {Slot::Lamps}}, runLamps}};

}  // namespace

const EffectRow& lampsEffect() {
    static const EffectRow row{
        "sky/lamps",
        featureSet(Feature::Lamps),
        kSystems,
        {},
        nullptr,
        "lights shine beside the sun",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<LampsView>(); }};
    return row;
}

}  // namespace sward
