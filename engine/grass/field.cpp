#include "grass/field.h"

#include "core/hash.h"
#include "core/numerics.h"
#include "grass/cells.h"
#include "grass/drawing.h"
#include "grass/grass_fields.h"
#include "grass/mask.h"
#include "grass/slice_settings.h"
#include "scene/field_limits.h"
#include "scene/tiling.h"
#include "shared/soil.h"
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

void updateUnique(const DrawContext& ctx, FieldSpecies& s, const Species& species, const Field& of) {
    const Terrain& t = *ctx.shared.ground.terrain;
    const GrassField& field = of.grows();
    if (!has(of.view->own, Feature::GrassUnique)) {
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

void writeGlobals(DrawContext& ctx, FieldSpecies& s, const Field& field, size_t index) {
    const GrassField& f = field.grows();
    const Species& sp = f.species[index];
    SpeciesGlobals g;
    g.rootColor = sp.rootColor, g.midColor = sp.midColor, g.tipColor = sp.tipColor;
    g.rootOpen = sp.rootOcclusion;
    g.leanAtFull = leanAtFull(sp);
    const glm::vec3 clumps = clumpStrengths(sp);
    g.clumpSize = sp.clumpSize, g.clumpLean = clumps.x, g.clumpHeight = clumps.y, g.clumpLightness = clumps.z;
    g.cellSize = f.cellSize;
    g.segments = sp.segments;
    g.seed = static_cast<uint32_t>(f.seed);
    g.fade = isUnique(f) ? 0 : field.view->settings<GrassDrawing>().fade;
    g.index = static_cast<int>(index);
    g.translucency = sp.translucency, g.gloss = sp.gloss, g.roughness = sp.roughness;
    g.maskRadius = s.shade.radius, g.maskHeight = s.shade.top;
    writeBuffer(ctx.gpu, s.globals, kOwner, sizeof(g), &g);
}

// All species of a field are drawn by one program, which reads a density map if any of them has one.
void publishDensities(DrawContext& ctx, Field& field) {
    const GrassField& f = field.grows();
    const Terrain& t = *ctx.shared.ground.terrain;
    const auto bare = [](const Species& s) { return !s.density.present(); };
    const bool some =
        has(field.view->own, Feature::GrassDensity) && std::any_of(f.species.begin(), f.species.end(), bare);
    if (!some) field.everywhere = {};
    if (some && !field.everywhere.id()) {
        const uint8_t one = 255;
        field.everywhere = makeTexture2D(ctx.gpu, "grass/density", GL_R8, 1, 1);
        glTextureSubImage2D(field.everywhere.id(), 0, 0, 0, 1, 1, GL_RED, GL_UNSIGNED_BYTE, &one);
    }
    const std::vector<std::string> selectors = elementSelectors(speciesList(), &f.species);
    for (size_t i = 0; i < f.species.size(); ++i)
        field.species[i]->density =
            bare(f.species[i])
                ? field.everywhere.id()
                : ctx.maps.get("grass/density",
                               fmt::format("{}.GrassField.species[{}].density", field.name, selectors[i]),
                               f.species[i].density.map, false, tilingOf(t, f.species[i].densityTiling).repeats);
}

void publishMaps(DrawContext& ctx, Field& field) {
    const GrassField& f = field.grows();
    const Terrain& t = *ctx.shared.ground.terrain;
    publishDensities(ctx, field);
    const auto texture = [&](const MapField& m, const char* name, const char* owner, bool srgb, bool repeats) {
        return m.present() ? ctx.maps.get(owner, field.name + ".GrassField." + name, m.map, srgb, repeats) : 0;
    };
    field.orientation = texture(f.orientation, "orientation", "grass/orientation", false, true);
    field.vegetation = texture(f.vegetation, "vegetation", "grass/vegetation", true, true);
    field.forces = texture(f.forces, "forces", "grass/force-map", false, true);
    field.bladeHeights =
        texture(f.bladeHeight, "bladeHeight", "grass/heights", false, tilingOf(t, f.bladeHeightTiling).repeats);
    field.occlusion = texture(f.ambientOcclusion, "ambientOcclusion", "grass/occlusion", false, true);
}

void writeCover(DrawContext& ctx, Field& field) {
    const GrassField& f = field.grows();
    const FieldTiers& tiers = field.view->tiers;
    const FarLook& far = field.view->settings<FarLook>();
    CoverGlobals cover{};
    cover.speciesCount = static_cast<int>(field.species.size());
    cover.minGeom = tiers.blades.min, cover.geomInv = tiers.blades.inv;
    cover.cellSize = f.cellSize;
    cover.orientationTiling = f.orientationTiling, cover.vegetationTiling = f.vegetationTiling;
    cover.occlusionTiling = f.ambientOcclusionTiling, cover.forceTiling = f.forcesTiling;
    const Terrain& t = *ctx.shared.ground.terrain;
    cover.heightTiling = shaderTiling(t, f.bladeHeightTiling);
    const Wind* wind = windOf(ctx.project);
    for (size_t i = 0; i < field.species.size(); ++i)
        cover.species[i] = {shaderTiling(t, f.species[i].densityTiling),
                            lightLeft(field.species[i]->look, ctx.globals.sunDirection.y),
                            field.species[i]->look.height, wind ? windStrength(*wind, f.species[i]) : 0};
    cover.shadeFrom = tiers.soil.min, cover.shadeInv = tiers.soil.inv;
    cover.farDarkening = far.farDarkening, cover.farDarkeningAt = far.farDarkeningDistance;
    writeBuffer(ctx.gpu, field.cover, kOwner, sizeof(cover), &cover);
}

// --- what the ground is told of what grows on it -----------------------------------------------------------
// A texture among those that the ground reads,
// as its number; -1: none, or no room (check refuses such scenes).
int soilMap(SoilCover& soil, GLuint texture) {
    if (!texture) return -1;
    const auto at = std::find(soil.maps.begin(), soil.maps.end(), texture);
    if (at == soil.maps.end() && soil.maps.size() >= MAX_SOIL_MAPS) return -1;
    const auto number = static_cast<int>(at - soil.maps.begin());
    if (at == soil.maps.end()) soil.maps.push_back(texture);
    return number;
}

void publishSoil(DrawContext& ctx, GrassFields& grass) {
    const Terrain& t = *ctx.shared.ground.terrain;
    SoilCover& soil = ctx.shared.soil;
    soil.maps.clear();
    SoilGlobals g{};
    std::vector<SoilNumbers> numbers;
    size_t species = 0;
    for (size_t i = 0; i < std::min<size_t>(grass.all.size(), MAX_FIELDS); ++i) {
        const Field& field = *grass.all[i];
        const GrassField& f = field.grows();
        // Where its blades shade no ground, the mean does from the eye on.
        const bool drawn = has(field.view->own, Feature::GroundShadows);
        const FadeRange from = drawn ? field.view->tiers.soil : fadeRange(0, 0);
        g.fields[i] = {from.min, from.inv, shaderTiling(t, f.bladeHeightTiling), f.ambientOcclusionTiling};
        numbers.push_back({soilMap(soil, field.bladeHeights), soilMap(soil, field.occlusion), {}});
        for (size_t k = 0; k < field.species.size() && species < MAX_SOIL_SPECIES; ++k, ++species) {
            const FieldSpecies& s = *field.species[k];
            g.species[species] = {lightLeft(s.look, ctx.globals.sunDirection.y),
                                  shaderTiling(t, f.species[k].densityTiling), 0, 0};
            numbers.back().density.push_back(soilMap(soil, f.species[k].density.present() ? s.density : 0));
        }
    }
    soil.constants = soilConstants(numbers);
    writeBuffer(ctx.gpu, grass.soil, kOwner, sizeof(g), &g);
    soil.globals = grass.soil.id();
}

// --- fields ------------------------------------------------------------------------------------------------
// The
// scene's features, but of fields only this one's.
FeatureSet featuresFor(const DrawContext& ctx, const FeatureSet& own) {
    return (ctx.plan.features & ~fieldFeatures()) | own;
}

void updateSpecies(DrawContext& ctx, Field& field, size_t i) {
    const GrassField& f = field.grows();
    FieldSpecies& s = *field.species[i];
    updatePatch(s, f.species[i], f);
    updateUnique(ctx, s, f.species[i], field);
    updateTexture(ctx, s, f.species[i]);
    s.shade = shadeOf(ctx, field.name, i);
    updateLook(s.look, s.lookKey, f.species[i], s.patch, s.key ^ s.bladeHash, s.bladeImage);
    writeGlobals(ctx, s, field, i);
    s.draws = {};
    if (!has(field.view->own, Feature::GrassFar))
        s.slices = {}, s.sliceKey = s.sliceAsked = 0, s.bake = {}, s.sliceGlobals = {};
}

void updateField(DrawContext& ctx, Field& field) {
    field.species.resize(field.grows().species.size());
    for (auto& s : field.species)
        if (!s) s = std::make_unique<FieldSpecies>();
    publishMaps(ctx, field);
    for (size_t i = 0; i < field.species.size(); ++i) updateSpecies(ctx, field, i);
    writeCover(ctx, field);
}

// Fields keep their state by name; those that grow nothing have none.
void findFields(DrawContext& ctx, GrassFields& grass) {
    std::vector<std::unique_ptr<Field>> now;
    for (const auto& [name, entity] : fieldsOf(ctx.project)) {
        const FeatureSet own = fieldFeatures(ctx.tables.techniques, entity, ctx.settings.coarse);
        if (own.none()) continue;
        const auto old =
            std::find_if(grass.all.begin(), grass.all.end(), [&](const auto& f) { return f && f->name == name; });
        now.push_back(old != grass.all.end() ? std::move(*old) : std::make_unique<Field>());
        now.back()->name = name;
        const FeatureSet features = featuresFor(ctx, own);
        now.back()->view.emplace(GrassView{entity, own, features, featureConstants(features),
                                           tiersOf(ctx.tables.techniques, entity, ctx.settings.coarse)});
    }
    grass.all = std::move(now);
}

void update(DrawContext& ctx) {
    GrassFields& grass = ctx.own<GrassFields>();
    if (!ctx.shared.ground.terrain) return;
    findFields(ctx, grass);
    for (const std::unique_ptr<Field>& field : grass.all) updateField(ctx, *field);
    publishSoil(ctx, grass);
    ctx.shared.grass = &grass;
}

const System kSystems[] = {
    {"grass/field", {.reads = {Slot::Sun, Slot::Ground, Slot::Masks}, .writes = {Slot::Grass}}, update}};

}  // namespace

void bindField(const Field& f) {
    static_assert(TEX_ORIENTATION == TEX_BLADE_HEIGHT + 1 && TEX_VEGETATION == TEX_BLADE_HEIGHT + 2 &&
                  TEX_OCCLUSION == TEX_BLADE_HEIGHT + 3);
    const GLuint maps[] = {f.bladeHeights, f.orientation, f.vegetation, f.occlusion};
    glBindTextures(TEX_BLADE_HEIGHT, 4, maps);
    if (f.forces) glBindTextureUnit(TEX_FORCE_MAP, f.forces);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_COVER, f.cover.id());
}

std::vector<Field*> fieldsWith(const DrawContext& ctx, Feature f) {
    std::vector<Field*> out;
    if (!ctx.shared.grass) return out;
    for (const std::unique_ptr<Field>& field : ctx.shared.grass->all)
        if (has(field->view->own, f)) out.push_back(field.get());
    return out;
}

namespace {
CellQuery queryOf(const DrawContext& ctx, const Field& field, size_t i, const Patch& patch, float pixels) {
    const GrassField& f = field.grows();
    return cellQuery({*ctx.shared.ground.terrain, ctx.shared.bounds, f, f.species[i], patch, field.view->tiers.blades,
                      field.view->settings<GrassDrawing>().fade},
                     {ctx.eye, ctx.frustum, pixels});
}
}  // namespace

CellQuery drawnQuery(const DrawContext& ctx, const Field& field, size_t i) {
    const FieldSpecies& s = *field.species[i];
    CellQuery q = queryOf(ctx, field, i, s.drawn(), pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)));
    if (!s.unique.empty()) q.unique = &s.unique;
    return q;
}
CellQuery patchQuery(const DrawContext& ctx, const Field& field, size_t i, float pixels) {
    return queryOf(ctx, field, i, field.species[i]->patch, pixels);
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

bool beginField(DrawContext& ctx, const Field& field, size_t program, const std::string& constants) {
    endTransparency();
    if (!ctx.use(program, constants, &field.view->constants)) return false;
    bindField(field);
    beginTransparency(ctx, field);
    return true;
}

void beginTransparency(const DrawContext& ctx, const Field& field) {
    if (ctx.settings.mode == ViewMode::Overdraw) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        return;
    }
    const Transparency way = field.view->settings<GrassDrawing>().transparency;
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

std::string fieldConstants(const GrassDrawing& drawing, const GrassSlices& slices) {
    return fmt::format(
        "const int TRANSPARENCY = {};\nconst int STORAGE = {};\nconst bool LIGHT_COSINE = {};\nconst bool "
        "WEIGHTS_PER_PIXEL = {};\nconst bool CONSERVING = {};\n",
        static_cast<int>(drawing.transparency), static_cast<int>(slices.storage),
        slices.lightWeights == LightWeighting::Cosine, slices.weightsAt == WeightsAt::Pixel,
        slices.sliceCover == SliceCover::Conserving);
}
std::string fieldConstants(const FieldEntity& f) {
    return fieldConstants(f.settings<GrassDrawing>(), f.settings<GrassSlices>());
}

std::vector<std::string> fieldVariants() {
    std::vector<std::string> out;
    GrassDrawing drawing;
    GrassSlices slices;
    const auto add = [&] { out.push_back(fieldConstants(drawing, slices)); };
    for (const Storage storage : {Storage::Factored, Storage::Compressed, Storage::Full})
        for (const LightWeighting weights : {LightWeighting::Atan, LightWeighting::Cosine})
            for (const WeightsAt at : {WeightsAt::Vertex, WeightsAt::Pixel}) {
                slices.storage = storage, slices.lightWeights = weights, slices.weightsAt = at;
                add();
            }
    for (const Transparency way :
         {Transparency::Coverage, Transparency::Both, Transparency::Test, Transparency::Blend}) {
        drawing.transparency = way;
        add();
    }
    slices.sliceCover = SliceCover::Published;
    add();
    return out;
}

void GrassFields::jobs(std::vector<JobNews>& out) const {
    for (const auto& field : all)
        for (const auto& s : field->species)
            if (s && s->bake.active()) out.push_back(s->bake.news());
}

const EffectRow& fieldEffect() {
    static const EffectRow row{
        .name = "grass/field",
        .needs = featureSet(Feature::Grass, Feature::Terrain),
        .systems = kSystems,
        .makeState = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<GrassFields>(); },
        .help = "there is grass: its patches, maps and textures",
        .check = [](const Project& project, double) { return checkFields(project); }};
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

const EffectRow& uniqueEffect() {
    static const EffectRow row{.name = "grass/unique",
                               .needs = featureSet(Feature::GrassUnique),
                               .help = "each cell has blades of its own",
                               .check = checkUnique};
    return row;
}

}  // namespace sward
