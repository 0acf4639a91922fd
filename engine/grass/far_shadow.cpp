#include "grass/far_shadow.h"

#include "grass/field.h"
#include "grass/grass_fields.h"
#include "grass/slices.h"
#include "world/lights.h"

namespace sward {
namespace {

struct FarShadowState : EffectState {
    Buffer nodes;
};

void drawFieldShadow(DrawContext& ctx, const Field& field, const Buffer& room) {
    const std::vector<TerrainNode> shaded = farNodes(ctx, field, field.view->tiers.shadowsTo);
    if (shaded.empty() || !ctx.use(0, fieldConstants(field.view->of), &field.view->constants)) return;
    bindField(field);
    const bool sun = has(ctx.plan.features, Feature::Sun) && ctx.globals.sunIsUp > 0 && ctx.globals.sunCasts > 0;
    const int lamps = ctx.shared.lights.casting;
    // Blades throw their own shadows where they are geometry.
    const FadeRange from = field.draws(Feature::GrassGeometry) ? field.view->tiers.images : fadeRange(0, 0);
    glUniform2f(1, from.min, from.inv);
    for (int light = sun ? 0 : 1; light <= lamps; ++light)
        for (size_t i = 0; i < field.species.size(); ++i) {
            glUniform1i(0, light);
            drawFarSpecies(ctx, {&field, i, shaded}, room);
        }
}

void drawFarShadow(DrawContext& ctx) {
    FarShadowState& state = ctx.own<FarShadowState>();
    if (ctx.settings.mode != ViewMode::Final || !ctx.shared.grass) return;
    if (!state.nodes.id())
        state.nodes = makeBuffer(ctx.gpu, "grass/far-shadow", NODES_PER_DRAW * sizeof(TerrainNode), nullptr);
    beginDimming();
    for (const Field* field : fieldsWith(ctx, Feature::GrassFar))
        if (field->draws(Feature::GroundShadows)) drawFieldShadow(ctx, *field, state.nodes);
    endDimming();
}

const ProgramRow kFarShadowPrograms[] = {
    {"grass/far-shadow", "terrain/ground.vert.glsl", "grass/far_shadow.frag.glsl", nullptr, fieldVariants}};
const Pass kFarShadowPasses[] = {{"grass/far-shadow",
                                  Stage::FarShadow,
                                  kViewMain,
                                  {.reads = {Slot::Grass, Slot::GroundNodes, Slot::FarGround, Slot::Forces,
                                             Slot::Shadows, Slot::ObjectLight, Slot::Lamps},
                                   .appends = {Slot::SceneColor}},
                                  kFarShadowPrograms,
                                  drawFarShadow}};

}  // namespace

const EffectRow& farShadowEffect() {
    static const EffectRow row{
        "grass/far-shadow",
        featureSet(Feature::GrassFar, Feature::Grass, Feature::Terrain, Feature::GroundShadows, Feature::CastingLights),
        {},
        kFarShadowPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<FarShadowState>(); },
        "slices shade the ground"};
    return row;
}

}  // namespace sward
