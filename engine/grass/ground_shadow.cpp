#include "grass/ground_shadow.h"

#include "frame/draw_context.h"
#include "grass/blade_list.h"
#include "grass/field.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/ground-shadow";
constexpr float kLongest = 4;     // as in the shader
constexpr float kTallest = 1.5f;  // blades, as a share of the mean
constexpr int kLights = 7;        // that have a bit of the stencil; the eighth says where the ground is seen

struct ShadowState : EffectState {
    struct One {
        Buffer commands;
        Buffer listed;  // indices, where the driver shades vertices on the CPU; else those of the blades' own mesh
        GLsizei count = 0;
        std::vector<float> least;
        uint64_t leastOf = 0;  // the patch's key
    };
    std::array<One, MAX_SPECIES> species;
};

std::vector<DrawCommand> commandRanges(const BladeDraws& blades, float share) {
    std::vector<DrawCommand> commands;
    commands.reserve(blades.count);
    for (size_t i = 0; i < blades.count; ++i)
        commands.push_back(drawCommand(blades.cells[i], std::min(blades.segments, kShadowQuads), blades.strips, share,
                                       static_cast<uint32_t>(i), blades.verticesABlade));
    return commands;
}

// The blades whose shadows can be seen.
BladeList shadowList(const DrawContext& ctx, ShadowState::One& one, size_t i, const BladeDraws& blades, float share) {
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    const FieldSpecies& species = *ctx.shared.grass->species[i];
    if (one.leastOf != species.drawnKey()) one.least = leastShading(species.drawn()), one.leastOf = species.drawnKey();
    const CellQuery query = drawnQuery(ctx, f, i);
    const float sine = ctx.shared.lights.casting > 0 ? 0 : ctx.globals.sunDirection.y;
    return listBlades({query, one.least, query.reach + groundShadowReach(species.look.height, sine), share, true},
                      {blades.cells, blades.count});
}

void makeCommands(DrawContext& ctx, ShadowState::One& one, size_t i) {
    const BladeDraws& blades = ctx.shared.blades[i];
    const float share = ctx.settings.detail * blades.shading;
    if (blades.shadowCommands) {
        one = {};
        one.count = static_cast<GLsizei>(blades.count);
        return;
    }
    BladeList list;
    const bool listed =
        blades.count > 0 && ctx.gpu.software && !(list = shadowList(ctx, one, i, blades, share)).tooMany;
    if (listed)
        writeBuffer(ctx.gpu, one.listed, kOwner, list.indices.size() * sizeof(uint32_t), list.indices.data());
    else
        one.listed = {};
    const std::vector<DrawCommand> commands = listed ? std::move(list.commands) : commandRanges(blades, share);
    one.count = static_cast<GLsizei>(commands.size());
    if (one.count > 0)
        writeBuffer(ctx.gpu, one.commands, kOwner, commands.size() * sizeof(DrawCommand), commands.data());
    else
        one.commands = {};
}

void prepare(DrawContext& ctx) {
    ShadowState& state = ctx.own<ShadowState>();
    for (size_t i = 0; i < MAX_SPECIES; ++i) makeCommands(ctx, state.species[i], i);
}

void drawSpecies(DrawContext& ctx, size_t i, const ShadowState::One& one) {
    const BladeDraws& blades = ctx.shared.blades[i];
    if (ctx.shared.densities[i]) glBindTextureUnit(TEX_DENSITY, ctx.shared.densities[i]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_BLADES, blades.buffer);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SPECIES, blades.globals);
    glVertexArrayElementBuffer(blades.mesh, one.listed.id() ? one.listed.id() : blades.indices);
    glBindVertexArray(blades.mesh);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, blades.shadowCommands ? blades.shadowCommands : one.commands.id());
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(blades.shadowOffset),
                                one.count, 0);
    ctx.pass->draws += 1;
    ctx.pass->instances += static_cast<uint64_t>(one.count);
}

void drawLight(DrawContext& ctx, const ShadowState& state, int light) {
    glUniform1i(0, light);
    glStencilMask(1u << light);
    glStencilFunc(GL_EQUAL, kStencilGround, kStencilGround | 1u << light);
    for (size_t i = 0; i < MAX_SPECIES; ++i)
        if (state.species[i].count > 0) drawSpecies(ctx, i, state.species[i]);
}

void draw(DrawContext& ctx) {
    const ShadowState& state = ctx.own<ShadowState>();
    if (ctx.settings.mode != ViewMode::Final || !ctx.use()) return;
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    const bool sun = has(ctx.plan.features, Feature::Sun) && ctx.globals.sunIsUp > 0 && ctx.globals.sunCasts > 0;
    const int lamps = std::min(ctx.shared.lights.casting, kLights - 1);
    for (int light = sun ? 0 : 1; light <= lamps; ++light) drawLight(ctx, state, light);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glStencilMask(0xff);
    glDisable(GL_STENCIL_TEST);
}

const System kSystems[] = {{"grass/ground-shadow/cells", prepare}};
const ProgramRow kPrograms[] = {
    {"grass/ground-shadow", "grass/ground_shadow.vert.glsl", "grass/ground_shadow.frag.glsl", nullptr,
     featureSet(Feature::TerrainHeights, Feature::GrassDensity, Feature::GrassOrientation, Feature::GrassVegetation,
                Feature::GrassHeights, Feature::GrassOcclusion, Feature::GrassClumps, Feature::Wind, Feature::Gusts,
                Feature::Forces, Feature::ForceMap, Feature::FarDarkening, Feature::GroundShadows,
                Feature::ObjectShadows, Feature::TerrainShadows, Feature::CastingLights, Feature::Sun, Feature::Lamps,
                Feature::Sky, Feature::Fog)}};
const Pass kPasses[] = {
    {"grass/ground-shadow", Stage::GroundShadow, kViewMain | kViewCompare, kSceneDepth, kSceneColor, kPrograms, draw}};

}  // namespace

float groundShadowReach(float meanHeight, float sinElevation) {
    const float s = std::clamp(sinElevation, 1e-3f, 1.0f);
    return meanHeight * std::min(kTallest * std::sqrt(1 - s * s) / s, kLongest);
}

const EffectRow& groundShadowEffect() {
    static const EffectRow row{
        "grass/ground-shadow",
        featureSet(Feature::Grass, Feature::GrassGeometry, Feature::Terrain, Feature::GroundShadows,
                   Feature::CastingLights),
        kSystems,
        kPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<ShadowState>(); },
        "near blades shade the ground"};
    return row;
}

}  // namespace sward
