#include "grass/grown.h"

#include "core/hash.h"
#include "core/numerics.h"
#include "grass/drawing.h"
#include "grass/grass_fields.h"
#include "grass/mask.h"
#include "scene/tiling.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/field";

void updatePatch(GrownSpecies& s, const Species& species, const GrassField& field) {
    const uint64_t key = patchKey(species, field.cellSize, static_cast<uint32_t>(field.seed));
    if (s.key == key) return;
    s.key = key;
    s.patch = makePatch(species, field.cellSize, static_cast<uint32_t>(field.seed));
}

void updateUnique(const DrawContext& ctx, GrownSpecies& s, const Species& species, const GrownField& of) {
    const Terrain& t = *ctx.shared.ground.terrain;
    const GrassField& field = of.grows();
    if (!of.draws(Feature::GrassUnique)) {
        s.unique = {}, s.uniqueOf = 0, s.uniqueDensity = {};
        return;
    }
    const uint64_t key = uniqueKey(species, field, t);
    if (s.uniqueOf == key && !s.unique.empty() && s.uniqueDensity.sameTiles(species.density.map)) return;
    s.uniqueOf = key, s.uniqueDensity = species.density.map;
    s.uniqueKey = (s.uniqueKey + key) * 0x9E3779B97F4A7C15ull + 1;
    s.unique = makeUnique(species, field, t);
}

void updateTexture(DrawContext& ctx, GrownSpecies& s, const Species& species) {
    if (s.textureOf == species.texture) return;
    s.textureOf = species.texture;
    s.bladeImage = bladeImage(ctx.project, species);
    s.bladeHash = hashBytes(s.bladeImage.pixels.data(), s.bladeImage.pixels.size());
    s.cover = alphaMoments(s.bladeImage);
    s.imageColor = meanColor(s.bladeImage);
    s.bladeTexture = makeBladeTexture(ctx.gpu, kOwner, s.bladeImage);
}

void writeGlobals(DrawContext& ctx, GrownSpecies& s, const GrownField& field, size_t index) {
    const GrassField& f = field.grows();
    const Species& sp = f.species[index];
    SpeciesGlobals g{};
    g.rootColor = sp.rootColor, g.midColor = sp.midColor, g.tipColor = sp.tipColor;
    g.rootOpen = sp.rootOcclusion;
    g.leanAtFull = leanAtFull(sp);
    const glm::vec3 clumps = clumpStrengths(sp);
    g.clumpSize = sp.clumpSize, g.clumpLean = clumps.x, g.clumpHeight = clumps.y, g.clumpLightness = clumps.z;
    g.cellSize = f.cellSize;
    g.segments = sp.segments;
    g.seed = static_cast<uint32_t>(f.seed);
    g.fade = isUnique(f) ? 0 : field.of->settings<GrassDrawing>().fade;
    g.index = static_cast<int>(index);
    g.translucency = sp.translucency, g.gloss = sp.gloss, g.roughness = sp.roughness;
    const f32::Sown& sown = s.drawn().sown;
    g.spread = sown.spread, g.step = sown.step, g.sownShare = sown.share;
    g.sowSeed = sowingSeed(sp, g.seed);
    g.area = {s.look.across, s.look.above};
    setCover(g, s.cover);
    g.imageColor = s.imageColor;
    setTraced(g, field.draws(Feature::GrassTraced) ? tracedOf(ctx, field.name, index) : nullptr);
    g.maskRadius = s.shade.radius, g.maskHeight = s.shade.top, g.maskReach = s.shade.reach;
    const uint64_t hash = hashBytes(&g, sizeof(g));
    if (s.globals.id() && s.globalsHash == hash) return;
    s.globalsHash = hash;
    writeBuffer(ctx.gpu, s.globals, kOwner, sizeof(g), &g);
}

// All species of a field are drawn by one program, which reads a density map if any of them has one.
void publishDensities(DrawContext& ctx, GrownField& field) {
    const GrassField& f = field.grows();
    const Terrain& t = *ctx.shared.ground.terrain;
    const auto bare = [](const Species& s) { return !s.density.present(); };
    const bool some = field.draws(Feature::GrassDensity) && std::any_of(f.species.begin(), f.species.end(), bare);
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

void publishMaps(DrawContext& ctx, GrownField& field) {
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

// Of a field that grows on meshes alone: its maps lie on the terrain, and their textures go.
void forgetMaps(GrownField& field) {
    field.everywhere = {};
    field.orientation = field.vegetation = field.forces = field.bladeHeights = field.occlusion = 0;
    for (const auto& s : field.species) s->density = 0;
}

void updateSpecies(DrawContext& ctx, GrownField& field, size_t i) {
    const GrassField& f = field.grows();
    GrownSpecies& s = *field.species[i];
    updatePatch(s, f.species[i], f);
    updateUnique(ctx, s, f.species[i], field);
    updateTexture(ctx, s, f.species[i]);
    s.shade = shadeOf(ctx, field.name, i);
    updateLook(s.look, s.lookKey, f.species[i], s.patch, s.key ^ s.bladeHash, s.bladeImage);
    writeGlobals(ctx, s, field, i);
    if (!field.draws(Feature::GrassFar) && !field.draws(Feature::GrassOnMeshes))
        s.slices = {}, s.sliceKey = s.sliceAsked = 0, s.bake = {}, s.lampGains = {}, s.sunGains = {};
}

void updateField(DrawContext& ctx, GrownField& field) {
    field.species.resize(field.grows().species.size());
    for (auto& s : field.species)
        if (!s) s = std::make_unique<GrownSpecies>();
    field.grows().onTerrain ? publishMaps(ctx, field) : forgetMaps(field);
    for (size_t i = 0; i < field.species.size(); ++i) updateSpecies(ctx, field, i);
    updateDensitiesAmong(field.among, field.grows(), *ctx.shared.ground.terrain);
}

// Fields keep what they have by name; those that grow nothing have none.
void findFields(DrawContext& ctx, GrownFields& grown) {
    std::vector<std::unique_ptr<GrownField>> now;
    for (const auto& [name, entity] : fieldsOf(ctx.project)) {
        const FeatureSet own = fieldFeatures(ctx.tables.techniques, entity);
        if (own.none()) continue;
        const auto old =
            std::find_if(grown.all.begin(), grown.all.end(), [&](const auto& f) { return f && f->name == name; });
        now.push_back(old != grown.all.end() ? std::move(*old) : std::make_unique<GrownField>());
        GrownField& field = *now.back();
        field.name = name;
        field.number = now.size() - 1;
        field.of.emplace(entity);
        field.own = own;
        field.features = featuresFor(ctx, own);
    }
    grown.all = std::move(now);
}

}  // namespace

FeatureSet featuresFor(const DrawContext& ctx, const FeatureSet& own) {
    return (ctx.plan.features & ~fieldFeatures()) | own;
}

void growFields(DrawContext& ctx) {
    GrownFields& grown = ctx.own<GrownFields>();
    if (!ctx.shared.ground.terrain) return;
    findFields(ctx, grown);
    for (const std::unique_ptr<GrownField>& field : grown.all) updateField(ctx, *field);
    ctx.shared.grown = &grown;
}

Rgba8 bladeImage(const Project& project, const Species& species) {
    Rgba8 image = species.texture.empty() ? Rgba8{} : loadColorImage(project.dir / species.texture);
    return image.pixels.empty() ? makeBladeImage(32, 128) : image;
}

void GrownFields::jobs(std::vector<JobNews>& out) const {
    for (const auto& field : all)
        for (const auto& s : field->species)
            if (s && s->bake.active()) out.push_back(s->bake.news());
}

const EffectRow& uniqueEffect() {
    static const EffectRow row{.name = "grass/unique",
                               .needs = featureSet(Feature::GrassUnique),
                               .help = "each cell has blades of its own",
                               .check = checkUnique};
    return row;
}

}  // namespace sward
