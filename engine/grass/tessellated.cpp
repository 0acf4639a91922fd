#include "grass/tessellated.h"

#include <chrono>

#include "core/numerics.h"
#include "frame/draw_context.h"
#include "grass/drawing.h"
#include "grass/field.h"
#include "grass/gpu_cells.h"
#include "grass/tessellated_settings.h"
#include "shared/tess.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/tessellated";
constexpr float kNearTo = 0.05f;      // metres: the near plane
constexpr float kMostWidening = 6;    // of blades, where others are left out
constexpr float kPlainPixels = 1.5f;  // blades of one quad that are thinner are plain triangles
constexpr uint32_t kSoftwarePiece = 256,
                   kPiece = 32;     // blades that one invocation writes: their survivors lie without gaps
constexpr uint32_t kMostRows = 65;  // of a blade
// Software rasterisers take a way whose time grows with the square of the vertices if stages make more of a draw than
// 16 bits count.
constexpr uint32_t kSoftwareVertices = 65535;
constexpr uint32_t kCommandBytes = 20, kPlainCommandBytes = 16;
constexpr size_t kBatchBytes = 128u << 20;  // of vertices that are there at once

// What all views share of a species: its blades, and how the rows of strips are joined.
struct PieceMesh {
    uint64_t key = 0;
    int indicesTo = 0;
    Buffer blades, indices;
};
struct TessState : EffectState {
    PerSpecies<PieceMesh> meshes;
    VertexArray patches;
};
// What a view draws of a species.
struct PatchSelection {
    PieceMesh* mesh = nullptr;
    Buffer cells, list, globals;
    Buffer commands, vertices;  // room for one batch
    VertexArray strips;
    std::array<uint64_t, 3> described{};  // by what buffers, and the size of a vertex
    ChosenCells chosen;
    uint32_t batches = 0, batchVertices = 0, batchPieces = 0;  // at most
    uint32_t drawPoints = 1, pointDraws = 0;                   // of stages: blades of a draw at most, and draws
};
struct TessView : EffectState {
    PerSpecies<PatchSelection> species;
};

bool stagesChosen(Tessellation way, const Gpu& gpu) {
    return way == Tessellation::Stages || (way == Tessellation::Auto && !gpu.software);
}

// --- what shaders know of a species ----------------------------------------------------------------------------------

float mostWidening(const TessellatedBlades& f) {
    return f.widening ? std::min(1 / std::max(1 - f.thinning, 1e-3f), kMostWidening) : 1;
}

// How the distance thins a species: up to allTo each blade is leastPixels wide by itself, or wider.
f32::Thinning thinningOf(const TessellatedBlades& f, const Species& species, float pixelsPerMetre) {
    const float allTo =
        f.leastPixels > 0 ? std::max(species.width, 1e-6f) * pixelsPerMetre / f.leastPixels : kAllBlades.allTo;
    return {f.thinning / f.maxDistance, allTo};
}
// How much wider blades become with each metre, where pixels thin them.
float widerAMetre(const TessellatedBlades& f, const f32::Thinning& t) { return f.widening ? 1 / t.allTo : 0; }
// Of the widest blades of a species.
float greatestWidth(const DrawContext& ctx, const TessellatedBlades& f, const Species& species,
                    const f32::Thinning& t) {
    return species.width * std::max(mostWidening(f), f.maxDistance * widerAMetre(f, t)) * ctx.globals.widening;
}

TessGlobals globalsOf(const DrawContext& ctx, const TessellatedBlades& f, const Species& species) {
    TessGlobals g{};
    g.pixelsPerMetre = pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));
    g.maxDistance = f.maxDistance;
    const f32::Thinning thinned = thinningOf(f, species, g.pixelsPerMetre);
    g.missing = thinned.missing, g.allTo = thinned.allTo;
    g.lowerInv = 1 / std::max(f.maxDistance * (1 - f.lowerFrom), 1e-6f);
    g.widest = mostWidening(f);
    g.widerAMetre = widerAMetre(f, thinned);
    g.mostLevel = static_cast<float>(species.smoothness);
    g.pixelsPerQuad = f.levelBy == LevelBy::Pixels ? f.pixelsPerQuad : 0;
    g.near = kNearTo;
    g.plainPixels = kPlainPixels;
    return g;
}

void updateMesh(DrawContext& ctx, PieceMesh& m, const GrownSpecies& species) {
    const std::vector<Blade>& blades = species.drawn().blades;
    if (m.key != species.drawnKey() || !m.blades.id())
        m.blades = makeBuffer(ctx.gpu, kOwner, blades.size() * sizeof(Blade), blades.data());
    m.key = species.drawnKey();
}

void updatePatchMeshes(DrawContext& ctx) {
    TessState& state = ctx.own<TessState>();
    if (!ctx.shared.grown) return;
    state.meshes.keep(ctx.shared.grown->all, Feature::GrassTessellated);
    eachGrown(ctx, Feature::GrassTessellated, [&](const GrownField& field, size_t i) {
        updateMesh(ctx, state.meshes.at(field.number, i), *field.species[i]);
    });
}

// --- cells, in pieces, and the batches in which they are drawn ---------------------------------------------

bool bladesShadeBlades(const FeatureSet& f) { return has(f, Feature::BladeShadows) && has(f, Feature::CastingLights); }
size_t vertexBytes(const FeatureSet& features) {
    const size_t lit = bladesShadeBlades(features) ? 12 : 8;
    return 4 * (lit + (has(features, Feature::Temporal) ? 2 : 0));
}
uint32_t pieceBlades(const Gpu& gpu) { return gpu.software ? kSoftwarePiece : kPiece; }

// A row of stages has three vertices.
void planPoints(const Gpu& gpu, PatchSelection& s, int smoothness) {
    s.drawPoints = gpu.software ? kSoftwareVertices / (3 * static_cast<uint32_t>(smoothness + 1))
                                : std::numeric_limits<int32_t>::max();
    s.pointDraws = static_cast<uint32_t>((s.chosen.allBlades + s.drawPoints - 1) / s.drawPoints);
}

// A batch is what begins within batchVertices; its last piece may end beyond.
void planBatches(const Gpu& gpu, const FeatureSet& features, PatchSelection& s) {
    const uint64_t piece = uint64_t{pieceBlades(gpu)} * 2 * kMostRows;
    const uint64_t most = kBatchBytes / vertexBytes(features) - piece;
    s.batchVertices = static_cast<uint32_t>(std::clamp<uint64_t>(s.chosen.vertices, 1, most));
    s.batches = static_cast<uint32_t>((s.chosen.vertices + s.batchVertices - 1) / s.batchVertices);
    // A cell's blades are shared out evenly, so that of its pieces all but the only one hold half of what a piece may.
    s.batchPieces = static_cast<uint32_t>(
        std::min(s.chosen.pieces, s.chosen.count + uint64_t{s.batchVertices} / (3 * pieceBlades(gpu) / 2) + 1));
}

CellQuery queryOf(const DrawContext& ctx, const Field& field, size_t i) {
    const auto& f = field.view->settings<TessellatedBlades>();
    const float pixels = pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));
    const Species& species = field.grows().species[i];
    CellQuery q = drawnQuery(ctx, field, i);
    q.thinning = thinningOf(f, species, pixels);
    q.reach += greatestWidth(ctx, f, species, q.thinning) - species.width;
    q.levels = {species.smoothness, f.maxDistance, 0, q.reach};
    if (f.levelBy == LevelBy::Pixels) q.levels.quadsAtOneMetre = q.reach * pixels / f.pixelsPerQuad;
    return q;
}

// Metres from which blades of one quad are plain triangles, whichever way they are thinned.
float plainFrom(const DrawContext& ctx, const TessellatedBlades& f, const Species& species) {
    constexpr float kMostVaried = 1.25f, kMost = 0.999f * kPlainPixels;
    const float widening = kMostVaried * ctx.globals.widening;
    if (f.widening && f.leastPixels * widening > kMost) return std::numeric_limits<float>::max();
    const float pixels = pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));
    return species.width * mostWidening(f) * widening * pixels / kMost;
}

void selectSpecies(DrawContext& ctx, const Field& field, size_t i, PatchSelection& s) {
    const auto& f = field.view->settings<TessellatedBlades>();
    const Species& species = field.grows().species[i];
    s.mesh = &ctx.own<TessState>().meshes.at(field.number, i);
    const TessGlobals g = globalsOf(ctx, f, species);
    writeBuffer(ctx.gpu, s.globals, kOwner, sizeof(g), &g);
    const CellQuery query = queryOf(ctx, field, i);
    const bool byGpu = field.view->settings<GrassDrawing>().culling != Culling::Cpu && gpuMayChoose(query);
    chooseCells(ctx, s.chosen,
                {query, s.mesh->key, ctx.settings.detail, 1, plainFrom(ctx, f, species), pieceBlades(ctx.gpu), byGpu},
                kOwner);
    planBatches(ctx.gpu, field.view->features, s);
    planPoints(ctx.gpu, s, species.smoothness);
    writeBuffer(ctx.gpu, s.cells, kOwner, (s.chosen.pieces + 1) * sizeof(TessCell), nullptr);
    writeBuffer(ctx.gpu, s.list, kOwner, (LIST_BATCHES + 4 * (s.batches + 1 + s.pointDraws)) * sizeof(uint32_t),
                nullptr);
}

void selectTessellated(DrawContext& ctx) {
    TessView& view = ctx.ofView<TessView>();
    if (!ctx.shared.grass) return;
    const auto start = std::chrono::steady_clock::now();
    view.species.keep(ctx.shared.grass->all, Feature::GrassTessellated);
    eachSpecies(ctx, Feature::GrassTessellated,
                [&](const Field& field, size_t i) { selectSpecies(ctx, field, i, view.species.at(field.number, i)); });
    ctx.stats.cpuCullMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

enum ChoiceProgram { kChoosePieces, kListPieces };

void listSpecies(DrawContext& ctx, const Field& field, size_t i, PatchSelection& s) {
    if (!ctx.use(kChoosePieces, {}, &field.view->constants)) return;
    runChoice(s.chosen, field.grown->species[i]->density);
    if (!ctx.use(kListPieces, {}, &field.view->constants)) return;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_CELLS, s.cells.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_LIST, s.list.id());
    glUniform4ui(0, s.chosen.count, s.batchVertices, s.batches, s.drawPoints);
    glUniform1ui(1, s.pointDraws);
    glDispatchCompute(1, 1, 1);
    recount(ctx, s.chosen);
}

void listCells(DrawContext& ctx) {
    TessView& view = ctx.ofView<TessView>();
    eachSpecies(ctx, Feature::GrassTessellated,
                [&](const Field& field, size_t i) { listSpecies(ctx, field, i, view.species.at(field.number, i)); });
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

// --- drawing ---------------------------------------------------------------------------------------------------------

void bindSpecies(const GrownSpecies& shared, const PatchSelection& s) {
    glBindTextureUnit(TEX_BLADE, shared.bladeTexture.id());
    if (shared.shade.texture) glBindTextureUnit(TEX_MASK, shared.shade.texture);
    if (shared.density) glBindTextureUnit(TEX_DENSITY, shared.density);
    static_assert(SSBO_CELLS == SSBO_BLADES + 1 && SSBO_VERTICES == SSBO_BLADES + 2 &&
                  SSBO_COMMANDS == SSBO_BLADES + 3 && SSBO_LIST == SSBO_BLADES + 4);
    const GLuint buffers[] = {s.mesh->blades.id(), s.cells.id(), s.vertices.id(), s.commands.id(), s.list.id()};
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, SSBO_BLADES, 5, buffers);
    static_assert(UBO_TESS == UBO_SPECIES + 1);
    const GLuint globals[] = {shared.globals.id(), s.globals.id()};
    glBindBuffersBase(GL_UNIFORM_BUFFER, UBO_SPECIES, 2, globals);
}

enum PatchProgram { kStages, kWriter, kInStrips, kPlain };

void drawPatches(DrawContext& ctx, const GrownSpecies& shared, const PatchSelection& s) {
    if (s.chosen.pieces == 0) return;
    bindSpecies(shared, s);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, s.list.id());
    glMultiDrawArraysIndirect(GL_PATCHES,
                              reinterpret_cast<const void*>((LIST_BATCHES + 4 * (s.batches + 1)) * sizeof(uint32_t)),
                              static_cast<GLsizei>(s.pointDraws), 0);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

// Quads are cut as tessellation stages cut them (Mesa's, and Direct3D's), the lower half's across the upper's: with
// several samples a pixel's alpha is taken within its triangle.
std::vector<uint32_t> stripIndices(int most, uint32_t blades) {
    std::vector<uint32_t> out;
    out.reserve(firstStrip(most + 1) * blades);
    for (int n = 1; n <= most; ++n)
        for (uint32_t b = 0; b < blades; ++b)
            for (uint32_t row = 0; row < static_cast<uint32_t>(n); ++row) {
                const uint32_t a = 2 * (b * static_cast<uint32_t>(n + 1) + row), c = a + 2;
                if (row < static_cast<uint32_t>(n) / 2)
                    out.insert(out.end(), {a, a + 1, c + 1, a, c + 1, c});
                else
                    out.insert(out.end(), {a, a + 1, c, c, a + 1, c + 1});
            }
    return out;
}

struct Attribute {
    GLint size;
    GLenum type;
    GLuint offset;
};
// By location, as tessellated_strip.vert.glsl has them: always; where blades shade blades; and where frames add up.
constexpr Attribute kDrawn[] = {
    {4, GL_FLOAT, 0}, {4, GL_HALF_FLOAT, 16}, {2, GL_UNSIGNED_SHORT, 24}, {1, GL_UNSIGNED_INT, 28}};
constexpr Attribute kShaded[] = {
    {4, GL_HALF_FLOAT, 32}, {1, GL_SHORT, 40}, {1, GL_HALF_FLOAT, 42}, {1, GL_SHORT, 44}, {2, GL_UNSIGNED_BYTE, 46}};
constexpr GLuint kMovedAt = 9;

void describe(GLuint mesh, GLuint location, const Attribute& a) {
    glEnableVertexArrayAttrib(mesh, location);
    glVertexArrayAttribBinding(mesh, location, 0);
    if (a.type == GL_UNSIGNED_INT)
        glVertexArrayAttribIFormat(mesh, location, a.size, a.type, a.offset);
    else
        glVertexArrayAttribFormat(mesh, location, a.size, a.type, a.type != GL_FLOAT && a.type != GL_HALF_FLOAT,
                                  a.offset);
}
void describeVertices(GLuint mesh, GLuint vertices, const FeatureSet& features) {
    const bool shaded = bladesShadeBlades(features), moved = has(features, Feature::Temporal);
    glVertexArrayVertexBuffer(mesh, 0, vertices, 0, static_cast<GLsizei>(vertexBytes(features)));
    for (GLuint i = 0; i <= kMovedAt; ++i) glDisableVertexArrayAttrib(mesh, i);
    for (GLuint i = 0; i < std::size(kDrawn); ++i) describe(mesh, i, kDrawn[i]);
    for (GLuint i = 0; shaded && i < std::size(kShaded); ++i)
        describe(mesh, static_cast<GLuint>(std::size(kDrawn)) + i, kShaded[i]);
    if (moved) describe(mesh, kMovedAt, {3, GL_HALF_FLOAT, shaded ? 48u : 32u});
}

void prepareStrips(DrawContext& ctx, PatchSelection& s, const FeatureSet& features, int smoothness) {
    PieceMesh& m = *s.mesh;
    const size_t size = vertexBytes(features), over = std::min<uint64_t>(s.chosen.blades, pieceBlades(ctx.gpu)) * 2 *
                                                      static_cast<uint64_t>(smoothness + 1);
    writeBuffer(ctx.gpu, s.vertices, kOwner, (s.batchVertices + over) * size, nullptr);
    writeBuffer(ctx.gpu, s.commands, kOwner, s.batchPieces * (kCommandBytes + kPlainCommandBytes), nullptr);
    if (m.indicesTo != smoothness) {
        const auto indices = stripIndices(smoothness, pieceBlades(ctx.gpu));
        m.indices = makeBuffer(ctx.gpu, kOwner, indices.size() * 4, indices.data());
        m.indicesTo = smoothness;
    }
    const std::array<uint64_t, 3> described{s.vertices.id(), m.indices.id(), size};
    if (s.strips.id() && s.described == described) return;
    s.described = described;
    if (!s.strips.id()) s.strips = makeVertexArray(kOwner);
    describeVertices(s.strips.id(), s.vertices.id(), features);
    glVertexArrayElementBuffer(s.strips.id(), m.indices.id());
}

// What strips are compiled with and for.
struct StripPrograms {
    std::string constants;
    const std::string* features;
};

bool writeStrips(DrawContext& ctx, const PatchSelection& s, uint32_t batch, const StripPrograms& p) {
    if (!ctx.use(kWriter, p.constants, p.features)) return false;
    glUniform4ui(0, batch, batch * s.batchVertices, s.batchPieces, pieceBlades(ctx.gpu));
    glClearNamedBufferData(s.commands.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    glDispatchComputeIndirect(static_cast<GLintptr>((LIST_BATCHES + 4 * batch) * sizeof(uint32_t)));
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);  // the next batch writes there
    return true;
}

void drawStrips(DrawContext& ctx, const PatchSelection& s, const StripPrograms& p) {
    const auto commands = static_cast<GLsizei>(s.batchPieces);
    if (!ctx.use(kInStrips, p.constants, p.features)) return;
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, commands, kCommandBytes);
    if (!ctx.use(kPlain, p.constants, p.features)) return;
    glMultiDrawArraysIndirect(GL_TRIANGLES, reinterpret_cast<const void*>(uintptr_t{s.batchPieces} * kCommandBytes),
                              commands, kPlainCommandBytes);
    ctx.pass->draws += 2;
    ctx.pass->instances += 2 * static_cast<uint64_t>(commands);
}

void drawBatches(DrawContext& ctx, const Field& field, size_t i, PatchSelection& s, const StripPrograms& p) {
    if (s.chosen.pieces == 0) return;
    prepareStrips(ctx, s, field.view->features, field.grows().species[i].smoothness);
    bindSpecies(*field.grown->species[i], s);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, s.list.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, s.commands.id());
    glBindVertexArray(s.strips.id());
    for (uint32_t b = 0; b < s.batches; ++b)
        if (writeStrips(ctx, s, b, p)) drawStrips(ctx, s, p);
}

// Whether a blade shows all of a sample or nothing: what strips are compiled with, beside what all of the field's
// shaders are.
std::string allOrNothing(Transparency way, int samples) {
    return fmt::format("const bool ALL_OR_NOTHING = {};\n", samples == 1 && way == Transparency::Coverage);
}

// Patches' program and the field's maps, made current.
bool beginPatches(DrawContext& ctx, TessState& state, const Field& field) {
    if (!beginField(ctx, field, kStages, fieldConstants(field.view->of))) return false;
    if (!state.patches.id()) state.patches = makeVertexArray(kOwner);
    glBindVertexArray(state.patches.id());
    glPatchParameteri(GL_PATCH_VERTICES, 1);
    return true;
}
StripPrograms beginStrips(const DrawContext& ctx, const Field& field) {
    bindField(field);
    beginTransparency(ctx, field);
    return {fieldConstants(field.view->of) +
                allOrNothing(field.view->settings<GrassDrawing>().transparency, ctx.targets.samples),
            &field.view->constants};
}

void drawTessellated(DrawContext& ctx) {
    TessState& state = ctx.own<TessState>();
    TessView& view = ctx.ofView<TessView>();
    const Field* begun = nullptr;
    StripPrograms programs;
    eachSpecies(ctx, Feature::GrassTessellated, [&](const Field& field, size_t i) {
        PatchSelection& s = view.species.at(field.number, i);
        const bool stages = stagesChosen(field.view->settings<TessellatedBlades>().tessellation, ctx.gpu);
        if (begun && begun != &field) endTransparency();  // of the field before
        if (begun != &field && stages && !beginPatches(ctx, state, field)) return;
        if (begun != &field && !stages) programs = beginStrips(ctx, field);
        begun = &field;
        if (stages)
            drawPatches(ctx, *field.grown->species[i], s);
        else
            drawBatches(ctx, field, i, s, programs);
    });
    endTransparency();
}

std::vector<std::string> stripVariants() {
    std::vector<std::string> out;
    GrassDrawing drawing;
    for (const Transparency way : {Transparency::Coverage, Transparency::Both, Transparency::Test, Transparency::Blend})
        for (const int samples : {1, 4}) {
            drawing.transparency = way;
            out.push_back(fieldConstants(drawing, {}) + allOrNothing(way, samples));
        }
    return out;
}

const System kSystems[] = {
    {"grass/tessellated/meshes", {.reads = {Slot::Grown}, .appends = {Slot::Meshes}}, updatePatchMeshes, true},
    {"grass/tessellated/select", {.reads = {Slot::Grass, Slot::Meshes, Slot::Ground}}, selectTessellated}};
const ProgramRow kPrograms[] = {
    {"grass/tessellated/stages", "grass/tessellated.vert.glsl", "grass/blade.frag.glsl", nullptr, fieldVariants,
     "grass/tessellated.tesc.glsl", "grass/tessellated.tese.glsl"},
    {"grass/tessellated/writer", nullptr, nullptr, "grass/tessellated.comp.glsl", stripVariants},
    {"grass/tessellated/strips", "grass/tessellated_strip.vert.glsl", "grass/blade.frag.glsl", nullptr, stripVariants},
    {"grass/tessellated/plain", "grass/tessellated_strip.vert.glsl", "grass/tessellated_plain.frag.glsl", nullptr,
     stripVariants},
};
const ProgramRow kPatchPrograms[] = {{"grass/tessellated/choice", nullptr, nullptr, "grass/cells.comp.glsl"},
                                     {"grass/tessellated/list", nullptr, nullptr, "grass/cell_list.comp.glsl"}};
const Pass kPasses[] = {
    {"grass/tessellated/cells",
     Stage::Simulate,
     kViewMain | kViewReflection,
     {.reads = {Slot::Grass}, .appends = {Slot::BladeCells}},
     kPatchPrograms,
     listCells},
    {"grass/tessellated",
     Stage::Blades,
     kViewMain | kViewReflection,
     {.reads = {Slot::Grass, Slot::Masks, Slot::BladeCells, Slot::Forces, Slot::Shadows, Slot::ObjectLight},
      .appends = {Slot::SceneColor, Slot::SceneDepth}},
     kPrograms,
     drawTessellated,
     featureSet(Feature::GrassBlended),
     false,
     true}};
const Follows kFollows[] = {{Feature::Wind, "blades bend and quiver each by itself"},
                            {Feature::Forces, "blades are laid down each its own way"},
                            {Feature::ForceMap, "blades are laid down each its own way"}};

}  // namespace

const EffectRow& tessellatedEffect() {
    static const EffectRow row{
        .name = "grass/tessellated",
        .needs = featureSet(Feature::GrassTessellated, Feature::Grass, Feature::Terrain),
        .systems = kSystems,
        .passes = kPasses,
        .makeState = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<TessState>(); },
        .help = "blades are tessellated by distance",
        .makeView = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<TessView>(); },
        .follows = kFollows};
    return row;
}

}  // namespace sward
