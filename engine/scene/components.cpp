// The field tables of the shared components. Index: field helpers · Transform · Terrain · GrassField · Light, Sky, Fog
// · Water · Flowers · StaticMesh · Rolling · Camera · CameraPath · rows · features of a scene.
#include "scene/components.h"

#include <cmath>

#include "scene/field_rows.h"

namespace sward {
namespace {

// --- Transform ---------------------------------------------------------------------------------------------------
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
constexpr MapRow kHeights{.kind = MapKind::Heights,
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
    map("terrainMap", offsetof(Terrain, terrainMap), &kTerrainMap,
        "colour and opacity blended over the ground's image"),
    kHeightTiling,
    kTerrainMapTiling,
    real("mapSize", offsetof(Terrain, mapSize), "m", {0, 1e6, 0, 1000},
         "length over which every map's tiling counts its repeats; 0: the whole terrain"),
    imageFile("groundTexture", offsetof(Terrain, groundTexture),
              "image repeated over the ground; none: soil made by the program"),
    real("tileSize", offsetof(Terrain, tileSize), "m", {0.01, 1e4, 0.1, 20},
         "length after which the ground's image repeats"),
    color("groundColor", offsetof(Terrain, groundColor), {0, 4, 0, 1},
          "mean reflectance of the soil, or factor of the texture"),
    flag("castShadows", offsetof(Terrain, castShadows), "hills shade what lies behind them"),
    choice("beyond", &Terrain::beyond, offsetof(Terrain, beyond), kLandsBeyond,
           "what is seen beyond the terrain; none: a plain in the haze; extend: the ground, as at its edges; fade: the "
           "ground, which farther out comes to the terrain's mean. Maps that repeat go on repeating"),
};
FeatureSet terrainFeatures(const void* component) {
    const auto& t = *static_cast<const Terrain*>(component);
    FeatureSet s = featureSet(Feature::Terrain);
    if (t.height.present()) s |= featureSet(Feature::TerrainHeights);
    if (t.terrainMap.present()) s |= featureSet(Feature::TerrainMap);
    if (t.beyond != LandBeyond::None) s |= featureSet(Feature::TerrainBeyond);
    if (t.height.present() && t.castShadows) s |= featureSet(Feature::TerrainShadows, Feature::LampHills);
    return s;
}

// --- Light, Sky, Fog ---------------------------------------------------------------------------------------------
template <LightType T>
bool isLight(const void* light) {
    return static_cast<const Light*>(light)->type == T;
}
constexpr FieldRow kLightFields[] = {
    choice("type", &Light::type, offsetof(Light, type), kLightTypes,
           "directional: from so far that all of it comes from one side, the first of them the sun; point: a lamp"),
    real("azimuthDeg", offsetof(Light, azimuthDeg), "deg", {-360, 360, 0, 360},
         "where it stands, clockwise from north (-z); where on its circle a point light starts"),
    where(isLight<LightType::Directional>, real("elevationDeg", offsetof(Light, elevationDeg), "deg", {-90, 90, 0, 90},
                                                "height of a directional light over the horizon")),
    real("intensity", offsetof(Light, intensity), "", {0, kBrightest, 0, 4}, "factor of its light; 0: it is off"),
    color("color", offsetof(Light, color), {0, kBrightest, 0, 1}, "factor of its colour"),
    where(isLight<LightType::Point>, real("attenuation", offsetof(Light, attenuation), "1/m2", {0, 1e6, 0, 4},
                                          "how fast a point light fades: intensity / (1 + attenuation * distance^2)")),
    number(FieldType::Bool, "castShadows", offsetof(Light, castShadows), "", {},
           "what stands in its light throws a shadow"),
    where(isLight<LightType::Point>, real("orbitRadius", offsetof(Light, orbitRadius), "m", {0, 1e6, 0, 20},
                                          "radius of a point light's circle around its place")),
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
           "clear: by sun and turbidity (Preetham 1999); uniform: equally bright everywhere, as under clouds; "
           "atmosphere: sky, "
           "sun and haze by the light that air scatters (Hillaire 2020), into dusk"),
    real("turbidity", offsetof(Sky, turbidity), "", {1, 12, 1, 8},
         "how hazy the air is: 1 as on a mountain (atmosphere alone), 2 clear, 8 thick haze"),
    real("intensity", offsetof(Sky, intensity), "", {0, kBrightest, 0, 4}, "factor of the sky's light; 0: no sky"),
};
FeatureSet skyFeatures(const void* component) {
    const auto& s = *static_cast<const Sky*>(component);
    if (!(s.intensity > 0)) return {};
    return s.model == SkyModel::Atmosphere ? featureSet(Feature::Sky, Feature::Atmosphere) : featureSet(Feature::Sky);
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
    titled("Wave spacing", real("c1", offsetof(Wind, c1), "1/m", {0, 10, 0, 1},
                                "of waves: how close they follow each other; in steps of 0.05")),
    titled("Wave bend",
           real("c2", offsetof(Wind, c2), "1/m", {0, 10, 0, 0.5}, "of waves: how they bend across the wind")),
    titled("Second waves", real("c3", offsetof(Wind, c3), "1/m", {0, 10, 0, 1},
                                "of waves: the second ones, which overlap the first; in steps of 0.05")),
    titled("Wave sharpness", real("epsilon", offsetof(Wind, epsilon), "", {0.1, 10, 0.1, 2},
                                  "of waves: how sharply they bend; below 0.1 neighbours would move without relation")),
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

// Drawing says the same once it comes to it (world/forces.h).
void checkForce(const Registry& registry, Entity e, const std::string& path, std::vector<ComponentFault>& out) {
    const StaticMesh* mesh = registry.get<StaticMesh>(e);
    if (registry.get<ForceSource>(e)->shape != ForceShape::Outline || (mesh && !mesh->file.empty())) return;
    out.push_back({"shape", path + ".shape: " + kOutlineOfNothing, true});
}
constexpr ComponentRow forceRow() {
    ComponentRow row =
        componentRow<ForceSource>("ForceSource", "Presses the grass down where it stands; what moves leaves tracks.",
                                  kForceFields, forceFeatures);
    row.check = checkForce;
    return row;
}

constexpr FieldRow kFogFields[] = {
    distance("visibility", offsetof(Fog, visibility), {0.1, 1e8, 50, 20000},
             "distance at which contrast has fallen to 2%; inf: no haze"),
};
FeatureSet fogFeatures(const void* component) {
    return static_cast<const Fog*>(component)->visibility < INFINITY ? featureSet(Feature::Fog) : FeatureSet{};
}

// --- Water, Flowers ----------------------------------------------------------------------------------------------
constexpr FieldRow kWaterFields[] = {
    real("level", offsetof(Water, level), "m", {-1e5, 1e5, -10, 50},
         "height of the surface, as the terrain's heights count; it stands where the ground is lower"),
    real("radius", offsetof(Water, radius), "m", {0, 1e5, 0, 100},
         "a pond's: it stands only so far about its Transform; 0: over the whole terrain"),
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
    choice("bakeLight", &StaticMesh::bakeLight, offsetof(StaticMesh, bakeLight), kBakeLights,
           "light from all around: local: as on open level ground; traced: less where ground and objects hide the sky, "
           "and with what they throw back, traced once"),
};
FeatureSet staticMeshFeatures(const void* component) {
    const auto& m = *static_cast<const StaticMesh*>(component);
    if (m.file.empty()) return {};
    FeatureSet s = featureSet(Feature::Objects);
    if (m.bakeLight == BakeLight::Traced) s |= featureSet(Feature::ObjectLight);
    return m.castShadows ? s | featureSet(Feature::ObjectShadows, Feature::LampShadows) : s;
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
std::vector<std::string> repairCamera(void* component) {
    auto& c = *static_cast<Camera*>(component);
    if (c.eye != c.target) return {};
    c.target.z -= 1;
    return {"eye and target were the same point; target is now 1 m to the north"};
}
constexpr ComponentRow cameraRow() {
    ComponentRow row = componentRow<Camera>("Camera", "A place to take pictures from.", kCameraFields, cameraFeatures);
    row.repair = repairCamera;
    return row;
}

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
        componentRow<Hidden>("Hidden", "The editor does not show it; pictures do.", {},
                             [](const void*) { return FeatureSet{}; }),
        componentRow<Terrain>("Terrain", "The ground: heights and colour.", kTerrainFields, terrainFeatures),
        componentRow<Light>("Light", "The sun, or a lamp.", kLightFields, lightFeatures),
        componentRow<Sky>("Sky", "The sky, and the light it gives.", kSkyFields, skyFeatures),
        componentRow<Wind>("Wind", "Wind: what grows leans with it.", kWindFields, windFeatures),
        forceRow(),
        componentRow<Fog>("Fog", "Haze: what is far fades into the horizon.", kFogFields, fogFeatures),
        componentRow<Water>("Water",
                            "Water up to a level: it stands where the ground is lower, everywhere or about a place.",
                            kWaterFields, waterFeatures),
        componentRow<Flowers>("Flowers", "Flowers over the terrain.", kFlowersFields, flowersFeatures),
        componentRow<StaticMesh>("StaticMesh", "An object from a glTF file.", kStaticMeshFields, staticMeshFeatures),
        componentRow<Rolling>("Rolling", "It rolls in a playtest.", kRollingFields, rollingFeatures),
        cameraRow(),
        componentRow<CameraPath>("CameraPath", "A way of the camera, for films.", kCameraPathFields,
                                 cameraPathFeatures),
    };
    return kRows;
}

}  // namespace sward
