#include "grass/geometry.h"

#include "core/numerics.h"
#include "frame/draw_context.h"
#include "frame/tiles.h"
#include "grass/cells.h"
#include "grass/cover.h"
#include "grass/ground_shadow.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/geometry";

struct SpeciesState {
    uint64_t key = 0;
    Patch patch;
    Buffer blades, indices, cells, commands, globals;
    VertexArray mesh;
    Texture texture;
    std::string textureOf = "?";
    std::vector<CellDraw> selected;
};
struct GeometryState : EffectState {
    std::vector<std::unique_ptr<SpeciesState>> species;
    Buffer cover;
};

// For each n up to `segments`, all blades' strips of n quads in threshold order, over the same 2 (segments + 1) vertices a
// blade: coarse strips skip rows, and rows that no strip uses cost nothing.
std::vector<uint32_t> stripIndices(size_t blades, int segments) {
    std::vector<uint32_t> out;
    out.reserve(blades * firstStrip(segments + 1));
    for (int n = 1; n <= segments; ++n)
        for (size_t b = 0; b < blades; ++b)
            for (int s = 0; s < n; ++s) {
                const uint32_t base = static_cast<uint32_t>(b) * 2 * static_cast<uint32_t>(segments + 1);
                const uint32_t a = base + 2 * static_cast<uint32_t>(s * segments / n), c = base + 2 * static_cast<uint32_t>((s + 1) * segments / n);
                out.insert(out.end(), {a, a + 1, c, c, a + 1, c + 1});
            }
    return out;
}

void describeCells(SpeciesState& s) {
    const GLuint mesh = s.mesh.id();
    glVertexArrayVertexBuffer(mesh, 0, s.cells.id(), 0, sizeof(CellDraw));
    glVertexArrayBindingDivisor(mesh, 0, 1);
    for (GLuint attribute = 0; attribute < 3; ++attribute) {
        glEnableVertexArrayAttrib(mesh, attribute);
        glVertexArrayAttribBinding(mesh, attribute, 0);
    }
    glVertexArrayAttribIFormat(mesh, 0, 2, GL_INT, offsetof(CellDraw, cellX));
    glVertexArrayAttribFormat(mesh, 1, 2, GL_FLOAT, GL_FALSE, offsetof(CellDraw, x));
    glVertexArrayAttribFormat(mesh, 2, 2, GL_FLOAT, GL_FALSE, offsetof(CellDraw, mirrorX));
    glVertexArrayElementBuffer(mesh, s.indices.id());
}

void updatePatch(DrawContext& ctx, SpeciesState& s, const Species& species, const GrassField& field) {
    const uint64_t key = patchKey(species, field.cellSize, static_cast<uint32_t>(field.seed));
    if (s.key == key && s.mesh.id()) return;
    s.key = key;
    s.patch = makePatch(species, field.cellSize, static_cast<uint32_t>(field.seed));
    const auto indices = stripIndices(s.patch.blades.size(), species.segments);
    s.blades = makeBuffer(ctx.gpu, kOwner, s.patch.blades.size() * sizeof(Blade), s.patch.blades.data());
    s.indices = makeBuffer(ctx.gpu, kOwner, indices.size() * 4, indices.data());
    s.mesh = makeVertexArray(kOwner);
}

void updateTexture(DrawContext& ctx, SpeciesState& s, const Species& species) {
    if (s.textureOf == species.texture) return;
    s.textureOf = species.texture;
    Rgba8 image = species.texture.empty() ? Rgba8{} : loadTile(ctx.project.dir / species.texture);
    s.texture = makeTileTexture(ctx.gpu, kOwner, image.pixels.empty() ? makeBladeImage(32, 128) : image, false);
}

void writeGlobals(DrawContext& ctx, SpeciesState& s, const Species& sp, const GrassField& f, int index) {
    SpeciesGlobals g;
    g.rootColor = glm::vec4(sp.rootColor, sp.rootOcclusion);
    g.midColor = glm::vec4(sp.midColor, std::tan(glm::radians(std::min(sp.leanDeg, 80.0f))));
    g.tipColor = glm::vec4(sp.tipColor, sp.clumpSize);
    const float clumps = sp.clumpSize > 0 ? sp.clumpStrength : 0;
    g.clumps = {0.8f * clumps * std::tan(glm::radians(std::min(sp.leanVariationDeg + sp.leanDeg, 80.0f))), 0.8f * clumps * sp.heightVariation, 0.2f * clumps, f.cellSize};
    g.counts = {static_cast<float>(sp.segments), static_cast<float>(f.seed), f.fade, static_cast<float>(index)};
    g.looks = {sp.translucency, sp.gloss, sp.roughness, 0};
    const BladeShade& shade = ctx.shared.shades[static_cast<size_t>(index)];
    g.mask = {shade.radius, shade.top, 0, 0};
    writeBuffer(ctx.gpu, s.globals, kOwner, sizeof(g), &g);
}

void uploadCells(DrawContext& ctx, SpeciesState& s) {
    std::vector<DrawCommand> commands;
    commands.reserve(s.selected.size());
    for (const CellDraw& c : s.selected) {
        commands.push_back(drawCommand(c, c.segments, static_cast<uint32_t>(s.patch.blades.size()), ctx.settings.detail, static_cast<uint32_t>(commands.size())));
        ctx.stats.bladesGeometry += bladesDrawn(c, ctx.settings.detail);
    }
    writeBuffer(ctx.gpu, s.cells, kOwner, s.selected.size() * sizeof(CellDraw), s.selected.data());
    writeBuffer(ctx.gpu, s.commands, kOwner, commands.size() * sizeof(DrawCommand), commands.data());
    describeCells(s);
    ctx.stats.cells += s.selected.size();
}

void publishMaps(DrawContext& ctx, const GrassField& f) {
    for (size_t i = 0; i < f.species.size() && i < MAX_SPECIES; ++i)
        ctx.shared.densities[i] = f.species[i].density.present() ? ctx.maps.get("grass/density", "density." + std::to_string(i), f.species[i].density.map) : 0;
    const auto publish = [&](GLuint& to, const MapField& m, const char* owner, bool srgb) {
        to = m.present() ? ctx.maps.get(owner, owner, m.map, srgb, true) : 0;
    };
    publish(ctx.shared.orientation, f.orientation, "grass/orientation", false);
    publish(ctx.shared.vegetation, f.vegetation, "grass/vegetation", true);
    publish(ctx.shared.occlusion, f.ambientOcclusion, "grass/occlusion", false);
}

void cull(DrawContext& ctx) {
    GeometryState& state = ctx.own<GeometryState>();
    const auto start = std::chrono::steady_clock::now();
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    if (!ctx.shared.ground.terrain) return;
    publishMaps(ctx, f);
    const GeometryRange range = geometryRange(f);
    const size_t n = std::min<size_t>(f.species.size(), MAX_SPECIES);
    state.species.resize(n);
    const float pixels = pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));
    CoverGlobals cover{};
    cover.tiers = {static_cast<float>(n), range.min, range.inv, f.cellSize};
    cover.tiling = {f.orientationTiling, f.vegetationTiling, f.ambientOcclusionTiling, static_cast<float>(f.seed)};
    for (size_t i = 0; i < n; ++i) {
        if (!state.species[i]) state.species[i] = std::make_unique<SpeciesState>();
        SpeciesState& s = *state.species[i];
        updatePatch(ctx, s, f.species[i], f);
        updateTexture(ctx, s, f.species[i]);
        writeGlobals(ctx, s, f.species[i], f, static_cast<int>(i));
        cover.species[i] = meanCover(f.species[i], s.patch, ctx.globals, ctx.shared.shades[i]);
        CellQuery query = cellQuery(*ctx.shared.ground.terrain, ctx.shared.bounds, f, f.species[i], s.patch, ctx.eye, ctx.frustum, pixels);
        if (has(ctx.plan.features, Feature::GroundShadows)) query.reach += groundShadowReach(cover.species[i].ambient.w);
        s.selected = selectCells(query);
    }
    ctx.stats.cpuCullMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    ctx.shared.blades = {};
    for (size_t i = 0; i < n; ++i) {
        SpeciesState& s = *state.species[i];
        uploadCells(ctx, s);
        ctx.shared.blades[i] = {s.mesh.id(), s.blades.id(), s.globals.id(), s.selected.data(), s.selected.size(), static_cast<uint32_t>(s.patch.blades.size()), f.species[i].segments};
    }
    writeBuffer(ctx.gpu, state.cover, kOwner, sizeof(cover), &cover);
    ctx.shared.cover = state.cover.id();
}

void bindShared(DrawContext& ctx) {
    const SharedResources& r = ctx.shared;
    if (r.heights) glBindTextureUnit(TEX_HEIGHT, r.heights);
    if (r.orientation) glBindTextureUnit(TEX_ORIENTATION, r.orientation);
    if (r.vegetation) glBindTextureUnit(TEX_VEGETATION, r.vegetation);
    if (r.occlusion) glBindTextureUnit(TEX_OCCLUSION, r.occlusion);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_COVER, r.cover);
}

void draw(DrawContext& ctx) {
    GeometryState& state = ctx.own<GeometryState>();
    if (!ctx.use()) return;
    bindShared(ctx);
    const bool overdraw = ctx.settings.mode == ViewMode::Overdraw;
    if (overdraw) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    } else {
        glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    }
    for (size_t i = 0; i < state.species.size(); ++i) {
        SpeciesState& s = *state.species[i];
        if (s.selected.empty()) continue;
        glBindTextureUnit(TEX_BLADE, s.texture.id());
        if (ctx.shared.shades[i].texture) glBindTextureUnit(TEX_MASK, ctx.shared.shades[i].texture);
        if (ctx.shared.densities[i]) glBindTextureUnit(TEX_DENSITY, ctx.shared.densities[i]);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_BLADES, s.blades.id());
        glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SPECIES, s.globals.id());
        glBindVertexArray(s.mesh.id());
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, s.commands.id());
        glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(s.selected.size()), 0);
        ctx.pass->draws += 1;
        ctx.pass->instances += s.selected.size();
    }
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    glDisable(GL_BLEND);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

const System kSystems[] = {{"grass/cull", cull}};
const ProgramRow kPrograms[] = {{"grass/geometry", "grass/geometry.vert.glsl", "grass/geometry.frag.glsl", nullptr,
                                 featureSet(Feature::TerrainHeights, Feature::GrassDensity, Feature::GrassOrientation, Feature::GrassVegetation,
                                            Feature::GrassOcclusion, Feature::GrassClumps, Feature::Translucency, Feature::Gloss, Feature::BladeShadows, Feature::CastingLights, Feature::Sun, Feature::Lamps, Feature::Sky, Feature::Fog)}};
const Pass kPasses[] = {{"grass/geometry", Stage::Blades, kViewMain | kViewCompare, kGroundCover, kSceneColor | kSceneDepth, kPrograms, draw}};

}  // namespace

const EffectRow& geometryEffect() {
    static const EffectRow row{"grass/geometry", featureSet(Feature::Grass, Feature::Terrain), kSystems, kPasses,
                               [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<GeometryState>(); },
                               "blades near the eye are drawn one by one"};
    return row;
}

}  // namespace sward
