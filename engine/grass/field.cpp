#include "grass/field.h"

#include "core/hash.h"
#include "core/numerics.h"
#include "grass/cells.h"
#include "scene/tiling.h"
#include "world/wind.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/field";

void updatePatch(FieldSpecies& s, const Species& species, const GrassField& field) {
    const uint64_t key = patchKey(species, field.cellSize, static_cast<uint32_t>(field.seed));
    if (s.key == key) return;
    s.key = key;
    s.patch = makePatch(species, field.cellSize, static_cast<uint32_t>(field.seed));
}

void updateUnique(const DrawContext& ctx, FieldSpecies& s, const Species& species, const GrassField& field) {
    const Terrain& t = *ctx.shared.ground.terrain;
    if (!has(ctx.plan.features, Feature::GrassUnique)) {
        s.unique = {}, s.uniqueOf = 0, s.uniqueDensity = {};
        return;
    }
    const uint64_t key = uniqueKey(species, field, t);
    if (s.uniqueOf == key && !s.unique.empty() && s.uniqueDensity.sameTiles(species.density.map)) return;
    s.uniqueOf = key, s.uniqueDensity = species.density.map;
    s.uniqueKey = (s.uniqueKey + key) * 0x9E3779B97F4A7C15ull + 1;
    s.unique = makeUnique(species, field, t);
}

void updateTexture(DrawContext& ctx, FieldSpecies& s, const Species& species) {
    if (s.textureOf == species.texture) return;
    s.textureOf = species.texture;
    s.bladeImage = bladeImage(ctx.project, species);
    s.bladeHash = hashBytes(s.bladeImage.pixels.data(), s.bladeImage.pixels.size());
    s.bladeTexture = makeColorTexture(ctx.gpu, kOwner, s.bladeImage, false);
}

void writeGlobals(DrawContext& ctx, FieldSpecies& s, const Species& sp, const GrassField& f, int index) {
    SpeciesGlobals g;
    g.rootColor = sp.rootColor, g.midColor = sp.midColor, g.tipColor = sp.tipColor;
    g.rootOpen = sp.rootOcclusion;
    g.leanAtFull = leanAtFull(sp);
    const glm::vec3 clumps = clumpStrengths(sp);
    g.clumpSize = sp.clumpSize, g.clumpLean = clumps.x, g.clumpHeight = clumps.y, g.clumpLightness = clumps.z;
    g.cellSize = f.cellSize;
    g.segments = sp.segments;
    g.seed = static_cast<uint32_t>(f.seed);
    g.fade = isUnique(f) ? 0 : f.fade;
    g.index = index;
    g.translucency = sp.translucency, g.gloss = sp.gloss, g.roughness = sp.roughness;
    const BladeShade& shade = ctx.shared.shades[static_cast<size_t>(index)];
    g.maskRadius = shade.radius, g.maskHeight = shade.top;
    writeBuffer(ctx.gpu, s.globals, kOwner, sizeof(g), &g);
}

// All species are drawn by one program, which reads a density map if any of them has one.
void publishDensities(DrawContext& ctx, FieldState& state, const GrassField& f) {
    const Terrain& t = *ctx.shared.ground.terrain;
    const auto bare = [](const Species& s) { return !s.density.present(); };
    const bool some =
        has(ctx.plan.features, Feature::GrassDensity) && std::any_of(f.species.begin(), f.species.end(), bare);
    if (!some) state.everywhere = {};
    if (some && !state.everywhere.id()) {
        const uint8_t one = 255;
        state.everywhere = makeTexture2D(ctx.gpu, "grass/density", GL_R8, 1, 1);
        glTextureSubImage2D(state.everywhere.id(), 0, 0, 0, 1, 1, GL_RED, GL_UNSIGNED_BYTE, &one);
    }
    ctx.shared.densities.fill(0);
    for (size_t i = 0; i < f.species.size() && i < MAX_SPECIES; ++i)
        ctx.shared.densities[i] =
            bare(f.species[i]) ? state.everywhere.id()
                               : ctx.maps.get("grass/density", "density." + std::to_string(i), f.species[i].density.map,
                                              false, tilingOf(t, f.species[i].densityTiling).repeats);
}

void publishMaps(DrawContext& ctx, FieldState& state, const GrassField& f) {
    const Terrain& t = *ctx.shared.ground.terrain;
    publishDensities(ctx, state, f);
    const auto publish = [&](GLuint& to, const MapField& m, const char* owner, bool srgb) {
        to = m.present() ? ctx.maps.get(owner, owner, m.map, srgb, true) : 0;
    };
    publish(ctx.shared.orientation, f.orientation, "grass/orientation", false);
    publish(ctx.shared.vegetation, f.vegetation, "grass/vegetation", true);
    publish(ctx.shared.forces, f.forces, "grass/force-map", false);
    ctx.shared.bladeHeights = f.bladeHeight.present()
                                  ? ctx.maps.get("grass/heights", "grass/heights", f.bladeHeight.map, false,
                                                 tilingOf(t, f.bladeHeightTiling).repeats)
                                  : 0;
    publish(ctx.shared.occlusion, f.ambientOcclusion, "grass/occlusion", false);
}

// Where blades and slices stop shading the soil one by one: as far as vertical slices are seen.
std::pair<float, float> shadowRange(const GrassField& f) {
    const float inf = std::numeric_limits<float>::infinity();
    switch (static_cast<Technique>(f.technique)) {
        case Technique::Geometry:
            return {inf, inf};
        case Technique::Tessellated:
            return {0, 0};  // soil is shaded in the mean alone
        case Technique::Slices:
        case Technique::Flat:
            return {f.minBTF, f.maxBTF};
        default:
            return {std::max(f.minBTF, f.maxGeom), std::max(f.maxBTF, f.maxGeom)};
    }
}

void writeCover(DrawContext& ctx, FieldState& state, const GrassField& f) {
    const GeometryRange range = geometryRange(f);
    CoverGlobals cover{};
    cover.speciesCount = static_cast<int>(state.species.size());
    cover.minGeom = range.min, cover.geomInv = range.inv;
    cover.cellSize = f.cellSize;
    cover.orientationTiling = f.orientationTiling, cover.vegetationTiling = f.vegetationTiling;
    cover.occlusionTiling = f.ambientOcclusionTiling, cover.forceTiling = f.forcesTiling;
    const Terrain& t = *ctx.shared.ground.terrain;
    cover.heightTiling = shaderTiling(t, f.bladeHeightTiling);
    const Wind* wind = windOf(ctx.project);
    for (size_t i = 0; i < state.species.size(); ++i)
        cover.species[i] = {shaderTiling(t, f.species[i].densityTiling),
                            lightLeft(state.species[i]->look, ctx.globals.sunDirection.y),
                            state.species[i]->look.height, wind ? windStrength(*wind, f.species[i]) : 0};
    const auto [from, upTo] = shadowRange(f);
    cover.shadeFrom = from, cover.shadeInv = f32::lodInverse(from, upTo);
    cover.farDarkening = f.farDarkening, cover.farDarkeningAt = f.farDarkeningDistance;
    writeBuffer(ctx.gpu, state.cover, kOwner, sizeof(cover), &cover);
    ctx.shared.cover = state.cover.id();
}

// For the whole frame: nothing else uses the bindings.
void bindField(const SharedResources& r) {
    static_assert(TEX_ORIENTATION == TEX_BLADE_HEIGHT + 1 && TEX_VEGETATION == TEX_BLADE_HEIGHT + 2 &&
                  TEX_OCCLUSION == TEX_BLADE_HEIGHT + 3);
    const GLuint maps[] = {r.bladeHeights, r.orientation, r.vegetation, r.occlusion};
    glBindTextures(TEX_BLADE_HEIGHT, 4, maps);
    if (r.forces) glBindTextureUnit(TEX_FORCE_MAP, r.forces);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_COVER, r.cover);
}

void update(DrawContext& ctx) {
    FieldState& state = ctx.own<FieldState>();
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    if (!ctx.shared.ground.terrain) return;
    publishMaps(ctx, state, f);
    state.species.resize(std::min<size_t>(f.species.size(), MAX_SPECIES));
    for (size_t i = 0; i < state.species.size(); ++i) {
        if (!state.species[i]) state.species[i] = std::make_unique<FieldSpecies>();
        FieldSpecies& s = *state.species[i];
        updatePatch(s, f.species[i], f);
        updateUnique(ctx, s, f.species[i], f);
        updateTexture(ctx, s, f.species[i]);
        updateLook(s.look, s.lookKey, f.species[i], s.patch, s.key ^ s.bladeHash, s.bladeImage);
        writeGlobals(ctx, s, f.species[i], f, static_cast<int>(i));
        if (!has(ctx.plan.features, Feature::GrassFar))
            s.slices = {}, s.sliceKey = s.sliceAsked = 0, s.bake = {}, s.sliceGlobals = {};
    }
    writeCover(ctx, state, f);
    bindField(ctx.shared);
    ctx.shared.grass = &state;
}

const System kSystems[] = {{"grass/field", update}};

}  // namespace

CellQuery drawnQuery(const DrawContext& ctx, const GrassField& f, size_t i) {
    const FieldSpecies& s = *ctx.shared.grass->species[i];
    CellQuery q = cellQuery(*ctx.shared.ground.terrain, ctx.shared.bounds, f, f.species[i], s.drawn(), ctx.eye,
                            ctx.frustum, pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)));
    if (!s.unique.empty()) q.unique = &s.unique;
    return q;
}

void describeCells(GLuint mesh, GLuint cells, size_t stride, GLuint indices) {
    static_assert(sizeof(CellInstance) == sizeof(SliceCell) &&
                  offsetof(CellInstance, corner) == offsetof(SliceCell, x) &&
                  offsetof(CellInstance, mirror) == offsetof(SliceCell, mirror) &&
                  offsetof(CellInstance, shift) == offsetof(SliceCell, shift));
    glVertexArrayVertexBuffer(mesh, 0, cells, 0, static_cast<GLsizei>(stride));
    glVertexArrayBindingDivisor(mesh, 0, 1);
    for (GLuint attribute = 0; attribute < 4; ++attribute) {
        glEnableVertexArrayAttrib(mesh, attribute);
        glVertexArrayAttribBinding(mesh, attribute, 0);
    }
    glVertexArrayAttribIFormat(mesh, 0, 2, GL_INT, offsetof(CellInstance, cell));
    glVertexArrayAttribFormat(mesh, 1, 2, GL_FLOAT, GL_FALSE, offsetof(CellInstance, corner));
    glVertexArrayAttribFormat(mesh, 2, 2, GL_FLOAT, GL_FALSE, offsetof(CellInstance, mirror));
    glVertexArrayAttribFormat(mesh, 3, 2, GL_FLOAT, GL_FALSE, offsetof(CellInstance, shift));
    glVertexArrayElementBuffer(mesh, indices);
}

void beginTransparency(const DrawContext& ctx, const GrassField& field) {
    if (ctx.settings.mode == ViewMode::Overdraw) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        return;
    }
    const auto way = static_cast<Transparency>(field.transparency);
    if (way == Transparency::Both || way == Transparency::Blend) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
}
void endTransparency() { glDisable(GL_BLEND); }

Rgba8 bladeImage(const Project& project, const Species& species) {
    Rgba8 image = species.texture.empty() ? Rgba8{} : loadColorImage(project.dir / species.texture);
    return image.pixels.empty() ? makeBladeImage(32, 128) : image;
}

std::string fieldConstants(const GrassField& f) {
    return fmt::format(
        "const int TRANSPARENCY = {};\nconst int STORAGE = {};\nconst bool LIGHT_COSINE = {};\nconst bool "
        "WEIGHTS_PER_PIXEL = {};\nconst bool CONSERVING = {};\n",
        f.transparency, f.storage, f.lightWeights == static_cast<int>(LightWeighting::Cosine),
        f.weightsAt == static_cast<int>(WeightsAt::Pixel), f.sliceCover == static_cast<int>(SliceCover::Conserving));
}

std::vector<std::string> fieldVariants() {
    std::vector<std::string> out;
    GrassField f;
    const auto add = [&](int& field, int value) {
        field = value;
        out.push_back(fieldConstants(f));
    };
    for (const Storage storage : {Storage::Factored, Storage::Compressed, Storage::Full})
        for (const LightWeighting weights : {LightWeighting::Atan, LightWeighting::Cosine})
            for (const WeightsAt at : {WeightsAt::Vertex, WeightsAt::Pixel}) {
                f.storage = static_cast<int>(storage), f.lightWeights = static_cast<int>(weights);
                add(f.weightsAt, static_cast<int>(at));
            }
    for (const Transparency way : {Transparency::Coverage, Transparency::Both, Transparency::Test, Transparency::Blend})
        add(f.transparency, static_cast<int>(way));
    add(f.sliceCover, static_cast<int>(SliceCover::Published));
    return out;
}

void FieldState::jobs(std::vector<JobNews>& out) const {
    for (const auto& s : species)
        if (s && s->bake.active()) out.push_back(s->bake.news());
}

const EffectRow& fieldEffect() {
    static const EffectRow row{
        "grass/field",
        featureSet(Feature::Grass, Feature::Terrain),
        kSystems,
        {},
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<FieldState>(); },
        "there is grass: its patches, maps and textures"};
    return row;
}
const EffectRow& farDarkeningEffect() {
    static const EffectRow row{"grass/far-darkening",
                               featureSet(Feature::FarDarkening, Feature::Grass, Feature::Terrain),
                               {},
                               {},
                               nullptr,
                               "far grass is darker, which shows depth"};
    return row;
}

}  // namespace sward
