#include "grass/ground_shadow.h"

#include "frame/draw_context.h"
#include "grass/blade_list.h"
#include "grass/field.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/ground-shadow";
constexpr float kLongest = 4;     // as in the shader
constexpr float kTallest = 1.5f;  // blades, as a share of the mean
constexpr int kShadowLights = 7;  // that have a bit of the stencil; the eighth says where the ground is seen

struct One {
    Buffer commands;
    Buffer listed;  // indices, where the driver shades vertices on the CPU; else those of the blades' own mesh
    GLsizei count = 0;
};
struct GroundShadowView : EffectState {
    PerSpecies<One> species;
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
BladeList shadowList(const DrawContext& ctx, const Field& field, size_t i, float share) {
    const BladeDraws& blades = field.species[i].draws;
    const CellQuery query = drawnQuery(ctx, field, i);
    return listBlades({query, query.reach + groundShadowReach(ctx, field, i), {}, share, true},
                      {blades.cells, blades.count});
}

void makeCommands(DrawContext& ctx, One& one, const Field& field, size_t i) {
    const BladeDraws& blades = field.species[i].draws;
    const float share = ctx.settings.detail * blades.shading;
    if (blades.shadowCommands) {
        one = {};
        one.count = static_cast<GLsizei>(blades.count);
        return;
    }
    BladeList list;
    const bool listed = blades.count > 0 && ctx.gpu.software && !(list = shadowList(ctx, field, i, share)).tooMany;
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

void prepareGroundShadows(DrawContext& ctx) {
    GroundShadowView& view = ctx.ofView<GroundShadowView>();
    if (!ctx.shared.grass) return;
    view.species.keep(ctx.shared.grass->all, Feature::GroundShadows);
    eachSpecies(ctx, Feature::GroundShadows,
                [&](const Field& field, size_t i) { makeCommands(ctx, view.species.at(field.number, i), field, i); });
}

void drawSpecies(DrawContext& ctx, const FieldSpecies& species, const One& one) {
    const BladeDraws& blades = species.draws;
    if (species.grown->density) glBindTextureUnit(TEX_DENSITY, species.grown->density);
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

// The first blade of any field that shades a pixel is the only one that shades it, by each light.
void drawLight(DrawContext& ctx, GroundShadowView& view, int light) {
    glStencilMask(1u << light);
    glStencilFunc(GL_EQUAL, kStencilGround, kStencilGround | 1u << light);
    const Field* begun = nullptr;
    eachSpecies(ctx, Feature::GroundShadows, [&](const Field& field, size_t i) {
        const One& one = view.species.at(field.number, i);
        if (begun != &field) {
            if (!ctx.use(0, {}, &field.view->constants)) return;
            bindField(field);
            glUniform1i(0, light);
            glUniform1f(1, pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)));
        }
        begun = &field;
        if (one.count > 0) drawSpecies(ctx, field.species[i], one);
    });
}

void drawGroundShadows(DrawContext& ctx) {
    GroundShadowView& view = ctx.ofView<GroundShadowView>();
    if (ctx.settings.mode != ViewMode::Final) return;
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    beginDimming();
    const bool sun = has(ctx.plan.features, Feature::Sun) && ctx.globals.sunIsUp > 0 && ctx.globals.sunCasts > 0;
    const int lamps = std::min(ctx.shared.lights.casting, kShadowLights - 1);
    for (int light = sun ? 0 : 1; light <= lamps; ++light) drawLight(ctx, view, light);
    endDimming();
    glStencilMask(0xff);
    glDisable(GL_STENCIL_TEST);
}

const System kSystems[] = {{"grass/ground-shadow/cells",
                            {.reads = {Slot::Grass, Slot::Ground, Slot::Sun, Slot::Lamps, Slot::Blades}},
                            prepareGroundShadows}};
const ProgramRow kPrograms[] = {
    {"grass/ground-shadow", "grass/ground_shadow.vert.glsl", "grass/ground_shadow.frag.glsl", nullptr}};
const Pass kPasses[] = {{.name = "grass/ground-shadow",
                         .stage = Stage::GroundShadow,
                         .views = kViewMain,
                         .uses = {.reads = {Slot::Grass, Slot::Blades, Slot::BladeCells, Slot::Forces, Slot::Shadows,
                                            Slot::ObjectLight, Slot::Lamps},
                                  .appends = {Slot::SceneColor}},
                         .programs = kPrograms,
                         .draw = drawGroundShadows,
                         .stencil = true}};

}  // namespace

float groundShadowReach(const DrawContext& ctx, const Field& field, size_t i) {
    const float sine = ctx.shared.lights.casting > 0 ? 0 : ctx.globals.sunDirection.y,
                s = std::clamp(sine, 1e-3f, 1.0f);
    return field.species[i].grown->look.height * std::min(kTallest * std::sqrt(1 - s * s) / s, kLongest) +
           field.grows().species[i].width * f32::kMostShadows;
}

const EffectRow& groundShadowEffect() {
    static const EffectRow row{
        "grass/ground-shadow",
        featureSet(Feature::Grass, Feature::GrassGeometry, Feature::Terrain, Feature::GroundShadows,
                   Feature::CastingLights),
        kSystems,
        kPasses,
        nullptr,
        "near blades shade the ground",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<GroundShadowView>(); }};
    return row;
}

}  // namespace sward
