#include "grass/grass_fields.h"

#include <algorithm>

#include "grass/drawing.h"
#include "grass/mesh_grass_settings.h"
#include "scene/field_rows.h"

namespace sward {
namespace {

constexpr FieldRow kBladeHeightTiling = tiling("bladeHeightTiling", offsetof(GrassField, bladeHeightTiling),
                                               "repeats of the blade-height map over the terrain's mapSize");
constexpr MapRow kBladeHeights{
    .type = PixelType::U8, .tiling = &kBladeHeightTiling, .least = "0 no height", .most = "1 full height"};
constexpr FieldRow kBladeHeight = map("bladeHeight", offsetof(GrassField, bladeHeight), &kBladeHeights,
                                      "share of their height that blades have; none: all of it");

constexpr FieldRow kDensityTiling =
    tiling("densityTiling", offsetof(Species, densityTiling), "repeats of the density map over the terrain's mapSize");
constexpr FieldRow kBladesPerM2 = real("bladesPerM2", offsetof(Species, bladesPerM2), "blades/m2", {0, 1e6, 0, 1e5},
                                       "blades on a square metre at density 1");
constexpr MapRow kDensity{.role = MapRole::Density,
                          .texelsPerMetre = 8,
                          .tiling = &kDensityTiling,
                          .bladesPerM2 = &kBladesPerM2,
                          .packedWith = &kBladeHeight};
constexpr FieldRow kSpeciesFields[] = {
    text("name", offsetof(Species, name), "how paths and map files name the species"),
    under("Where it grows", map("density", offsetof(Species, density), &kDensity,
                                "where it grows: share of bladesPerM2; none: everywhere")),
    kDensityTiling,
    kBladesPerM2,
    under("Shape", real("height", offsetof(Species, height), "m", {0, 20, 0.01, 1.5}, "mean length of a blade")),
    real("heightVariation", offsetof(Species, heightVariation), "", kShare,
         "how much lengths differ, as a share, both ways"),
    real("width", offsetof(Species, width), "m", {0, 1, 0.001, 0.05}, "width at the widest place of a blade"),
    real("bend", offsetof(Species, bend), "", {0, 2, 0, 1}, "how far the tip droops, as a share of the length"),
    real("leanDeg", offsetof(Species, leanDeg), "deg", {0, 90, 0, 60}, "mean lean from the vertical"),
    real("leanVariationDeg", offsetof(Species, leanVariationDeg), "deg", {0, 90, 0, 45},
         "how much the lean differs, both ways"),
    real("stiffness", offsetof(Species, stiffness), "", {0.05, 100, 0.25, 4},
         "how much it resists the wind: 2 leans half as far, 0.5 twice as far; what presses it lays it down all the "
         "same"),
    number(FieldType::Int, "segments", offsetof(Species, segments), "", {1, 16, 1, 8}, "quads along a blade"),
    number(FieldType::Int, "smoothness", offsetof(Species, smoothness), "", {1, 64, 1, 16},
           "quads along a blade at most, where it is tessellated"),
    under("Colour",
          imageFile("texture", offsetof(Species, texture), "image of a blade with alpha; none: made by the program")),
    color("rootColor", offsetof(Species, rootColor), kReflectance, "reflectance at the root"),
    color("midColor", offsetof(Species, midColor), kReflectance, "reflectance half-way up"),
    color("tipColor", offsetof(Species, tipColor), kReflectance, "reflectance at the tip"),
    real("hueVariationDeg", offsetof(Species, hueVariationDeg), "deg", {0, 180, 0, 30},
         "how much the hue differs by blade, both ways"),
    real("lightnessVariation", offsetof(Species, lightnessVariation), "", kShare,
         "how much the lightness differs by blade, both ways"),
    under("Light", real("rootOcclusion", offsetof(Species, rootOcclusion), "", kShare,
                        "share of ambient light left at the root")),
    under("Shape", real("clumpSize", offsetof(Species, clumpSize), "m", {0, 1000, 0, 3}, "size of clumps; 0: none")),
    real("clumpStrength", offsetof(Species, clumpStrength), "", kShare,
         "share of lean, height and tint that a clump has in common"),
    under("Light", real("translucency", offsetof(Species, translucency), "", {0, 2, 0, 1},
                        "light that shines through a blade, as a share of what it reflects; 0: none")),
    real("gloss", offsetof(Species, gloss), "", {0, 10, 0, 2}, "waxy highlight, as a factor of a leaf's; 0: none"),
    real("roughness", offsetof(Species, roughness), "", {0.05, 1, 0.3, 0.8}, "spread of the highlight"),
};
constexpr ListRow kSpeciesList = listRow<Species>(kSpeciesFields);

constexpr FieldRow kOrientationTiling = tiling("orientationTiling", offsetof(GrassField, orientationTiling),
                                               "repeats of the orientation map over the terrain's mapSize");
constexpr FieldRow kVegetationTiling = tiling("vegetationTiling", offsetof(GrassField, vegetationTiling),
                                              "repeats of the vegetation map over the terrain's mapSize");
constexpr FieldRow kOcclusionTiling = tiling("ambientOcclusionTiling", offsetof(GrassField, ambientOcclusionTiling),
                                             "repeats of the ambient-occlusion map over the terrain's mapSize");
constexpr FieldRow kForcesTiling = tiling("forcesTiling", offsetof(GrassField, forcesTiling),
                                          "repeats of the map of forces over the terrain's mapSize");
constexpr MapRow kOrientation{.kind = MapKind::Directions, .channels = 2, .tiling = &kOrientationTiling};
constexpr MapRow kVegetation{.kind = MapKind::Colours,
                             .channels = 4,
                             .type = PixelType::U8,
                             .tiling = &kVegetationTiling,
                             .least = "0 grass",
                             .most = "1 covered"};
constexpr MapRow kOcclusion{.type = PixelType::U8, .tiling = &kOcclusionTiling, .least = "0 closed", .most = "1 open"};
constexpr MapRow kPaintedForces{
    .kind = MapKind::Forces, .channels = 4, .type = PixelType::U8, .texelsPerMetre = 8, .tiling = &kForcesTiling};
constexpr FieldRow kFields[] = {
    name("technique", offsetof(GrassField, technique), "how the grass is drawn"),
    listOf("species", offsetof(GrassField, species), &kSpeciesList, "the kinds of blade that grow here"),
    under(kAdvanced, real("cellSize", offsetof(GrassField, cellSize), "m", {0.05, 100, 0.1, 4},
                          "side of the square of blades that is repeated")),
    whole("seed", offsetof(GrassField, seed), "", {0, 2147483647, 0, 1000}, "another number: other blades"),
    under("Maps", map("orientation", offsetof(GrassField, orientation), &kOrientation,
                      "direction x, z about 0.5 in which blades lean")),
    map("vegetation", offsetof(GrassField, vegetation), &kVegetation, "colour and opacity over the blades' own colour"),
    map("ambientOcclusion", offsetof(GrassField, ambientOcclusion), &kOcclusion,
        "share of the sky that the ground sees"),
    map("forces", offsetof(GrassField, forces), &kPaintedForces,
        "what presses on the blades: pushed towards x, z about 0.5, pressed down by B; all times A"),
    kBladeHeight,
    under(kAdvanced, kOrientationTiling),
    kVegetationTiling,
    kOcclusionTiling,
    kForcesTiling,
    kBladeHeightTiling,
    choice("population", &GrassField::population, offsetof(GrassField, population), kPopulations,
           "patch: one cell's blades repeated in every cell; unique: every blade its own, for small scenes"),
    under("Maps", flag("onTerrain", offsetof(GrassField, onTerrain),
                       "it grows over the terrain; off: on those objects alone whose MeshGrass names it")),
};

// What grows, whoever draws it.
FeatureSet populationFeatures(const GrassField& g) {
    FeatureSet s = featureSet(Feature::Grass);
    for (const Species& species : g.species) {
        if (!(species.bladesPerM2 > 0)) continue;
        if (species.density.present()) s |= featureSet(Feature::GrassDensity);
        if (species.clumpSize > 0 && species.clumpStrength > 0) s |= featureSet(Feature::GrassClumps);
        if (species.translucency > 0) s |= featureSet(Feature::Translucency);
        if (species.gloss > 0) s |= featureSet(Feature::Gloss);
    }
    if (g.orientation.present()) s |= featureSet(Feature::GrassOrientation);
    if (g.bladeHeight.present()) s |= featureSet(Feature::GrassHeights);
    if (g.vegetation.present()) s |= featureSet(Feature::GrassVegetation);
    if (g.forces.present()) s |= featureSet(Feature::ForceMap);
    if (g.ambientOcclusion.present()) s |= featureSet(Feature::GrassOcclusion);
    return s;
}

// What settings ask for of grass that is drawn as `drawn` says.
FeatureSet settingsFeatures(const FieldEntity& field, const FeatureSet& drawn) {
    const auto& drawing = field.settings<GrassDrawing>();
    const auto& far = field.settings<FarLook>();
    const bool tessellated = has(drawn, Feature::GrassTessellated);
    const bool blades = has(drawn, Feature::GrassGeometry) || tessellated;
    // Tessellated blades throw no shadows: the horizontal slice does in their stead.
    const bool shades = has(drawn, Feature::GrassGeometry) || has(drawn, Feature::GrassSlices) ||
                        has(drawn, Feature::GrassRaytraced) || (tessellated && has(drawn, Feature::GrassFar));
    FeatureSet s;
    if (drawing.transparency != Transparency::Coverage) s |= featureSet(Feature::GrassBlended);
    if (drawn.any() && drawing.shadowMask > 0) s |= featureSet(Feature::BladeShadows);
    if (has(s, Feature::BladeShadows) && drawing.bakeLight == BakeLight::Traced) s |= featureSet(Feature::GrassTraced);
    if (shades && drawing.groundShadows) s |= featureSet(Feature::GroundShadows);
    if (blades && field.grows.population == Population::Unique) s |= featureSet(Feature::GrassUnique);
    if (far.farBlur != FarBlur::None) s |= featureSet(Feature::FarBlur);
    if (far.farDarkening > 0) s |= featureSet(Feature::FarDarkening);
    return s;
}

// What a field asks for that grows on meshes alone: its maps lie on the terrain, and are not read.
FeatureSet meshFeatures(const FieldEntity& field, const FeatureSet& drawn) {
    FeatureSet s = featureSet(Feature::Grass, Feature::GrassOnMeshes);
    if (has(drawn, Feature::GrassGeometry)) s |= featureSet(Feature::GrassMeshGeometry);
    s |= populationFeatures(field.grows) & featureSet(Feature::GrassClumps, Feature::Translucency, Feature::Gloss);
    const auto& drawing = field.settings<GrassDrawing>();
    if (drawing.shadowMask > 0) s |= featureSet(Feature::BladeShadows);
    if (has(s, Feature::BladeShadows) && drawing.bakeLight == BakeLight::Traced) s |= featureSet(Feature::GrassTraced);
    return s | (settingsFeatures(field, {}) & featureSet(Feature::GrassBlended));
}

// A blade that has no height or no width is not seen.
void checkField(const Registry& registry, Entity e, const std::string& path, std::vector<ComponentFault>& out) {
    const GrassField& field = *registry.get<GrassField>(e);
    for (size_t i = 0; i < field.species.size(); ++i) {
        const Species& s = field.species[i];
        for (const auto& [name, value] : {std::pair("height", s.height), std::pair("width", s.width)})
            if (s.bladesPerM2 > 0 && value == 0)
                out.push_back({fmt::format("species[{}].{}", i, name),
                               fmt::format("{}.species[{}].{} is 0: none of its blades is seen; raise it, or set "
                                           "bladesPerM2 to 0",
                                           path, s.name, name)});
    }
}

FeatureSet featuresOnEntity(const Registry& registry, Entity e, const Tables& tables, bool coarse) {
    return fieldFeatures(tables.techniques, {registry, e, *registry.get<GrassField>(e)}, coarse);
}

}  // namespace

FeatureSet fieldFeatures(std::span<const TechniqueRow> techniques, const FieldEntity& field, bool coarse) {
    const auto grows = [](const Species& s) { return s.bladesPerM2 > 0; };
    if (std::none_of(field.grows.species.begin(), field.grows.species.end(), grows)) return {};
    const TechniqueRow* row = findTechnique(techniques, field.grows.technique);
    const FeatureSet drawn = row ? row->features(field) : FeatureSet{};
    const FeatureSet onMeshes =
        growsOnMeshes(field) ? meshFeatures(field, coarse ? FeatureSet{} : drawn) : FeatureSet{};
    if (!field.grows.onTerrain) return onMeshes;
    const FeatureSet all = populationFeatures(field.grows) | drawn | settingsFeatures(field, drawn);
    if (!coarse) return all | onMeshes;
    return ((row && row->coarse ? row->coarse(all) : all) & ~featureSet(Feature::GroundShadows)) | onMeshes;
}

const ListRow& speciesList() { return kSpeciesList; }

ComponentRow grassFieldRow(std::span<const char* const> techniques, std::vector<FieldRow>& fields) {
    fields.assign(std::begin(kFields), std::end(kFields));
    fields[0].options = techniques;
    ComponentRow row = componentRow<GrassField>("GrassField", "Grass over the whole terrain.", fields,
                                                [](const void*) { return FeatureSet{}; });
    row.featuresOnEntity = featuresOnEntity;
    row.check = checkField;
    return row;
}

ComponentRow farLookRow() {
    static constexpr FieldRow kFarFields[] = {
        choice("farBlur", &FarLook::farBlur, offsetof(FarLook, farBlur), kFarBlurs,
               "blurs what is far, against sparkling: with equal weights, or a bell's"),
        real("farBlurDistance", offsetof(FarLook, farBlurDistance), "m", {0.1, 1e6, 10, 300},
             "distance at which that blur is full"),
        real("farDarkening", offsetof(FarLook, farDarkening), "", kShare,
             "share of their light that far blades lose, which shows depth; 0: none"),
        real("farDarkeningDistance", offsetof(FarLook, farDarkeningDistance), "m", {0.1, 1e6, 10, 300},
             "distance at which they have lost it"),
    };
    return settingsRow<FarLook>("FarLook", "How grass far away is blurred and darkened.", kFarFields, "GrassField");
}

}  // namespace sward
