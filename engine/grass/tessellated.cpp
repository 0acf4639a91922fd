#include "grass/tessellated.h"

#include "core/numerics.h"
#include "frame/draw_context.h"
#include "grass/cells.h"
#include "grass/field.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/tessellated";
constexpr float kNear = 0.05f;          // metres: the near plane
constexpr float kMostWidening = 6;      // of blades, where others are left out
constexpr float kPlainPixels = 1.5f;    // blades of one quad that are thinner are plain triangles
constexpr uint32_t kPieceBlades = 256;  // of a cell that one group writes: kGroup of tessellated.comp.glsl
constexpr uint32_t kBatchAlign = 16;    // cells: batches begin at multiples of 768 bytes, where buffers may be bound
constexpr uint32_t kCommandBytes = 20;
constexpr uint32_t kMostGroups = 65535; // of a dispatch
constexpr size_t kBatchBytes = 64u << 20;  // of vertices that are there at once

// Cells [firstCell, lastCell) with slots [firstSlot, lastSlot) of which all vertices fit.
struct Batch {
    uint32_t firstCell, lastCell, firstSlot, lastSlot;
    size_t bytes;
    bool far;  // plain triangles alone
    uint32_t groups() const { return lastCell - firstCell; }
};
struct SpeciesState {
    uint64_t key = 0, imageHash = 0;
    float covered = 1;  // mean of the blade image's alpha
    int indicesTo = 0;
    Buffer blades, cells, commands, vertices, indices, globals;
    VertexArray strips;
    std::vector<Batch> batches;
    uint32_t cellCount = 0, slots = 0;
};
struct TessState : EffectState {
    std::vector<std::unique_ptr<SpeciesState>> species;
    VertexArray patches;
};

bool stagesChosen(const GrassField& f, const Gpu& gpu) {
    const auto way = static_cast<Tessellation>(f.tessellation);
    return way == Tessellation::Stages || (way == Tessellation::Auto && !gpu.software);
}

// --- what shaders know of a species ----------------------------------------------------------------------------------

float meanAlpha(const Rgba8& image) {
    double sum = 0;
    for (size_t i = 3; i < image.pixels.size(); i += 4) sum += image.pixels[i];
    return image.pixels.empty() ? 1 : static_cast<float>(sum / (255.0 * static_cast<double>(image.pixels.size() / 4)));
}

float mostWidening(const GrassField& f) { return f.widening ? std::min(1 / std::max(1 - f.thinning, 1e-3f), kMostWidening) : 1; }

TessGlobals globalsOf(const DrawContext& ctx, const GrassField& f, const Species& species, float covered) {
    TessGlobals g;
    g.range = {f.maxDistance, f.thinning / f.maxDistance, 1 / std::max(f.maxDistance * (1 - f.lowerFrom), 1e-6f), mostWidening(f)};
    const bool byPixels = f.levelBy == static_cast<int>(LevelBy::Pixels);
    g.level = {static_cast<float>(species.smoothness), byPixels ? f.pixelsPerQuad : 0, kNear, pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings))};
    g.plain = {kPlainPixels, 2 * covered, 0, 0};  // a triangle covers half of its strip
    return g;
}

void updateSpecies(DrawContext& ctx, SpeciesState& s, const FieldSpecies& own, const GrassField& f, const Species& species) {
    if (s.key != own.drawnKey() || !s.blades.id()) s.blades = makeBuffer(ctx.gpu, kOwner, own.drawn().blades.size() * sizeof(Blade), own.drawn().blades.data());
    s.key = own.drawnKey();
    if (s.imageHash != own.bladeHash) s.covered = meanAlpha(own.bladeImage);
    s.imageHash = own.bladeHash;
    const TessGlobals g = globalsOf(ctx, f, species, s.covered);
    writeBuffer(ctx.gpu, s.globals, kOwner, sizeof(g), &g);
}

// --- cells, in pieces, and the batches in which they are drawn ---------------------------------------------------------

size_t vertexBytes(const FeatureSet& features) { return 4 * (has(features, Feature::BladeShadows) && has(features, Feature::CastingLights) ? 11 : 8); }
uint32_t verticesOf(bool far, int level) { return far ? 3u : 2u * static_cast<uint32_t>(level + 1); }
// Where the indices of strips of n quads begin, for kPieceBlades of them: those of fewer stand before.
uint32_t stripStart(int n) { return firstStrip(n) * kPieceBlades; }

struct PieceWriter {
    bool far;
    size_t vertexSize;
    std::vector<TessCell>& cells;
    std::vector<Batch>& batches;
    uint32_t& slots;

    uint32_t vertices() const { return static_cast<uint32_t>(batches.back().bytes / vertexSize); }
    // Each batch is followed by a cell of no blades, which ends its last one.
    void endBatch() {
        do cells.push_back({{}, {}, {}, {}, 0, slots, 1, 0});
        while (cells.size() % kBatchAlign != 0);
    }
    void beginBatch() {
        if (!batches.empty()) endBatch();
        const auto cell = static_cast<uint32_t>(cells.size());
        batches.push_back({cell, cell, slots, slots, 0, far});
    }
    void add(const CellDraw& c, uint32_t first, uint32_t count) {
        const uint32_t each = verticesOf(far, c.segments);
        if (batches.empty() || batches.back().far != far || cells.size() - batches.back().firstCell == kMostGroups || batches.back().bytes + count * each * vertexSize > kBatchBytes) beginBatch();
        Batch& b = batches.back();
        cells.push_back({{c.cellX, c.cellZ}, {c.x, c.z}, c.mirror, c.shift, first, slots, static_cast<uint32_t>(c.segments), vertices()});
        slots += count;
        ++b.lastCell;
        b.lastSlot = slots;
        b.bytes += count * each * vertexSize;
    }
    void cell(const CellDraw& c, uint32_t blades) {
        for (uint32_t done = 0; done < blades; done += kPieceBlades) add(c, c.first + done, std::min(kPieceBlades, blades - done));
    }
};

// Whether all of a cell's blades are plain triangles.
bool isFar(const CellDraw& c, float widest, float pixels) { return c.segments == 1 && widest * pixels < 0.999f * kPlainPixels * c.nearest; }

void listCells(DrawContext& ctx, SpeciesState& s, std::span<const CellDraw> selected, float widest) {
    std::vector<TessCell> cells;
    s.batches.clear();
    s.slots = 0;
    const float pixels = pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));
    for (const bool far : {false, true}) {
        PieceWriter writer{far, vertexBytes(ctx.plan.features), cells, s.batches, s.slots};
        for (const CellDraw& c : selected)
            if (isFar(c, widest, pixels) == far) writer.cell(c, bladesDrawn(c, ctx.settings.detail));
    }
    cells.push_back({{}, {}, {}, {}, 0, s.slots, 1, 0});
    s.cellCount = static_cast<uint32_t>(cells.size());
    writeBuffer(ctx.gpu, s.cells, kOwner, cells.size() * sizeof(TessCell), cells.data());
    ctx.stats.cells += selected.size();
    ctx.stats.bladesGeometry += s.slots;
}

CellQuery queryOf(DrawContext& ctx, const GrassField& f, size_t i) {
    const float pixels = pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));
    const Species& species = f.species[i];
    CellQuery q = drawnQuery(ctx, f, i);
    q.reach += species.width * (mostWidening(f) * ctx.globals.mode.w - 1);
    q.thinning = f.thinning / f.maxDistance;
    q.levels = {species.smoothness, f.maxDistance, 0, q.reach};
    if (f.levelBy == static_cast<int>(LevelBy::Pixels)) q.levels.quadsAtOneMetre = q.reach * pixels / f.pixelsPerQuad;
    return q;
}

void select(DrawContext& ctx) {
    TessState& state = ctx.own<TessState>();
    if (!ctx.shared.grass) return;
    const auto start = std::chrono::steady_clock::now();
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    const FieldState& field = *ctx.shared.grass;
    state.species.resize(field.species.size());
    for (size_t i = 0; i < state.species.size(); ++i) {
        if (!state.species[i]) state.species[i] = std::make_unique<SpeciesState>();
        updateSpecies(ctx, *state.species[i], *field.species[i], f, f.species[i]);
        std::vector<CellDraw> selected = selectCells(queryOf(ctx, f, i));
        // What is behind is then not shaded; and what is cut by the picture's edge is drawn last, because a software rasteriser takes a slow
        // way with whole batches of vertices of which one must be clipped.
        std::stable_sort(selected.begin(), selected.end(), [](const CellDraw& a, const CellDraw& b) { return std::pair(-a.whole, a.nearest) < std::pair(-b.whole, b.nearest); });
        listCells(ctx, *state.species[i], selected, 1.25f * f.species[i].width * mostWidening(f) * ctx.globals.mode.w);
    }
    ctx.stats.cpuCullMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// --- drawing ---------------------------------------------------------------------------------------------------------

void bindSpecies(const DrawContext& ctx, size_t i, const SpeciesState& s) {
    const FieldSpecies& shared = *ctx.shared.grass->species[i];
    glBindTextureUnit(TEX_BLADE, shared.bladeTexture.id());
    if (ctx.shared.shades[i].texture) glBindTextureUnit(TEX_MASK, ctx.shared.shades[i].texture);
    if (ctx.shared.densities[i]) glBindTextureUnit(TEX_DENSITY, ctx.shared.densities[i]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_BLADES, s.blades.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_CELLS, s.cells.id());
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SPECIES, shared.globals.id());
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_TESS, s.globals.id());
}

enum Program { kStages, kWriter, kStrips };

void drawPatches(DrawContext& ctx, TessState& state, const std::string& constants) {
    if (!ctx.use(kStages, constants)) return;
    if (!state.patches.id()) state.patches = makeVertexArray(kOwner);
    glBindVertexArray(state.patches.id());
    glPatchParameteri(GL_PATCH_VERTICES, 1);
    for (size_t i = 0; i < state.species.size(); ++i) {
        const SpeciesState& s = *state.species[i];
        if (s.slots == 0) continue;
        bindSpecies(ctx, i, s);
        glUniform1ui(0, s.cellCount);
        glDrawArrays(GL_PATCHES, 0, static_cast<GLsizei>(s.slots));
        ctx.pass->draws += 1;
        ctx.pass->instances += 1;
    }
}

std::vector<uint32_t> stripIndices(int most) {
    std::vector<uint32_t> out;
    out.reserve(stripStart(most + 1));
    for (int n = 1; n <= most; ++n)
        for (uint32_t b = 0; b < kPieceBlades; ++b)
            for (uint32_t row = 0; row < static_cast<uint32_t>(n); ++row) {
                const uint32_t a = 2 * (b * static_cast<uint32_t>(n + 1) + row), c = a + 2;
                out.insert(out.end(), {a, a + 1, c, c, a + 1, c + 1});
            }
    return out;
}

void describeVertices(GLuint mesh, GLuint vertices, size_t stride) {
    struct Attribute {
        GLint size;
        GLenum type;
        GLuint offset;
    };
    static constexpr Attribute kAttributes[] = {{4, GL_FLOAT, 0}, {4, GL_HALF_FLOAT, 16}, {2, GL_UNSIGNED_SHORT, 24}, {1, GL_UNSIGNED_INT, 28}, {4, GL_HALF_FLOAT, 32}, {2, GL_HALF_FLOAT, 40}};
    glVertexArrayVertexBuffer(mesh, 0, vertices, 0, static_cast<GLsizei>(stride));
    for (GLuint i = 0; i < std::size(kAttributes); ++i) {
        const Attribute& a = kAttributes[i];
        if (a.offset >= stride) {
            glDisableVertexArrayAttrib(mesh, i);
            continue;
        }
        glEnableVertexArrayAttrib(mesh, i);
        glVertexArrayAttribBinding(mesh, i, 0);
        if (a.type == GL_UNSIGNED_INT) glVertexArrayAttribIFormat(mesh, i, a.size, a.type, a.offset);
        else glVertexArrayAttribFormat(mesh, i, a.size, a.type, a.type == GL_UNSIGNED_SHORT, a.offset);
    }
}

void prepareStrips(DrawContext& ctx, SpeciesState& s, int smoothness) {
    size_t most = 0, groups = 0;
    for (const Batch& b : s.batches) most = std::max(most, b.bytes), groups = std::max<size_t>(groups, b.groups());
    writeBuffer(ctx.gpu, s.vertices, kOwner, most, nullptr);
    writeBuffer(ctx.gpu, s.commands, kOwner, groups * kCommandBytes, nullptr);
    if (s.indicesTo != smoothness) {
        const auto indices = stripIndices(smoothness);
        s.indices = makeBuffer(ctx.gpu, kOwner, indices.size() * 4, indices.data());
        s.indicesTo = smoothness;
    }
    if (!s.strips.id()) s.strips = makeVertexArray(kOwner);
    describeVertices(s.strips.id(), s.vertices.id(), vertexBytes(ctx.plan.features));
    glVertexArrayElementBuffer(s.strips.id(), s.indices.id());
}

bool writeStrips(DrawContext& ctx, const SpeciesState& s, const Batch& b, const std::string& constants) {
    if (!ctx.use(kWriter, constants + fmt::format("const bool FAR = {};\n", b.far))) return false;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_VERTICES, s.vertices.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_COMMANDS, s.commands.id());
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, SSBO_CELLS, s.cells.id(), static_cast<GLintptr>(b.firstCell * sizeof(TessCell)), static_cast<GLsizeiptr>((b.groups() + 1) * sizeof(TessCell)));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // of the batch before
    glDispatchCompute(b.groups(), 1, 1);
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    return true;
}

void drawStrips(DrawContext& ctx, const SpeciesState& s, const Batch& b, const std::string& constants) {
    if (!ctx.use(kStrips, constants)) return;
    glBindVertexArray(s.strips.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, s.commands.id());
    const auto commands = static_cast<GLsizei>(b.groups());
    if (b.far) glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * (b.lastSlot - b.firstSlot)));
    else glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, commands, kCommandBytes);
    ctx.pass->draws += 1;
    ctx.pass->instances += b.far ? 1 : static_cast<uint64_t>(commands);
}

void drawBatches(DrawContext& ctx, TessState& state, const GrassField& f, const std::string& constants) {
    for (size_t i = 0; i < state.species.size(); ++i) {
        SpeciesState& s = *state.species[i];
        if (s.slots == 0) continue;
        prepareStrips(ctx, s, f.species[i].smoothness);
        bindSpecies(ctx, i, s);
        for (const Batch& b : s.batches)
            if (writeStrips(ctx, s, b, constants)) drawStrips(ctx, s, b, constants);
    }
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void draw(DrawContext& ctx) {
    TessState& state = ctx.own<TessState>();
    if (!ctx.shared.grass) return;
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    const std::string constants = fieldConstants(f);
    bindField(ctx);
    beginTransparency(ctx, f);
    if (stagesChosen(f, ctx.gpu)) drawPatches(ctx, state, constants);
    else drawBatches(ctx, state, f, constants);
    endTransparency();
}

std::vector<std::string> writerVariants() {
    std::vector<std::string> out;
    for (const char* far : {"const bool FAR = false;\n", "const bool FAR = true;\n"}) out.push_back(fieldConstants({}) + far);
    return out;
}

const System kSystems[] = {{"grass/tessellated/cells", select}};
// What posing and lighting a blade asks for.
FeatureSet bladeFeatures() {
    return featureSet(Feature::TerrainHeights, Feature::GrassDensity, Feature::GrassOrientation, Feature::GrassVegetation, Feature::GrassHeights, Feature::GrassOcclusion, Feature::GrassClumps,
                      Feature::Wind, Feature::Gusts, Feature::Forces, Feature::ForceMap, Feature::FarDarkening,
                      Feature::Translucency, Feature::Gloss, Feature::BladeShadows, Feature::CastingLights, Feature::ObjectShadows, Feature::TerrainShadows, Feature::Sun,
                      Feature::Lamps, Feature::Sky, Feature::Fog, Feature::WaterReflection);
}
const ProgramRow kPrograms[] = {
    {"grass/tessellated/stages", "grass/tessellated.vert.glsl", "grass/tessellated.frag.glsl", nullptr, bladeFeatures(), fieldVariants, "grass/tessellated.tesc.glsl", "grass/tessellated.tese.glsl"},
    {"grass/tessellated/writer", nullptr, nullptr, "grass/tessellated.comp.glsl", bladeFeatures(), writerVariants},
    {"grass/tessellated/strips", "grass/tessellated_strip.vert.glsl", "grass/tessellated.frag.glsl", nullptr, bladeFeatures(), fieldVariants},
};
const Pass kPasses[] = {{"grass/tessellated", Stage::Blades, kViewMain | kViewReflection | kViewCompare, 0, kSceneColor | kSceneDepth, kPrograms, draw}};

}  // namespace

const EffectRow& tessellatedEffect() {
    static const EffectRow row{"grass/tessellated", featureSet(Feature::GrassTessellated, Feature::Grass, Feature::Terrain), kSystems, kPasses,
                               [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<TessState>(); },
                               "blades are tessellated by distance"};
    return row;
}

}  // namespace sward
