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

// Blades of a species as the GPU holds them.
struct BladeMesh {
    uint64_t key = 0;  // of the patch that it was made from
    int segments = 0;
    size_t strips = 0;  // blades that the indices hold, and whether they are a cell's own: as drawCommand takes them
    uint32_t verticesABlade = 0;
    Buffer blades, indices;
};
struct GeometryState : EffectState {
    PerSpecies<BladeMesh> meshes;
};
// Those of them that a view draws.
struct BladeSelection {
    BladeMesh* mesh = nullptr;
    Buffer cells, commands;
    Buffer listed;     // indices of the blades that can be seen, where the driver shades vertices on the CPU; else none
    GLsizei seen = 0;  // commands
    VertexArray vertices;
    std::vector<CellDraw> selected;
    ChosenCells chosen;     // where the GPU chooses; else nothing
    float shadowShare = 0;  // of the blades, that shade the soil
};
struct GeometryView : EffectState {
    PerSpecies<BladeSelection> species;
};

// For each n up to `segments`, all blades' strips of n quads in threshold order, over the first of the same
// 2 (segments + 1) vertices a blade, which the shader spreads evenly (lib/strip.glsl).
std::vector<uint32_t> stripIndices(size_t blades, int segments) {
    std::vector<uint32_t> out;
    out.reserve(blades * firstStrip(segments + 1));
    for (int n = 1; n <= segments; ++n)
        for (size_t b = 0; b < blades; ++b) addStrip(out, static_cast<uint32_t>(b), n, segments);
    return out;
}

void updateMesh(DrawContext& ctx, BladeMesh& m, const GrownSpecies& species, int segments) {
    if (m.key == species.drawnKey() && m.segments == segments && m.blades.id()) return;
    m.key = species.drawnKey();
    m.segments = segments;
    m.strips = species.unique.empty() ? species.patch.blades.size() : species.unique.mostInCell;
    m.verticesABlade = species.unique.empty() ? 0 : 2 * static_cast<uint32_t>(segments + 1);
    const auto indices = stripIndices(m.strips, segments);
    const std::vector<Blade>& blades = species.drawn().blades;
    m.blades = makeBuffer(ctx.gpu, kOwner, blades.size() * sizeof(Blade), blades.data());
    m.indices = makeBuffer(ctx.gpu, kOwner, indices.size() * 4, indices.data());
}

void updateBladeMeshes(DrawContext& ctx) {
    GeometryState& state = ctx.own<GeometryState>();
    if (!ctx.shared.grown) return;
    state.meshes.keep(ctx.shared.grown->all, Feature::GrassGeometry);
    eachGrown(ctx, Feature::GrassGeometry, [&](const GrownField& field, size_t i) {
        updateMesh(ctx, state.meshes.at(field.number, i), *field.species[i], field.grows().species[i].segments);
    });
}

void uploadCommands(DrawContext& ctx, BladeSelection& s, const std::vector<DrawCommand>& commands, uint64_t blades) {
    writeBuffer(ctx.gpu, s.commands, kOwner, commands.size() * sizeof(DrawCommand), commands.data());
    s.seen = static_cast<GLsizei>(commands.size());
    ctx.stats.cells += commands.size();
    ctx.stats.bladesGeometry += blades;
}

// One command a cell, over a range of the patch's blades.
void commandRanges(DrawContext& ctx, BladeSelection& s) {
    std::vector<DrawCommand> commands;
    commands.reserve(s.selected.size());
    uint64_t blades = 0;
    for (size_t i = 0; i < s.selected.size(); ++i) {
        const CellDraw& c = s.selected[i];
        if (!c.seen) continue;
        commands.push_back(drawCommand(c, c.segments, static_cast<uint32_t>(s.mesh->strips), ctx.settings.detail,
                                       static_cast<uint32_t>(i), s.mesh->verticesABlade));
        blades += bladesDrawn(c, ctx.settings.detail);
    }
    s.listed = {};
    uploadCommands(ctx, s, commands, blades);
}

// One command a cell, over those of its blades that can be seen.
void commandLists(DrawContext& ctx, BladeSelection& s, const CellQuery& query, Transparency way) {
    const PixelCoverage shown{way, ctx.targets.samples, ctx.globals.chanceShift};
    const BladeList list = listBlades({query, query.reach, shown, ctx.settings.detail}, s.selected);
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
void selectHere(DrawContext& ctx, BladeSelection& s, const CellQuery& query, Transparency way) {
    s.chosen = {};
    s.selected = selectCells(query);
    std::vector<CellInstance> instances;
    instances.reserve(s.selected.size());
    for (const CellDraw& c : s.selected)
        instances.push_back({{c.cellX, c.cellZ}, {c.x, c.z}, c.mirror, c.shift, std::max(c.segments, 1), 0});
    writeBuffer(ctx.gpu, s.cells, kOwner, instances.size() * sizeof(CellInstance), instances.data());
    if (ctx.gpu.software)
        commandLists(ctx, s, query, way);
    else
        commandRanges(ctx, s);
}

// Room for what the GPU chooses: as many instances and commands as there are cells in the nodes, and as many commands
// of shadows.
void selectThere(DrawContext& ctx, BladeSelection& s, const CellQuery& query) {
    s.selected.clear();
    s.listed = {};
    chooseCells(ctx, s.chosen,
                {query, s.mesh->key, 1, std::clamp(ctx.settings.detail, kLeastDetail, 1.0f), 0, kMaxPatchBlades, true},
                kOwner);
    writeBuffer(ctx.gpu, s.cells, kOwner, s.chosen.count * sizeof(CellInstance), nullptr);
    writeBuffer(ctx.gpu, s.commands, kOwner, 2 * s.chosen.count * sizeof(DrawCommand), nullptr);
    s.seen = static_cast<GLsizei>(s.chosen.count);
}

void publish(const DrawContext& ctx, const BladeSelection& s, FieldSpecies& own) {
    const BladeMesh& m = *s.mesh;
    BladeDraws& d = own.draws;
    d = {s.vertices.id(), m.indices.id(), m.blades.id(), own.grown->globals.id(), s.selected.data(), s.selected.size()};
    d.strips = static_cast<uint32_t>(m.strips);
    d.segments = m.segments;
    d.verticesABlade = m.verticesABlade;
    // Lamps stand as high over their grass as may be.
    d.shading = shadingShare(own.grown->look, ctx.shared.lights.casting > 0 ? 1 : ctx.globals.sunDirection.y);
    if (!s.chosen.byGpu) return;
    d.count = s.chosen.count;
    d.shadowCommands = s.commands.id();
    d.shadowOffset = s.chosen.count * sizeof(DrawCommand);
}

void cullSpecies(DrawContext& ctx, Field& field, size_t i, BladeSelection& s) {
    FieldSpecies& own = field.species[i];
    const auto& drawing = field.view->settings<GrassDrawing>();
    const bool shades = field.draws(Feature::GroundShadows);
    s.mesh = &ctx.own<GeometryState>().meshes.at(field.number, i);
    if (!s.vertices.id()) s.vertices = makeVertexArray(kOwner);
    CellQuery query = drawnQuery(ctx, field, i);
    if (shades) query.shadow = groundShadowReach(ctx, field, i);
    if (gpuChooses(drawing.culling, ctx.gpu) && gpuMayChoose(query))
        selectThere(ctx, s, query);
    else
        selectHere(ctx, s, query, drawing.transparency);
    describeCells(s.vertices.id(), s.cells.id(), sizeof(CellInstance), s.mesh->indices.id());
    glEnableVertexArrayAttrib(s.vertices.id(), 4);
    glVertexArrayAttribBinding(s.vertices.id(), 4, 0);
    glVertexArrayAttribIFormat(s.vertices.id(), 4, 1, GL_INT, offsetof(CellInstance, quads));
    publish(ctx, s, own);
    s.shadowShare = shades ? ctx.settings.detail * own.draws.shading : 0;
}

void cull(DrawContext& ctx) {
    GeometryView& view = ctx.ofView<GeometryView>();
    const auto start = std::chrono::steady_clock::now();
    if (!ctx.shared.grass) return;
    view.species.keep(ctx.shared.grass->all, Feature::GrassGeometry);
    eachSpecies(ctx, Feature::GrassGeometry,
                [&](Field& field, size_t i) { cullSpecies(ctx, field, i, view.species.at(field.number, i)); });
    ctx.stats.cpuCullMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

enum CellProgram { kChoose, kCommand };

void commandCells(const DrawContext& ctx, const BladeSelection& s) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_CELLS, s.cells.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_COMMANDS, s.commands.id());
    glUniform1ui(0, s.chosen.count);
    glUniform1ui(1, s.chosen.patchBlades);
    glUniform1f(2, std::clamp(ctx.settings.detail, kLeastDetail, 1.0f));
    glUniform1f(3, std::clamp(s.shadowShare, kLeastDetail, 1.0f));
    glUniform1ui(4, s.shadowShare > 0 ? static_cast<GLuint>(std::min(s.mesh->segments, kShadowQuads)) : 0u);
    glDispatchCompute((s.chosen.count + 63) / 64, 1, 1);
}

// Where the GPU chooses: cells and their commands.
void chooseThere(DrawContext& ctx) {
    GeometryView& view = ctx.ofView<GeometryView>();
    eachSpecies(ctx, Feature::GrassGeometry, [&](const Field& field, size_t i) {
        BladeSelection& s = view.species.at(field.number, i);
        const std::string* features = &field.view->constants;
        if (!s.chosen.byGpu || s.chosen.count == 0 || !ctx.use(kChoose, {}, features)) return;
        bindField(field);
        runChoice(s.chosen, field.grown->species[i]->density);
        if (ctx.use(kCommand, {}, features)) commandCells(ctx, s);
        recount(ctx, s.chosen);
    });
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void drawSpecies(DrawContext& ctx, const GrownSpecies& shared, const BladeSelection& s) {
    const BladeMesh& mesh = *s.mesh;
    if (s.seen == 0) return;
    glBindTextureUnit(TEX_BLADE, shared.bladeTexture.id());
    if (shared.shade.texture) glBindTextureUnit(TEX_MASK, shared.shade.texture);
    if (shared.density) glBindTextureUnit(TEX_DENSITY, shared.density);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_BLADES, mesh.blades.id());
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SPECIES, shared.globals.id());
    glVertexArrayElementBuffer(s.vertices.id(), s.listed.id() ? s.listed.id() : mesh.indices.id());
    glBindVertexArray(s.vertices.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, s.commands.id());
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, s.seen, 0);
    ctx.pass->draws += 1;
    ctx.pass->instances += static_cast<uint64_t>(s.seen);
}

void drawBlades(DrawContext& ctx) {
    GeometryView& view = ctx.ofView<GeometryView>();
    const Field* begun = nullptr;
    eachSpecies(ctx, Feature::GrassGeometry, [&](const Field& field, size_t i) {
        if (begun != &field && !beginField(ctx, field, 0, fieldConstants(field.view->of))) return;
        begun = &field;
        drawSpecies(ctx, *field.grown->species[i], view.species.at(field.number, i));
    });
    endTransparency();
}

const System kSystems[] = {
    {"grass/geometry/meshes", {.reads = {Slot::Grown}, .appends = {Slot::Meshes}}, updateBladeMeshes, true},
    {"grass/cull",
     {.reads = {Slot::Grass, Slot::Meshes, Slot::Ground, Slot::Sun, Slot::Lamps}, .writes = {Slot::Blades}},
     cull}};
const ProgramRow kPrograms[] = {
    {"grass/geometry", "grass/geometry.vert.glsl", "grass/blade.frag.glsl", nullptr, fieldVariants}};
const ProgramRow kChoicePrograms[] = {{"grass/geometry/choice", nullptr, nullptr, "grass/cells.comp.glsl"},
                                      {"grass/geometry/commands", nullptr, nullptr, "grass/cell_commands.comp.glsl"}};
const Pass kPasses[] = {
    {"grass/geometry/cells",
     Stage::Simulate,
     kViewMain | kViewReflection,
     {.reads = {Slot::Grass}, .appends = {Slot::BladeCells}},
     kChoicePrograms,
     chooseThere},
    {"grass/geometry",
     Stage::Blades,
     kViewMain | kViewReflection,
     {.reads = {Slot::Grass, Slot::Masks, Slot::BladeCells, Slot::Forces, Slot::Shadows, Slot::ObjectLight},
      .appends = {Slot::SceneColor, Slot::SceneDepth}},
     kPrograms,
     drawBlades,
     featureSet(Feature::GrassBlended),
     false,
     true}};
const Follows kFollows[] = {{Feature::Wind, "blades bend and quiver each by itself"},
                            {Feature::Forces, "blades are laid down each its own way"},
                            {Feature::ForceMap, "blades are laid down each its own way"}};

}  // namespace

const EffectRow& geometryEffect() {
    static const EffectRow row{
        .name = "grass/geometry",
        .needs = featureSet(Feature::GrassGeometry, Feature::Grass, Feature::Terrain),
        .systems = kSystems,
        .passes = kPasses,
        .makeState = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<GeometryState>(); },
        .help = "blades near the eye are drawn one by one",
        .makeView = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<GeometryView>(); },
        .follows = kFollows};
    return row;
}

}  // namespace sward
