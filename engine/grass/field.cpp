#include "grass/field.h"

#include "core/hash.h"
#include "core/numerics.h"
#include "grass/cells.h"
#include "grass/drawing.h"
#include "grass/grass_fields.h"
#include "grass/slice_settings.h"
#include "scene/field_limits.h"
#include "scene/tiling.h"
#include "shared/soil.h"
#include "world/wind.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/field";

// Of light that comes down to the soil from the sky, and of the sun's from blade to blade (SpeciesInField); where
// nothing was traced, of the sky as much as of the sun.
const TracedLight* tracedHere(const DrawContext& ctx, const Field& field, size_t species) {
    return field.draws(Feature::GrassTraced) ? tracedOf(ctx, field.grown->name, species) : nullptr;
}
glm::vec2 indirect(const DrawContext& ctx, const Field& field, size_t species) {
    const float sun = ctx.globals.sunDirection.y;
    const TracedLight* traced = tracedHere(ctx, field, species);
    if (!traced) return {lightLeft(field.grown->species[species]->look, sun), 0};
    return {traced->soilSky, soilScattered(*traced, sun)};
}

void writeGlobals(DrawContext& ctx, Field& field) {
    const GrassField& f = field.grows();
    const FieldTiers& tiers = field.view->tiers;
    const FarLook& far = field.view->settings<FarLook>();
    FieldGlobals globals{};
    globals.speciesCount = static_cast<int>(field.species.size());
    globals.minGeom = tiers.blades.min, globals.geomInv = tiers.blades.inv;
    globals.cellSize = f.cellSize;
    globals.orientationTiling = f.orientationTiling, globals.vegetationTiling = f.vegetationTiling;
    globals.occlusionTiling = f.ambientOcclusionTiling, globals.forceTiling = f.forcesTiling;
    const Terrain& t = *ctx.shared.ground.terrain;
    globals.heightTiling = shaderTiling(t, f.bladeHeightTiling);
    const Wind* wind = windOf(ctx.project);
    for (size_t i = 0; i < field.species.size(); ++i)
        globals.species[i] = {shaderTiling(t, f.species[i].densityTiling), field.species[i].grown->look.height,
                              wind ? windStrength(*wind, f.species[i]) : 0, indirect(ctx, field, i).x,
                              indirect(ctx, field, i).y};
    globals.shadeFrom = tiers.soil.min, globals.shadeInv = tiers.soil.inv;
    globals.farDarkening = far.farDarkening, globals.farDarkeningAt = far.farDarkeningDistance;
    const uint64_t hash = hashBytes(&globals, sizeof(globals));
    if (field.globals.id() && field.globalsHash == hash) return;
    field.globalsHash = hash;
    writeBuffer(ctx.gpu, field.globals, kOwner, sizeof(globals), &globals);
}

// --- what the ground is told of what grows on it -----------------------------------------------------------
// A texture among those that the ground reads,
// as its number; -1: none, or no room (check refuses such scenes).
int soilMap(SoilGrowth& soil, GLuint texture) {
    if (!texture) return -1;
    const auto at = std::find(soil.maps.begin(), soil.maps.end(), texture);
    if (at == soil.maps.end() && soil.maps.size() >= MAX_SOIL_MAPS) return -1;
    const auto number = static_cast<int>(at - soil.maps.begin());
    if (at == soil.maps.end()) soil.maps.push_back(texture);
    return number;
}

void publishSoil(DrawContext& ctx, GrassFields& grass) {
    const Terrain& t = *ctx.shared.ground.terrain;
    SoilGrowth& soil = ctx.shared.soil;
    soil.maps.clear();
    SoilGlobals g{};
    std::vector<SoilNumbers> numbers;
    size_t species = 0;
    for (size_t i = 0; i < std::min<size_t>(grass.all.size(), MAX_FIELDS); ++i) {
        Field& field = *grass.all[i];
        if (!field.grows().onTerrain) continue;
        const GrassField& f = field.grows();
        // Where its blades shade no ground, the mean does from the eye on.
        const bool drawn = field.draws(Feature::GroundShadows);
        const FadeRange from = drawn ? field.view->tiers.soil : fadeRange(0, 0);
        g.fields[numbers.size()] = {from.min, from.inv, shaderTiling(t, f.bladeHeightTiling), f.ambientOcclusionTiling};
        numbers.push_back({soilMap(soil, field.grown->bladeHeights), soilMap(soil, field.grown->occlusion), {}});
        for (size_t k = 0; k < field.species.size() && species < MAX_SOIL_SPECIES; ++k, ++species) {
            const GrownSpecies& s = *field.grown->species[k];
            const glm::vec2 comes = indirect(ctx, field, k);
            g.species[species] = {{s.look.across, s.look.above},
                                  shaderTiling(t, f.species[k].densityTiling),
                                  comes.x,
                                  comes.y,
                                  s.look.height,
                                  s.shade.top,
                                  0,
                                  {}};
            if (const TracedLight* traced = tracedHere(ctx, field, k))
                setSunFill(g.species[species].sunFill, *traced, ctx.globals.sunDirection);
            numbers.back().density.push_back(soilMap(soil, f.species[k].density.present() ? s.density : 0));
        }
        field.view->constants += othersConstants(numbers.back(), species);
    }
    soil.constants = soilConstants(numbers);
    const uint64_t hash = hashBytes(&g, sizeof(g));
    if (!grass.soil.id() || grass.soilHash != hash) writeBuffer(ctx.gpu, grass.soil, kOwner, sizeof(g), &g);
    grass.soilHash = hash;
    soil.globals = grass.soil.id();
    bindSoil(soil);
}

// --- fields ------------------------------------------------------------------------------------------------
// The horizontal slice stands for all, from the eye on.
void sketchTiers(FieldTiers& tiers) {
    tiers.images = tiers.flat = fadeRange(0, 0);
    tiers.flatFrom = -1;
}
void updateField(DrawContext& ctx, Field& field, const GrownField& grown, size_t number) {
    field.grown = &grown;
    field.number = number;
    const FeatureSet own = fieldFeatures(ctx.tables.techniques, *grown.of, ctx.settings.coarse);
    const FeatureSet features = featuresFor(ctx, own);
    field.view.emplace(GrassView{*grown.of, own, features, featureConstants(features),
                                 tiersOf(ctx.tables.techniques, *grown.of,
                                         pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)), ctx.settings.coarse)});
    if (ctx.sketching() && field.draws(Feature::GrassFar)) sketchTiers(field.view->tiers);
    field.species.resize(grown.species.size());
    for (size_t i = 0; i < field.species.size(); ++i) {
        field.species[i].grown = grown.species[i].get();
        field.species[i].draws = {};
        if (!field.draws(Feature::GrassFar)) field.species[i].sliceGlobals = {};
    }
    writeGlobals(ctx, field);
}

void updateFields(DrawContext& ctx) {
    GrassFields& grass = ctx.ofView<GrassFields>();
    if (!ctx.shared.grown) return;
    const GrownFields& grown = *ctx.shared.grown;
    grass.all.resize(grown.all.size());
    for (size_t i = 0; i < grass.all.size(); ++i) {
        if (!grass.all[i]) grass.all[i] = std::make_unique<Field>();
        updateField(ctx, *grass.all[i], *grown.all[i], i);
    }
    publishSoil(ctx, grass);
    ctx.shared.grass = &grass;
}

const System kSystems[] = {
    {"grass/field/grown",
     {.reads = {Slot::Sun, Slot::Ground, Slot::Masks, Slot::Traced}, .writes = {Slot::Grown}},
     growFields,
     true},
    {"grass/field", {.reads = {Slot::Sun, Slot::Ground, Slot::Grown}, .writes = {Slot::Grass}}, updateFields}};

}  // namespace

void bindField(const Field& f) {
    const GrownField& g = *f.grown;
    static_assert(TEX_ORIENTATION == TEX_BLADE_HEIGHT + 1 && TEX_VEGETATION == TEX_BLADE_HEIGHT + 2 &&
                  TEX_OCCLUSION == TEX_BLADE_HEIGHT + 3);
    const GLuint maps[] = {g.bladeHeights, g.orientation, g.vegetation, g.occlusion};
    glBindTextures(TEX_BLADE_HEIGHT, 4, maps);
    if (g.forces) glBindTextureUnit(TEX_FORCE_MAP, g.forces);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FIELD, f.globals.id());
}

std::vector<Field*> fieldsWith(const DrawContext& ctx, Feature f) {
    std::vector<Field*> out;
    if (!ctx.shared.grass) return out;
    for (const std::unique_ptr<Field>& field : ctx.shared.grass->all)
        if (field->draws(f)) out.push_back(field.get());
    return out;
}

namespace {
CellQuery queryOf(const DrawContext& ctx, const Field& field, size_t i, const Patch& patch, float pixels) {
    const GrassField& f = field.grows();
    CellQuery q = cellQuery({*ctx.shared.ground.terrain, ctx.shared.bounds, f, f.species[i], patch,
                             field.view->tiers.blades, field.view->settings<GrassDrawing>().fade},
                            {ctx.eye, ctx.frustum, pixels});
    if (!q.density) return q;
    q.ranges = &field.species[i].grown->ranges;
    keepRangesOf(*q.ranges, *q.density, q.densityTiling, q.cellSize);
    return q;
}
}  // namespace

CellQuery drawnQuery(const DrawContext& ctx, const Field& field, size_t i) {
    const GrownSpecies& s = *field.species[i].grown;
    CellQuery q = queryOf(ctx, field, i, s.drawn(), pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)));
    if (!s.unique.empty()) q.unique = &s.unique;
    return q;
}
CellQuery patchQuery(const DrawContext& ctx, const Field& field, size_t i, float pixels) {
    return queryOf(ctx, field, i, field.species[i].grown->patch, pixels);
}

bool isSownWhole(const Field& field) {
    return std::all_of(field.species.begin(), field.species.end(), [](const FieldSpecies& s) {
        const f32::Sown& sown = s.grown->patch.sown;
        return sown.step == 0 && sown.share == 1;
    });
}

void describeCells(GLuint mesh, GLuint cells, size_t stride, GLuint indices) {
    static_assert(offsetof(CellInstance, corner) == offsetof(SliceCell, x) &&
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
    if (blends(field.view->settings<GrassDrawing>().transparency)) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
}
void endTransparency() { glDisable(GL_BLEND); }

std::string fieldConstants(const GrassDrawing& drawing, const GrassSlices& slices) {
    return fmt::format(
        "const int TRANSPARENCY = {};\nconst int STORAGE = {};\nconst bool LIGHT_COSINE = {};\nconst bool "
        "WEIGHTS_PER_PIXEL = {};\nconst bool CONSERVING = {};\n",
        static_cast<int>(drawing.transparency), static_cast<int>(slices.storage),
        weightingOf(slices) == LightWeighting::Cosine, slices.weightsAt == WeightsAt::Pixel,
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
    out.push_back(fieldConstants({}, {}) + othersConstants({-1, -1, {0, -1}}, 2));
    return out;
}

const EffectRow& fieldEffect() {
    static const EffectRow row{
        .name = "grass/field",
        .needs = featureSet(Feature::Grass, Feature::Terrain),
        .systems = kSystems,
        .makeState = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<GrownFields>(); },
        .help = "there is grass: its patches, maps and textures",
        .makeView = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<GrassFields>(); },
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

}  // namespace sward
