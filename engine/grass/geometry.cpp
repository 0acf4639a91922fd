#include "grass/geometry.h"

#include <chrono>

#include "core/numerics.h"
#include "frame/draw_context.h"
#include "grass/blade_list.h"
#include "grass/drawing.h"
#include "grass/field.h"
#include "grass/gpu_cells.h"
#include "grass/ground_shadow.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/geometry";

struct SpeciesState {
    uint64_t key = 0;  // of the patch that the mesh was made from
    int segments = 0;
    size_t strips = 0;  // blades that the indices hold, and whether they are a cell's own: as drawCommand takes them
    uint32_t verticesABlade = 0;
    Buffer blades, indices, cells, commands;
    Buffer listed;     // indices of the blades that can be seen, where the driver shades vertices on the CPU; else none
    GLsizei seen = 0;  // commands
    VertexArray mesh;
    std::vector<CellDraw> selected;
    ChosenCells chosen;        // where the GPU chooses; else nothing
    float shadowShare = 0;     // of the blades, that shade the soil
    std::vector<float> least;  // of leastShown, for `way` and `samples`
    Transparency way{};
    int samples = 0;
};
struct GeometryState : EffectState {
    PerSpecies<SpeciesState> species;
};

// For each n up to `segments`, all blades' strips of n quads in threshold order, over the same 2 (segments + 1)
// vertices a blade: coarse strips skip rows, and rows that no strip uses cost nothing.
std::vector<uint32_t> stripIndices(size_t blades, int segments) {
    std::vector<uint32_t> out;
    out.reserve(blades * firstStrip(segments + 1));
    for (int n = 1; n <= segments; ++n)
        for (size_t b = 0; b < blades; ++b) addStrip(out, static_cast<uint32_t>(b), n, segments);
    return out;
}

void updateMesh(DrawContext& ctx, SpeciesState& s, const FieldSpecies& f, int segments) {
    if (s.key == f.drawnKey() && s.segments == segments && s.mesh.id()) return;
    s.key = f.drawnKey();
    s.segments = segments;
    s.strips = f.unique.empty() ? f.patch.blades.size() : f.unique.mostInCell;
    s.verticesABlade = f.unique.empty() ? 0 : 2 * static_cast<uint32_t>(segments + 1);
    const auto indices = stripIndices(s.strips, segments);
    s.blades = makeBuffer(ctx.gpu, kOwner, f.drawn().blades.size() * sizeof(Blade), f.drawn().blades.data());
    s.indices = makeBuffer(ctx.gpu, kOwner, indices.size() * 4, indices.data());
    s.mesh = makeVertexArray(kOwner);
    s.least.clear();
}

void uploadCommands(DrawContext& ctx, SpeciesState& s, const std::vector<DrawCommand>& commands, uint64_t blades) {
    writeBuffer(ctx.gpu, s.commands, kOwner, commands.size() * sizeof(DrawCommand), commands.data());
    s.seen = static_cast<GLsizei>(commands.size());
    ctx.stats.cells += commands.size();
    ctx.stats.bladesGeometry += blades;
}

// One command a cell, over a range of the patch's blades.
void commandRanges(DrawContext& ctx, SpeciesState& s) {
    std::vector<DrawCommand> commands;
    commands.reserve(s.selected.size());
    uint64_t blades = 0;
    for (size_t i = 0; i < s.selected.size(); ++i) {
        const CellDraw& c = s.selected[i];
        if (!c.seen) continue;
        commands.push_back(drawCommand(c, c.segments, static_cast<uint32_t>(s.strips), ctx.settings.detail,
                                       static_cast<uint32_t>(i), s.verticesABlade));
        blades += bladesDrawn(c, ctx.settings.detail);
    }
    s.listed = {};
    uploadCommands(ctx, s, commands, blades);
}

// One command a cell, over those of its blades that can be seen.
void commandLists(DrawContext& ctx, SpeciesState& s, const CellQuery& query, Transparency way) {
    if (s.least.empty() || s.way != way || s.samples != ctx.targets.samples)
        s.least = leastShown(query.patch, way, ctx.targets.samples);
    s.way = way, s.samples = ctx.targets.samples;
    const BladeList list = listBlades({query, s.least, query.reach, ctx.settings.detail}, s.selected);
    if (list.tooMany) return commandRanges(ctx, s);
    writeBuffer(ctx.gpu, s.listed, kOwner, list.indices.size() * sizeof(uint32_t), list.indices.data());
    uploadCommands(ctx, s, list.commands, list.blades);
}

// Where grass is dense, a part of its blades leaves the soil a twentieth of the light: the others would not be seen to.
float shadingShare(const Look& look, float sinElevation) {
    return std::min(1.0f, 3.0f / std::max(-std::log(lightLeft(look, sinElevation)), 1e-3f));
}

// A renderer that shades vertices on the CPU has its blades listed there, unless the field wants it otherwise.
bool gpuChooses(Culling who, const Gpu& gpu) { return who == Culling::Gpu || (who == Culling::Auto && !gpu.software); }

// Cells that the CPU chooses, as instances and commands.
void selectHere(DrawContext& ctx, SpeciesState& s, const CellQuery& query, Transparency way) {
    s.chosen = {};
    s.selected = selectCells(query);
    std::vector<CellInstance> instances;
    instances.reserve(s.selected.size());
    for (const CellDraw& c : s.selected) instances.push_back({{c.cellX, c.cellZ}, {c.x, c.z}, c.mirror, c.shift});
    writeBuffer(ctx.gpu, s.cells, kOwner, instances.size() * sizeof(CellInstance), instances.data());
    if (ctx.gpu.software)
        commandLists(ctx, s, query, way);
    else
        commandRanges(ctx, s);
}

// Room for what the GPU chooses: as many instances and commands as there are cells in the nodes, and as many commands
// of shadows.
void selectThere(DrawContext& ctx, SpeciesState& s, const CellQuery& query) {
    s.selected.clear();
    s.listed = {};
    chooseCells(ctx, s.chosen,
                {query, s.key, 1, std::clamp(ctx.settings.detail, 0.01f, 1.0f), 0, kMaxPatchBlades, true}, kOwner);
    writeBuffer(ctx.gpu, s.cells, kOwner, s.chosen.count * sizeof(CellInstance), nullptr);
    writeBuffer(ctx.gpu, s.commands, kOwner, 2 * s.chosen.count * sizeof(DrawCommand), nullptr);
    s.seen = static_cast<GLsizei>(s.chosen.count);
}

void publish(const DrawContext& ctx, const SpeciesState& s, FieldSpecies& own) {
    BladeDraws& d = own.draws;
    d = {s.mesh.id(), s.indices.id(), s.blades.id(), own.globals.id(), s.selected.data(), s.selected.size()};
    d.strips = static_cast<uint32_t>(s.strips);
    d.segments = s.segments;
    d.verticesABlade = s.verticesABlade;
    d.shading = shadingShare(own.look, ctx.globals.sunDirection.y);
    if (!s.chosen.byGpu) return;
    d.count = s.chosen.count;
    d.shadowCommands = s.commands.id();
    d.shadowOffset = s.chosen.count * sizeof(DrawCommand);
}

void cullSpecies(DrawContext& ctx, const Field& field, size_t i, SpeciesState& s) {
    FieldSpecies& own = *field.species[i];
    const auto& drawing = field.view->settings<GrassDrawing>();
    const bool shades = has(field.view->own, Feature::GroundShadows);
    updateMesh(ctx, s, own, field.grows().species[i].segments);
    CellQuery query = drawnQuery(ctx, field, i);
    if (shades)
        query.shadow =
            groundShadowReach(own.look.height, ctx.shared.lights.casting > 0 ? 0 : ctx.globals.sunDirection.y);
    if (gpuChooses(drawing.culling, ctx.gpu) && gpuMayChoose(query))
        selectThere(ctx, s, query);
    else
        selectHere(ctx, s, query, drawing.transparency);
    describeCells(s.mesh.id(), s.cells.id(), sizeof(CellInstance), s.indices.id());
    publish(ctx, s, own);
    s.shadowShare = shades ? ctx.settings.detail * own.draws.shading : 0;
}

void cull(DrawContext& ctx) {
    GeometryState& state = ctx.own<GeometryState>();
    const auto start = std::chrono::steady_clock::now();
    if (!ctx.shared.grass) return;
    state.species.keep(*ctx.shared.grass, Feature::GrassGeometry);
    eachSpecies(ctx, state.species, Feature::GrassGeometry,
                [&](const Field& field, size_t i, SpeciesState& s) { cullSpecies(ctx, field, i, s); });
    ctx.stats.cpuCullMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

enum CellProgram { kChoose, kCommand };

void commandCells(const DrawContext& ctx, const SpeciesState& s) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_CELLS, s.cells.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_COMMANDS, s.commands.id());
    glUniform1ui(0, s.chosen.count);
    glUniform1ui(1, s.chosen.patchBlades);
    glUniform1f(2, std::clamp(ctx.settings.detail, 0.01f, 1.0f));
    glUniform1f(3, std::clamp(s.shadowShare, 0.01f, 1.0f));
    glUniform1ui(4, s.shadowShare > 0 ? static_cast<GLuint>(std::min(s.segments, kShadowQuads)) : 0u);
    glDispatchCompute((s.chosen.count + 63) / 64, 1, 1);
}

// Where the GPU chooses: cells and their commands.
void chooseThere(DrawContext& ctx) {
    GeometryState& state = ctx.own<GeometryState>();
    eachSpecies(ctx, state.species, Feature::GrassGeometry, [&](const Field& field, size_t i, SpeciesState& s) {
        const std::string* features = &field.view->constants;
        if (!s.chosen.byGpu || s.chosen.count == 0 || !ctx.use(kChoose, {}, features)) return;
        bindField(field);
        runChoice(s.chosen, field.species[i]->density);
        if (ctx.use(kCommand, {}, features)) commandCells(ctx, s);
        if (ctx.settings.measure) recount(ctx, s.chosen);
    });
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void drawSpecies(DrawContext& ctx, const FieldSpecies& shared, SpeciesState& s) {
    if (s.seen == 0) return;
    glBindTextureUnit(TEX_BLADE, shared.bladeTexture.id());
    if (shared.shade.texture) glBindTextureUnit(TEX_MASK, shared.shade.texture);
    if (shared.density) glBindTextureUnit(TEX_DENSITY, shared.density);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_BLADES, s.blades.id());
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SPECIES, shared.globals.id());
    glVertexArrayElementBuffer(s.mesh.id(), s.listed.id() ? s.listed.id() : s.indices.id());
    glBindVertexArray(s.mesh.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, s.commands.id());
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, s.seen, 0);
    ctx.pass->draws += 1;
    ctx.pass->instances += static_cast<uint64_t>(s.seen);
}

void draw(DrawContext& ctx) {
    GeometryState& state = ctx.own<GeometryState>();
    const Field* begun = nullptr;
    eachSpecies(ctx, state.species, Feature::GrassGeometry, [&](const Field& field, size_t i, SpeciesState& s) {
        if (begun != &field && !beginField(ctx, field, 0, fieldConstants(field.view->of))) return;
        begun = &field;
        drawSpecies(ctx, *field.species[i], s);
    });
    endTransparency();
}

const System kSystems[] = {
    {"grass/cull", {.reads = {Slot::Grass, Slot::Ground, Slot::Sun, Slot::Lamps}, .writes = {Slot::Blades}}, cull}};
const ProgramRow kPrograms[] = {
    {"grass/geometry", "grass/geometry.vert.glsl", "grass/geometry.frag.glsl", nullptr, fieldVariants}};
const ProgramRow kCellPrograms[] = {{"grass/geometry/choice", nullptr, nullptr, "grass/cells.comp.glsl"},
                                    {"grass/geometry/commands", nullptr, nullptr, "grass/cell_commands.comp.glsl"}};
const Pass kPasses[] = {{"grass/geometry/cells",
                         Stage::Simulate,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::Grass}, .appends = {Slot::BladeCells}},
                         kCellPrograms,
                         chooseThere},
                        {"grass/geometry",
                         Stage::Blades,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::Grass, Slot::Masks, Slot::BladeCells, Slot::Forces, Slot::Shadows},
                          .appends = {Slot::SceneColor, Slot::SceneDepth}},
                         kPrograms,
                         draw,
                         featureSet(Feature::GrassBlended)}};

}  // namespace

const EffectRow& geometryEffect() {
    static const EffectRow row{
        "grass/geometry",
        featureSet(Feature::GrassGeometry, Feature::Grass, Feature::Terrain),
        kSystems,
        kPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<GeometryState>(); },
        "blades near the eye are drawn one by one"};
    return row;
}

}  // namespace sward
