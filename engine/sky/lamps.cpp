#include "sky/lamps.h"

#include "frame/draw_context.h"
#include "sky/daylight.h"

namespace sward {
namespace {

struct LampsState : EffectState {
    Buffer block;
};

// Bound once: nothing else uses the binding.
void runLamps(DrawContext& ctx) {
    LightsGlobals& all = ctx.shared.lights;
    all = lampsAround(ctx.project, ctx.camera.eye, ctx.settings.time, ctx.globals.exposure);
    Buffer& block = ctx.own<LampsState>().block;
    writeBuffer(ctx.gpu, block, "sky/lamps", sizeof(all), &all);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_LIGHTS, block.id());
}

const System kSystems[] = {{"sky/lamps", runLamps}};

}  // namespace

const EffectRow& lampsEffect() {
    static const EffectRow row{
        "sky/lamps",
        featureSet(Feature::Lamps),
        kSystems,
        {},
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<LampsState>(); },
        "lights shine beside the sun"};
    return row;
}

}  // namespace sward
