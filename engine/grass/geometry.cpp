#include "grass/geometry.h"

#include <chrono>

#include "core/numerics.h"
#include "frame/draw_context.h"
#include "grass/blade_list.h"
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
    std::vector<std::unique_ptr<SpeciesState>> species;
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
bool gpuChooses(const GrassField& f, const Gpu& gpu) {
    return f.culling == static_cast<int>(Culling::Gpu) ||
           (f.culling == static_cast<int>(Culling::Auto) && !gpu.software);
}

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

void publish(DrawContext& ctx, const SpeciesState& s, const FieldSpecies& own, size_t i) {
    BladeDraws& d = ctx.shared.blades[i];
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

void cull(DrawContext& ctx) {
    GeometryState& state = ctx.own<GeometryState>();
    const auto start = std::chrono::steady_clock::now();
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    if (!ctx.shared.grass) return;
    const FieldState& field = *ctx.shared.grass;
    const bool castingLamps = ctx.shared.lights.casting > 0;
    state.species.resize(field.species.size());
    ctx.shared.blades = {};
    for (size_t i = 0; i < state.species.size(); ++i) {
        if (!state.species[i]) state.species[i] = std::make_unique<SpeciesState>();
        SpeciesState& s = *state.species[i];
        const FieldSpecies& own = *field.species[i];
        updateMesh(ctx, s, own, f.species[i].segments);
        CellQuery query = drawnQuery(ctx, f, i);
        if (has(ctx.plan.features, Feature::GroundShadows))
            query.shadow = groundShadowReach(own.look.height, castingLamps ? 0 : ctx.globals.sunDirection.y);
        if (gpuChooses(f, ctx.gpu) && gpuMayChoose(query))
            selectThere(ctx, s, query);
        else
            selectHere(ctx, s, query, static_cast<Transparency>(f.transparency));
        describeCells(s.mesh.id(), s.cells.id(), sizeof(CellInstance), s.indices.id());
        publish(ctx, s, own, i);
        s.shadowShare =
            has(ctx.plan.features, Feature::GroundShadows) ? ctx.settings.detail * ctx.shared.blades[i].shading : 0;
    }
    ctx.stats.cpuCullMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

enum CellProgram { kChoose, kCommand };

void commandCells(const DrawContext& ctx, const SpeciesState& s) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_CELLS, s.cells.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_COMMANDS, s.commands.id());
    glUniform1ui(0, s.chosen.count);
    glUniform1ui(1, s.chosen.patchBlades);
    glUniform2f(2, std::clamp(ctx.settings.detail, 0.01f, 1.0f), std::clamp(s.shadowShare, 0.01f, 1.0f));
    glUniform1ui(3, s.shadowShare > 0 ? static_cast<GLuint>(std::min(s.segments, kShadowQuads)) : 0u);
    glDispatchCompute((s.chosen.count + 63) / 64, 1, 1);
}

// Where the GPU chooses: cells and their commands.
void chooseThere(DrawContext& ctx) {
    GeometryState& state = ctx.own<GeometryState>();
    for (size_t i = 0; i < state.species.size() && ctx.shared.grass; ++i) {
        SpeciesState& s = *state.species[i];
        if (!s.chosen.byGpu || s.chosen.count == 0 || !ctx.use(kChoose)) continue;
        runChoice(s.chosen, ctx.shared.densities[i]);
        if (ctx.use(kCommand)) commandCells(ctx, s);
        if (ctx.settings.measure) recount(ctx, s.chosen);
    }
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void draw(DrawContext& ctx) {
    GeometryState& state = ctx.own<GeometryState>();
    if (!ctx.shared.grass) return;
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    if (!ctx.use(0, fieldConstants(f))) return;
    beginTransparency(ctx, f);
    for (size_t i = 0; i < state.species.size(); ++i) {
        SpeciesState& s = *state.species[i];
        const FieldSpecies& shared = *ctx.shared.grass->species[i];
        if (s.seen == 0) continue;
        glBindTextureUnit(TEX_BLADE, shared.bladeTexture.id());
        if (ctx.shared.shades[i].texture) glBindTextureUnit(TEX_MASK, ctx.shared.shades[i].texture);
        if (ctx.shared.densities[i]) glBindTextureUnit(TEX_DENSITY, ctx.shared.densities[i]);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_BLADES, s.blades.id());
        glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SPECIES, shared.globals.id());
        glVertexArrayElementBuffer(s.mesh.id(), s.listed.id() ? s.listed.id() : s.indices.id());
        glBindVertexArray(s.mesh.id());
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, s.commands.id());
        glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, s.seen, 0);
        ctx.pass->draws += 1;
        ctx.pass->instances += static_cast<uint64_t>(s.seen);
    }
    endTransparency();
}

const System kSystems[] = {{"grass/cull", cull}};
const ProgramRow kPrograms[] = {
    {"grass/geometry", "grass/geometry.vert.glsl", "grass/geometry.frag.glsl", nullptr,
     featureSet(Feature::TerrainHeights, Feature::GrassDensity, Feature::GrassOrientation, Feature::GrassVegetation,
                Feature::GrassHeights, Feature::GrassOcclusion, Feature::GrassClumps, Feature::Wind, Feature::Gusts,
                Feature::Forces, Feature::ForceMap, Feature::FarDarkening, Feature::Translucency, Feature::Gloss,
                Feature::BladeShadows, Feature::CastingLights, Feature::ObjectShadows, Feature::TerrainShadows,
                Feature::Sun, Feature::Lamps, Feature::Sky, Feature::Fog, Feature::WaterReflection),
     fieldVariants}};
const ProgramRow kCellPrograms[] = {
    {"grass/geometry/choice", nullptr, nullptr, "grass/cells.comp.glsl", featureSet(Feature::GrassDensity)},
    {"grass/geometry/commands", nullptr, nullptr, "grass/cell_commands.comp.glsl", {}}};
const Pass kPasses[] = {{"grass/geometry/cells", Stage::Simulate, kViewMain | kViewReflection | kViewCompare, 0, 0,
                         kCellPrograms, chooseThere},
                        {"grass/geometry", Stage::Blades, kViewMain | kViewReflection | kViewCompare, 0,
                         kSceneColor | kSceneDepth, kPrograms, draw}};

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
