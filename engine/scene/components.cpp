// The field tables of the shared components. Index: field helpers · Transform · Terrain · GrassField · Light, Sky, Fog
// · Water · Flowers · StaticMesh · Rolling · Camera · CameraPath · rows · features of a scene.
#include "scene/components.h"

#include <cstddef>

namespace sward {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kFarM = 1e8;         // no position lies farther from the origin
constexpr double kBrightest = 65504;  // the largest half: brighter light would turn infinite in a render target

// --- field helpers: one a type, so that a table's line says only what differs -----------------------------------
struct Range {
    double hardMin, hardMax, softMin, softMax;
};
constexpr Range kShare{0, 1, 0, 1};
constexpr Range kTiling{0.001, 10000, 1, 50};

constexpr FieldRow number(FieldType type, const char* name, size_t offset, const char* unit, Range r,
                          const char* help) {
    return {name, type, offset, unit, r.hardMin, r.hardMax, r.softMin, r.softMax, help};
}
constexpr FieldRow real(const char* name, size_t offset, const char* unit, Range r, const char* help) {
    return number(FieldType::Float, name, offset, unit, r, help);
}
constexpr FieldRow distance(const char* name, size_t offset, Range r, const char* help) {
    FieldRow row = real(name, offset, "m", r, help);
    row.allowInf = true;
    return row;
}
constexpr FieldRow seconds(const char* name, size_t offset, Range r, const char* help) {
    FieldRow row = distance(name, offset, r, help);
    row.unit = "s";
    return row;
}
constexpr FieldRow color(const char* name, size_t offset, Range r, const char* help) {
    return number(FieldType::Color, name, offset, "", r, help);
}
constexpr FieldRow text(const char* name, size_t offset, const char* help) {
    return number(FieldType::String, name, offset, "", {}, help);
}
constexpr FieldRow imageFile(const char* name, size_t offset, const char* help) {
    FieldRow row = text(name, offset, help);
    row.isFile = true;
    return row;
}
constexpr FieldRow meshFile(const char* name, size_t offset, const char* help) {
    FieldRow row = imageFile(name, offset, help);
    row.isMesh = true;
    return row;
}
constexpr FieldRow flag(const char* name, size_t offset, const char* help) {
    return number(FieldType::Bool, name, offset, "", {}, help);
}
// `known` must outlive the row; fields beside the map that it names must stand in the same table.
constexpr FieldRow map(const char* name, size_t offset, const MapRow* known, const char* help) {
    FieldRow row = number(FieldType::Map, name, offset, "", {}, help);
    row.map = known;
    if (known->role == MapRole::Heights) row.unit = "m";
    return row;
}
// How often a map repeats over Terrain.mapSize, a float.
constexpr FieldRow tiling(const char* name, size_t offset, const char* help) {
    return real(name, offset, "", kTiling, help);
}

// --- Transform ---------------------------------------------------------------------------------------------------
constexpr Range kPosition{-kFarM, kFarM, -1000, 1000};
constexpr FieldRow kTransformFields[] = {
    number(FieldType::Vec3, "position", offsetof(Transform, position), "m", kPosition,
           "where the origin of the entity lies"),
};
FeatureSet transformFeatures(const void*) { return {}; }

// --- Terrain -----------------------------------------------------------------------------------------------------
constexpr FieldRow kHeightRange =
    number(FieldType::Vec2, "heightRange", offsetof(Terrain, heightRange), "m", {-1e5, 1e5, -100, 1000},
           "heights at 0 and at full scale of an integer height map");
constexpr FieldRow kHeightTiling = tiling("heightTiling", offsetof(Terrain, heightTiling),
                                          "repeats of the height map over mapSize, every other one mirrored");
constexpr FieldRow kTerrainMapTiling =
    tiling("terrainMapTiling", offsetof(Terrain, terrainMapTiling), "repeats of the terrain map over mapSize");
constexpr MapRow kHeights{.role = MapRole::Heights,
                          .type = PixelType::F32,
                          .tiling = &kHeightTiling,
                          .heightRange = &kHeightRange,
                          .least = "low",
                          .most = "high"};
constexpr MapRow kTerrainMap{.kind = MapKind::Colours,
                             .channels = 4,
                             .type = PixelType::U8,
                             .tiling = &kTerrainMapTiling,
                             .least = "0 soil",
                             .most = "1 covered"};
constexpr FieldRow kTerrainFields[] = {
    number(FieldType::Vec2, "size", offsetof(Terrain, size), "m", {0.1, 1e6, 1, 1000}, "extent along x and z"),
    map("height", offsetof(Terrain, height), &kHeights,
        "heights; float maps in metres, integer maps span heightRange; none: flat"),
    kHeightRange,
    real("gridSpacing", offsetof(Terrain, gridSpacing), "m", {0.01, 1000, 0.05, 4},
         "distance between vertices of the finest level"),
    real("lodDistance", offsetof(Terrain, lodDistance), "m", {0.1, 1e6, 5, 500},
         "how far the finest level reaches; each next level doubles it"),
    map("terrainMap", offsetof(Terrain, terrainMap), &kTerrainMap, "colour and opacity blended over the tile texture"),
    kHeightTiling,
    kTerrainMapTiling,
    real("mapSize", offsetof(Terrain, mapSize), "m", {0, 1e6, 0, 1000},
         "length over which every map's tiling counts its repeats; 0: the whole terrain"),
    imageFile("groundTexture", offsetof(Terrain, groundTexture),
              "image tiled over the ground; none: soil made by the program"),
    real("tileSize", offsetof(Terrain, tileSize), "m", {0.01, 1e4, 0.1, 20},
         "length that one tile of the texture covers"),
    color("groundColor", offsetof(Terrain, groundColor), {0, 4, 0, 1},
          "mean reflectance of the soil, or factor of the texture"),
    flag("castShadows", offsetof(Terrain, castShadows), "hills shade what lies behind them"),
};
FeatureSet terrainFeatures(const void* component) {
    const auto& t = *static_cast<const Terrain*>(component);
    FeatureSet s = featureSet(Feature::Terrain);
    if (t.height.present()) s |= featureSet(Feature::TerrainHeights);
    if (t.terrainMap.present()) s |= featureSet(Feature::TerrainMap);
    if (t.height.present() && t.castShadows) s |= featureSet(Feature::TerrainShadows);
    return s;
}

// --- GrassField --------------------------------------------------------------------------------------------------
constexpr Range kReflectance{0, 1, 0, 0.5};
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
    map("density", offsetof(Species, density), &kDensity, "where it grows: share of bladesPerM2; none: everywhere"),
    kDensityTiling,
    kBladesPerM2,
    real("height", offsetof(Species, height), "m", {0, 20, 0.01, 1.5}, "mean length of a blade"),
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
    imageFile("texture", offsetof(Species, texture), "image of a blade with alpha; none: made by the program"),
    color("rootColor", offsetof(Species, rootColor), kReflectance, "reflectance at the root"),
    color("midColor", offsetof(Species, midColor), kReflectance, "reflectance half-way up"),
    color("tipColor", offsetof(Species, tipColor), kReflectance, "reflectance at the tip"),
    real("hueVariationDeg", offsetof(Species, hueVariationDeg), "deg", {0, 180, 0, 30},
         "how much the hue differs by blade, both ways"),
    real("lightnessVariation", offsetof(Species, lightnessVariation), "", kShare,
         "how much the lightness differs by blade, both ways"),
    real("rootOcclusion", offsetof(Species, rootOcclusion), "", kShare, "share of ambient light left at the root"),
    real("clumpSize", offsetof(Species, clumpSize), "m", {0, 1000, 0, 3}, "size of clumps; 0: none"),
    real("clumpStrength", offsetof(Species, clumpStrength), "", kShare,
         "share of lean, height and tint that a clump has in common"),
    real("translucency", offsetof(Species, translucency), "", {0, 2, 0, 1},
         "light that shines through a blade, as a share of what it reflects; 0: none"),
    real("gloss", offsetof(Species, gloss), "", {0, 10, 0, 2}, "waxy highlight, as a factor of a leaf's; 0: none"),
    real("roughness", offsetof(Species, roughness), "", {0.05, 1, 0.3, 0.8}, "spread of the highlight"),
};
constexpr ListRow kSpeciesList = listRow<Species>(kSpeciesFields);

constexpr Range kTierDistance{0, 1e6, 0, 200};
constexpr FieldRow choice(const char* name, size_t offset, std::span<const char* const> options, const char* help) {
    FieldRow row = number(FieldType::Enum, name, offset, "", {}, help);
    row.options = options;
    return row;
}
// The member's type and the names must be of one enum.
template <class C, class E>
constexpr FieldRow choice(const char* name, E C::*, size_t offset, const EnumNames<E>& options, const char* help) {
    return choice(name, offset, options, help);
}
constexpr FieldRow whole(const char* name, size_t offset, const char* unit, Range r, const char* help) {
    return number(FieldType::Int, name, offset, unit, r, help);
}
constexpr Range kSliceTexels{8, 2048, 32, 512};
constexpr FieldRow speciesField() {
    FieldRow row =
        number(FieldType::List, "species", offsetof(GrassField, species), "", {}, "the kinds of blade that grow here");
    row.list = &kSpeciesList;
    return row;
}
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
constexpr FieldRow kGrassFieldFields[] = {
    choice("technique", offsetof(GrassField, technique), kTechniques, "how the grass is drawn"),
    speciesField(),
    real("cellSize", offsetof(GrassField, cellSize), "m", {0.05, 100, 0.1, 4},
         "side of the square of blades that is repeated"),
    number(FieldType::Int, "seed", offsetof(GrassField, seed), "", {0, 2147483647, 0, 1000},
           "another number: other blades"),
    distance("minGeom", offsetof(GrassField, minGeom), kTierDistance, "up to here every blade is drawn by itself"),
    distance("maxGeom", offsetof(GrassField, maxGeom), kTierDistance,
             "from here no blade is drawn by itself; inf: never fades"),
    distance("minBTF", offsetof(GrassField, minBTF), kTierDistance, "up to here every vertical slice is drawn"),
    distance("maxBTF", offsetof(GrassField, maxBTF), kTierDistance,
             "from here only the horizontal slice is drawn; inf: vertical slices never fade"),
    whole("slices", offsetof(GrassField, slices), "", {1, 64, 4, 20},
          "vertical slices through a cell along x, and as many along z"),
    whole("sliceWidth", offsetof(GrassField, sliceWidth), "texels", kSliceTexels,
          "width of a vertical slice's images, made a power of two"),
    whole("sliceHeight", offsetof(GrassField, sliceHeight), "texels", kSliceTexels,
          "height of a vertical slice's images, made a power of two"),
    whole("farSize", offsetof(GrassField, farSize), "texels", kSliceTexels,
          "side of the horizontal slice's images, made a power of two"),
    real("farHeight", offsetof(GrassField, farHeight), "", kShare,
         "where the horizontal slice lies, as a share of the tallest blade's height"),
    choice("storage", offsetof(GrassField, storage), kStorages,
           "how slices are stored: factored, compressed, or an image a light as published"),
    choice("sliceCover", offsetof(GrassField, sliceCover), kSliceCovers,
           "slices cover what the blades would in this view, or all that they hold, as published"),
    choice(
        "lightWeights", offsetof(GrassField, lightWeights), kLightWeights,
        "how a slice's images are weighted by the light: by its cosine, or interpolated by a form of equations 8-13"),
    choice("weightsAt", offsetof(GrassField, weightsAt), kWeightsAt, "where point lights' weights are computed"),
    choice("transparency", offsetof(GrassField, transparency), kTransparencies,
           "how part-covered pixels are drawn (figure 21)"),
    choice("filtering", offsetof(GrassField, filtering), kFilterings, "how the horizontal slice is filtered"),
    real("sharpness", offsetof(GrassField, sharpness), "levels", {-2, 8, 0, 4},
         "how much finer than a pixel slices are sampled: 0 smooth, more as grainy as blades"),
    whole("shadowMask", offsetof(GrassField, shadowMask), "texels", {0, 1024, 0, 256},
          "width of the mask by which blades shade blades; 0: they do not"),
    number(FieldType::Bool, "groundShadows", offsetof(GrassField, groundShadows), "", {}, "blades shade the ground"),
    real("maxDistance", offsetof(GrassField, maxDistance), "m", {0.1, 1e6, 5, 200},
         "tessellated: from here no blade is drawn"),
    choice("levelBy", offsetof(GrassField, levelBy), kLevelsBy,
           "tessellated: what says how fine a blade is, its distance or its length on screen"),
    real("pixelsPerQuad", offsetof(GrassField, pixelsPerQuad), "pixels", {0.5, 1000, 2, 40},
         "tessellated by pixels: length of a blade's quad on screen"),
    real("thinning", offsetof(GrassField, thinning), "", kShare,
         "tessellated: share of the blades that is missing at maxDistance"),
    flag("widening", offsetof(GrassField, widening),
         "tessellated: blades that are left are wider, so as to cover as much"),
    real("lowerFrom", offsetof(GrassField, lowerFrom), "", kShare,
         "tessellated: share of maxDistance from which blades get lower; 1: they do not"),
    choice("beyond", offsetof(GrassField, beyond), kBeyonds,
           "tessellated: what grows beyond maxDistance: the horizontal slice, or nothing, as published"),
    choice("tessellation", offsetof(GrassField, tessellation), kTessellations,
           "tessellated: by the GPU's stages, or by strips from a compute pass; auto: what is faster here"),
    choice("culling", offsetof(GrassField, culling), kCullings,
           "who chooses the cells of which blades are drawn: the CPU, or the GPU; auto: what is faster here. The "
           "picture is the same"),
    real("fade", offsetof(GrassField, fade), "", kShare, "half the width of the opacity ramp over density; 0: a step"),
    choice("farBlur", offsetof(GrassField, farBlur), kFarBlurs,
           "blurs what is far, against sparkling: with equal weights, or a bell's"),
    real("farBlurDistance", offsetof(GrassField, farBlurDistance), "m", {0.1, 1e6, 10, 300},
         "distance at which that blur is full"),
    real("farDarkening", offsetof(GrassField, farDarkening), "", kShare,
         "share of their light that far blades lose, which shows depth; 0: none"),
    real("farDarkeningDistance", offsetof(GrassField, farDarkeningDistance), "m", {0.1, 1e6, 10, 300},
         "distance at which they have lost it"),
    map("orientation", offsetof(GrassField, orientation), &kOrientation,
        "direction x, z about 0.5 in which blades lean"),
    map("vegetation", offsetof(GrassField, vegetation), &kVegetation, "colour and opacity over the blades' own colour"),
    map("ambientOcclusion", offsetof(GrassField, ambientOcclusion), &kOcclusion,
        "share of the sky that the ground sees"),
    map("forces", offsetof(GrassField, forces), &kPaintedForces,
        "what presses on the blades: pushed towards x, z about 0.5, pressed down by B; all times A"),
    kBladeHeight,
    kOrientationTiling,
    kVegetationTiling,
    kOcclusionTiling,
    kForcesTiling,
    kBladeHeightTiling,
    choice("population", offsetof(GrassField, population), kPopulations,
           "patch: one cell's blades repeated in every cell; unique: every blade its own, for small scenes"),
};
// Which tiers a field is drawn with.
FeatureSet tierFeatures(const GrassField& g) {
    switch (static_cast<Technique>(g.technique)) {
        case Technique::Geometry:
            return featureSet(Feature::GrassGeometry);
        case Technique::Slices:
            return featureSet(Feature::GrassSlices, Feature::GrassFar);
        case Technique::Flat:
            return featureSet(Feature::GrassFar);
        case Technique::Tessellated:
            return g.beyond == static_cast<int>(Beyond::Slice)
                       ? featureSet(Feature::GrassTessellated, Feature::GrassFar)
                       : featureSet(Feature::GrassTessellated);
        default:
            break;
    }
    FeatureSet s;
    if (g.maxGeom > 0) s |= featureSet(Feature::GrassGeometry);
    if (std::isinf(g.minGeom)) return s;
    if (g.maxBTF > g.minGeom) s |= featureSet(Feature::GrassSlices);
    return s | featureSet(Feature::GrassFar);
}
FeatureSet grassFeatures(const void* component) {
    const auto& g = *static_cast<const GrassField*>(component);
    bool grows = false, density = false, clumps = false, translucency = false, gloss = false;
    for (const Species& s : g.species) {
        if (!(s.bladesPerM2 > 0)) continue;
        grows = true;
        density |= s.density.present();
        clumps |= s.clumpSize > 0 && s.clumpStrength > 0;
        translucency |= s.translucency > 0;
        gloss |= s.gloss > 0;
    }
    if (!grows) return {};
    FeatureSet s = featureSet(Feature::Grass) | tierFeatures(g);
    if (density) s |= featureSet(Feature::GrassDensity);
    if (g.transparency != static_cast<int>(Transparency::Coverage)) s |= featureSet(Feature::GrassBlended);
    if (clumps) s |= featureSet(Feature::GrassClumps);
    const bool stands = has(s, Feature::GrassGeometry) || has(s, Feature::GrassSlices);
    if ((stands || has(s, Feature::GrassTessellated)) && g.shadowMask > 0) s |= featureSet(Feature::BladeShadows);
    if (stands && g.groundShadows) s |= featureSet(Feature::GroundShadows);
    if (translucency) s |= featureSet(Feature::Translucency);
    if (gloss) s |= featureSet(Feature::Gloss);
    if (g.orientation.present()) s |= featureSet(Feature::GrassOrientation);
    if (g.bladeHeight.present()) s |= featureSet(Feature::GrassHeights);
    const bool blades = has(s, Feature::GrassGeometry) || has(s, Feature::GrassTessellated);
    if (blades && g.population == static_cast<int>(Population::Unique)) s |= featureSet(Feature::GrassUnique);
    if (g.vegetation.present()) s |= featureSet(Feature::GrassVegetation);
    if (g.farBlur != static_cast<int>(FarBlur::None)) s |= featureSet(Feature::FarBlur);
    if (g.farDarkening > 0) s |= featureSet(Feature::FarDarkening);
    if (g.forces.present()) s |= featureSet(Feature::ForceMap);
    if (g.ambientOcclusion.present()) s |= featureSet(Feature::GrassOcclusion);
    return s;
}

// --- Light, Sky, Fog ---------------------------------------------------------------------------------------------
constexpr FieldRow kLightFields[] = {
    choice("type", &Light::type, offsetof(Light, type), kLightTypes,
           "directional: from so far that all of it comes from one side, the first of them the sun; point: a lamp"),
    real("azimuthDeg", offsetof(Light, azimuthDeg), "deg", {-360, 360, 0, 360},
         "where it stands, clockwise from north (-z); where on its circle a point light starts"),
    real("elevationDeg", offsetof(Light, elevationDeg), "deg", {-90, 90, 0, 90},
         "height of a directional light over the horizon"),
    real("intensity", offsetof(Light, intensity), "", {0, kBrightest, 0, 4}, "factor of its light; 0: it is off"),
    color("color", offsetof(Light, color), {0, kBrightest, 0, 1}, "factor of its colour"),
    real("attenuation", offsetof(Light, attenuation), "1/m2", {0, 1e6, 0, 4},
         "how fast a point light fades: intensity / (1 + attenuation * distance^2)"),
    number(FieldType::Bool, "castShadows", offsetof(Light, castShadows), "", {},
           "what stands in its light throws a shadow"),
    real("orbitRadius", offsetof(Light, orbitRadius), "m", {0, 1e6, 0, 20},
         "radius of a point light's circle around its place"),
    real("orbitSeconds", offsetof(Light, orbitSeconds), "s", {0, 1e9, 0, 120},
         "time of a turn of a point light's circle or of a directional light's azimuth; 0: it stands still"),
};
// As if it were the only light; which directional light is the sun, the scene decides (see entityFeatures).
FeatureSet lightFeatures(const void* component) {
    const auto& l = *static_cast<const Light*>(component);
    if (!shines(l)) return {};
    const FeatureSet s = featureSet(l.type == LightType::Point ? Feature::Lamps : Feature::Sun);
    return l.castShadows ? s | featureSet(Feature::CastingLights) : s;
}

constexpr FieldRow kSkyFields[] = {
    choice("model", &Sky::model, offsetof(Sky, model), kSkyModels,
           "clear: by sun and turbidity; uniform: equally bright everywhere, as under clouds"),
    real("turbidity", offsetof(Sky, turbidity), "", {1.7, 12, 2, 8}, "how hazy the air is: 2 clear, 8 thick haze"),
    real("intensity", offsetof(Sky, intensity), "", {0, kBrightest, 0, 4}, "factor of the sky's light; 0: no sky"),
};
FeatureSet skyFeatures(const void* component) {
    return static_cast<const Sky*>(component)->intensity > 0 ? featureSet(Feature::Sky) : FeatureSet{};
}

constexpr MapRow kGusts{.least = "0 calm", .most = "1 gust"};
constexpr FieldRow kWindFields[] = {
    choice("model", &Wind::model, offsetof(Wind, model), kWindModels,
           "waves: equation 9 of Jahrmann and Wimmer 2013; noise: gusts from a picture that moves over the field"),
    real("strength", offsetof(Wind, strength), "", {0, kStrongestWind, 0, 1},
         "how far a full gust leans a blade, metres a metre, at a stiffness of 1; 0: a calm"),
    real("azimuthDeg", offsetof(Wind, azimuthDeg), "deg", {-360, 360, 0, 360},
         "where it blows to, clockwise from north (-z)"),
    real("speed", offsetof(Wind, speed), "m/s", {0, 100, 0, 15}, "how fast gusts and waves travel"),
    real("gustSize", offsetof(Wind, gustSize), "m", {0.1, 10000, 2, 30}, "length of a gust along the wind"),
    real("turbulence", offsetof(Wind, turbulence), "", kShare, "share of small gusts, and how much blades quiver"),
    real("quiverHz", offsetof(Wind, quiverHz), "Hz", {0, 50, 1, 6}, "how fast blades quiver"),
    map("gusts", offsetof(Wind, gusts), &kGusts,
        "your own picture of gusts: it covers 8 of them and repeats; none: made by the program"),
    real("c1", offsetof(Wind, c1), "1/m", {0, 10, 0, 1},
         "of waves: how close they follow each other; in steps of 0.05"),
    real("c2", offsetof(Wind, c2), "1/m", {0, 10, 0, 0.5}, "of waves: how they bend across the wind"),
    real("c3", offsetof(Wind, c3), "1/m", {0, 10, 0, 1},
         "of waves: the second ones, which overlap the first; in steps of 0.05"),
    real("epsilon", offsetof(Wind, epsilon), "", {0.1, 10, 0.1, 2},
         "of waves: how sharply they bend; below 0.1 neighbours would move without relation"),
};
FeatureSet windFeatures(const void* component) {
    const auto& w = *static_cast<const Wind*>(component);
    if (!(w.strength > 0)) return {};
    return w.model == WindModel::Noise ? featureSet(Feature::Wind, Feature::Gusts) : featureSet(Feature::Wind);
}

constexpr FieldRow kForceFields[] = {
    choice("shape", &ForceSource::shape, offsetof(ForceSource, shape), kForceShapes,
           "foot and wheel are long, an object is round; a wheel's track is one piece, a foot's is of prints; outline: "
           "as the entity's StaticMesh stands on the ground. A foot without a Transform is the walker's, in play"),
    real("radius", offsetof(ForceSource, radius), "m", {0, 1000, 0.05, 5},
         "how far from its middle it presses blades down, 0: nowhere; an outline presses inside, and pushes out to "
         "radius * (reach - 1) around"),
    real("length", offsetof(ForceSource, length), "m", {0, 1000, 0.1, 2},
         "of a foot, or of a wheel's tread on the ground"),
    real("headingDeg", offsetof(ForceSource, headingDeg), "deg", {-360, 360, 0, 360},
         "where a foot or wheel points, clockwise from north (-z)"),
    real("reach", offsetof(ForceSource, reach), "radii", {1, 20, 1, 4}, "how far around it blades are pushed aside"),
    real("strength", offsetof(ForceSource, strength), "", kShare, "share of its force; 0: none"),
    seconds("recovery", offsetof(ForceSource, recovery), {0, 1e9, 0, 120},
            "time in which its tracks recover; inf: they stay"),
};
FeatureSet forceFeatures(const void* component) {
    const auto& f = *static_cast<const ForceSource*>(component);
    if (!(f.strength > 0 && f.radius > 0)) return {};
    return f.shape == ForceShape::Outline ? featureSet(Feature::Forces, Feature::ForceOutlines)
                                          : featureSet(Feature::Forces);
}

constexpr FieldRow kFogFields[] = {
    distance("visibility", offsetof(Fog, visibility), {0.1, 1e8, 50, 20000},
             "distance at which contrast has fallen to 2%; inf: no haze"),
};
FeatureSet fogFeatures(const void* component) {
    return static_cast<const Fog*>(component)->visibility < kInf ? featureSet(Feature::Fog) : FeatureSet{};
}

// --- Water, Flowers ----------------------------------------------------------------------------------------------
constexpr FieldRow kWaterFields[] = {
    real("level", offsetof(Water, level), "m", {-1e5, 1e5, -10, 50},
         "height of the surface, as the terrain's heights count; it stands where the ground is lower"),
    real("clarity", offsetof(Water, clarity), "m", {0.01, 10000, 0.2, 20},
         "distance over which what lies under water loses all but 2% of its contrast"),
    color("color", offsetof(Water, color), kReflectance,
          "of deep water: share of the light from above that it sends back"),
    real("ripples", offsetof(Water, ripples), "", {0, 2, 0, 1},
         "slopes of ripples as a share of the open sea's in this wind; without wind it lies still"),
    real("rippleSize", offsetof(Water, rippleSize), "m", {0.05, 1000, 0.2, 10}, "length of the longest ripples"),
    real("reflection", offsetof(Water, reflection), "", kShare,
         "pixels of the mirrored view, as a share of the picture's, each way; 0: it mirrors the sky alone"),
};
FeatureSet waterFeatures(const void* component) {
    return static_cast<const Water*>(component)->reflection > 0 ? featureSet(Feature::Water, Feature::WaterReflection)
                                                                : featureSet(Feature::Water);
}

constexpr FieldRow kFlowerTiling =
    tiling("densityTiling", offsetof(Flowers, densityTiling), "repeats of the density map over the terrain's mapSize");
constexpr MapRow kFlowerDensity{.role = MapRole::Density, .texelsPerMetre = 8, .tiling = &kFlowerTiling};
constexpr FieldRow kFlowersFields[] = {
    map("density", offsetof(Flowers, density), &kFlowerDensity,
        "where they stand: share of flowersPerM2; none: everywhere"),
    kFlowerTiling,
    real("flowersPerM2", offsetof(Flowers, flowersPerM2), "flowers/m2", {0, 1000, 0, 50},
         "flowers on a square metre at density 1; 0: none"),
    real("height", offsetof(Flowers, height), "m", {0, 20, 0.05, 1}, "from the ground to the head"),
    real("heightVariation", offsetof(Flowers, heightVariation), "", kShare,
         "how much heights differ, as a share, both ways"),
    real("headSize", offsetof(Flowers, headSize), "m", {0, 5, 0.005, 0.2}, "of a head, across; 0: none"),
    color("color", offsetof(Flowers, color), {0, 1, 0, 1},
          "reflectance of petals: of each flower's somewhere between this"),
    color("secondColor", offsetof(Flowers, secondColor), {0, 1, 0, 1}, "reflectance of petals: and this"),
    color("centerColor", offsetof(Flowers, centerColor), {0, 1, 0, 1}, "reflectance of the middle of a head"),
    color("stemColor", offsetof(Flowers, stemColor), {0, 1, 0, 1}, "reflectance of stem and leaves"),
    imageFile("texture", offsetof(Flowers, texture),
              "image with alpha: its top square the head, what is below it the stem; none: made by the program"),
    real("maxDistance", offsetof(Flowers, maxDistance), "m", {0.1, 10000, 5, 200}, "from here none is drawn"),
    number(FieldType::Int, "seed", offsetof(Flowers, seed), "", {0, 2147483647, 0, 1000},
           "another number: other flowers"),
};
FeatureSet flowersFeatures(const void* component) {
    const auto& f = *static_cast<const Flowers*>(component);
    if (!(f.flowersPerM2 > 0) || !(f.headSize > 0)) return {};
    return f.density.present() ? featureSet(Feature::Flowers, Feature::FlowerDensity) : featureSet(Feature::Flowers);
}

// --- StaticMesh --------------------------------------------------------------------------------------------------
constexpr FieldRow kStaticMeshFields[] = {
    meshFile("file", offsetof(StaticMesh, file), "object to show: .glb or .gltf in the project's folder"),
    number(FieldType::Vec3, "rotationDeg", offsetof(StaticMesh, rotationDeg), "deg", {-36000, 36000, -180, 180},
           "turn about x, then z, then y"),
    real("scale", offsetof(StaticMesh, scale), "", {0.001, 1000, 0.1, 10}, "factor of its size"),
    flag("onGround", offsetof(StaticMesh, onGround), "its Transform's height counts from the ground below it"),
    flag("castShadows", offsetof(StaticMesh, castShadows), "it shades the ground, the grass and other objects"),
};
FeatureSet staticMeshFeatures(const void* component) {
    const auto& m = *static_cast<const StaticMesh*>(component);
    if (m.file.empty()) return {};
    return m.castShadows ? featureSet(Feature::Objects, Feature::ObjectShadows) : featureSet(Feature::Objects);
}

// --- Rolling -----------------------------------------------------------------------------------------------------
constexpr FieldRow kRollingFields[] = {
    real("radius", offsetof(Rolling, radius), "m", {0.01, 100, 0.05, 2},
         "size of the ball around its place that rolls in a playtest"),
    real("friction", offsetof(Rolling, friction), "", {0, 10, 0, 0.5},
         "what stops it: it rests on slopes of less than about this"),
    real("push", offsetof(Rolling, push), "", kShare,
         "share of the walker's motion that it takes; 0: it stands like a wall"),
};
FeatureSet rollingFeatures(const void*) { return {}; }

// --- Camera ------------------------------------------------------------------------------------------------------
constexpr FieldRow kCameraFields[] = {
    number(FieldType::Vec3, "eye", offsetof(Camera, eye), "m", kPosition, "where the camera stands"),
    number(FieldType::Vec3, "target", offsetof(Camera, target), "m", kPosition, "the point it looks at"),
    real("fovDeg", offsetof(Camera, fovDeg), "deg", {1, 170, 20, 100}, "vertical field of view"),
    real("exposure", offsetof(Camera, exposure), "stops", {-20, 20, -4, 4}, "brightens (+) or darkens (-) the picture"),
};
FeatureSet cameraFeatures(const void*) { return {}; }

// --- CameraPath --------------------------------------------------------------------------------------------------
constexpr FieldRow kCameraKeyFields[] = {
    number(FieldType::String, "name", offsetof(CameraKey, name), "", {}, "what this key is called"),
    real("seconds", offsetof(CameraKey, seconds), "s", {0, 86400, 0, 60},
         "when the camera is here, from the path's beginning"),
    number(FieldType::Vec3, "eye", offsetof(CameraKey, eye), "m", kPosition, "where the camera stands"),
    number(FieldType::Vec3, "target", offsetof(CameraKey, target), "m", kPosition, "the point it looks at"),
    real("fovDeg", offsetof(CameraKey, fovDeg), "deg", {1, 170, 20, 100}, "vertical field of view"),
};
constexpr ListRow kCameraKeyList = listRow<CameraKey>(kCameraKeyFields);
constexpr FieldRow cameraKeysField() {
    FieldRow row = number(FieldType::List, "keys", offsetof(CameraPath, keys), "", {}, "where the camera is when");
    row.list = &kCameraKeyList;
    return row;
}
constexpr FieldRow kCameraPathFields[] = {
    cameraKeysField(),
    real("exposure", offsetof(CameraPath, exposure), "stops", {-20, 20, -4, 4},
         "brightens (+) or darkens (-) the pictures"),
};
FeatureSet cameraPathFeatures(const void*) { return {}; }

}  // namespace

std::span<const ComponentRow> sharedComponentRows() {
    static constexpr ComponentRow kRows[] = {
        componentRow<Transform>("Transform", "Where the entity and what stands on it is moved to.", kTransformFields,
                                transformFeatures),
        componentRow<Terrain>("Terrain", "The ground: heights and colour.", kTerrainFields, terrainFeatures),
        componentRow<GrassField>("GrassField", "Grass over the whole terrain.", kGrassFieldFields, grassFeatures),
        componentRow<Light>("Light", "The sun, or a lamp.", kLightFields, lightFeatures),
        componentRow<Sky>("Sky", "The sky, and the light it gives.", kSkyFields, skyFeatures),
        componentRow<Wind>("Wind", "Wind: what grows leans with it.", kWindFields, windFeatures),
        componentRow<ForceSource>("ForceSource", "Presses the grass down where it stands; what moves leaves tracks.",
                                  kForceFields, forceFeatures),
        componentRow<Fog>("Fog", "Haze: what is far fades into the horizon.", kFogFields, fogFeatures),
        componentRow<Water>("Water", "Water up to a level: it stands where the ground is lower.", kWaterFields,
                            waterFeatures),
        componentRow<Flowers>("Flowers", "Flowers over the terrain.", kFlowersFields, flowersFeatures),
        componentRow<StaticMesh>("StaticMesh", "An object from a glTF file.", kStaticMeshFields, staticMeshFeatures),
        componentRow<Rolling>("Rolling", "It rolls in a playtest.", kRollingFields, rollingFeatures),
        componentRow<Camera>("Camera", "A place to take pictures from.", kCameraFields, cameraFeatures),
        componentRow<CameraPath>("CameraPath", "A way of the camera, for films.", kCameraPathFields,
                                 cameraPathFeatures),
    };
    return kRows;
}

}  // namespace sward
