// What a scene asks for, from its components.
#include <gtest/gtest.h>

#include <cctype>
#include <limits>
#include <set>
#include <string>

#include "fields.h"
#include "grass/grass_fields.h"
#include "scene/components.h"
#include "scene/project.h"
#include "techniques.h"
#include "tests/rows.h"

namespace sward {
namespace {

using namespace test;

TEST(SceneFeatures, EachComponentAsksForItsFeaturesAndTheirAbsenceForNone) {
    const auto featuresOf = [](const char* name, const void* value) {
        return findComponent(rows(), name)->features(value);
    };
    Terrain terrain;
    EXPECT_EQ(featuresOf("Terrain", &terrain), featureSet(Feature::Terrain));
    terrain.height.map = terrain.terrainMap.map = Map({2, 2, 1, PixelType::F32});
    EXPECT_EQ(featuresOf("Terrain", &terrain),
              featureSet(Feature::Terrain, Feature::TerrainHeights, Feature::TerrainMap));
    FlatField grass;
    const auto featuresOfField = [&] { return fieldFeatures(tables().techniques, grass.asField()); };
    const FeatureSet drawn =
        featureSet(Feature::Grass, Feature::GrassGeometry, Feature::GrassSlices, Feature::GrassFar);
    EXPECT_EQ(featuresOfField(), drawn | featureSet(Feature::GrassClumps, Feature::BladeShadows, Feature::GroundShadows,
                                                    Feature::GrassTraced));
    grass.shadowMask = 0;
    grass.groundShadows = false;
    grass.species[0].clumpSize = 0;
    EXPECT_EQ(featuresOfField(), drawn);
    grass.species[0].density.map = grass.orientation.map = grass.vegetation.map = grass.ambientOcclusion.map =
        Map({2, 2, 1, PixelType::U8});
    EXPECT_EQ(featuresOfField(), drawn | featureSet(Feature::GrassDensity, Feature::GrassOrientation,
                                                    Feature::GrassVegetation, Feature::GrassOcclusion));
    grass.species[0].translucency = grass.species[0].gloss = 1;
    EXPECT_TRUE((featuresOfField() & featureSet(Feature::Translucency, Feature::Gloss)).count() == 2);
    grass.technique = nameOf(Technique::Flat);
    grass.shadowMask = 64;
    EXPECT_TRUE(has(featuresOfField(), Feature::BladeShadows)) << "the flat tier is as bright as blades in shadow";
    EXPECT_TRUE(has(featuresOfField(), Feature::GrassTraced));
    grass.drawing.bakeLight = BakeLight::Local;
    EXPECT_FALSE(has(featuresOfField(), Feature::GrassTraced));
    grass.species[0].bladesPerM2 = 0;
    EXPECT_TRUE(featuresOfField().none()) << "nothing grows";
    Light light;
    EXPECT_EQ(featuresOf("Light", &light), featureSet(Feature::Sun, Feature::CastingLights));
    light.castShadows = false;
    EXPECT_EQ(featuresOf("Light", &light), featureSet(Feature::Sun));
    light.type = LightType::Point;
    EXPECT_EQ(featuresOf("Light", &light), featureSet(Feature::Lamps));
    light.intensity = 0;
    EXPECT_TRUE(featuresOf("Light", &light).none());
    Sky sky;
    EXPECT_EQ(featuresOf("Sky", &sky), featureSet(Feature::Sky));
    sky.intensity = 0;
    EXPECT_TRUE(featuresOf("Sky", &sky).none());
    Fog fog;
    EXPECT_EQ(featuresOf("Fog", &fog), featureSet(Feature::Fog));
    const Rolling rolling;
    EXPECT_TRUE(featuresOf("Rolling", &rolling).none()) << "it draws nothing by itself";
    fog.visibility = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(featuresOf("Fog", &fog).none());
}

TEST(SceneFeatures, AddingAndRemovingAComponentLeavesTheFeaturesAsBefore) {
    Project p;
    const Entity e = *addEntity(p, "e");
    for (const ComponentRow& row : rows()) {
        const FeatureSet before = sceneFeatures(p.registry, tables());
        row.assign(p.registry, e, nullptr);
        const FeatureSet onEntity =
            row.featuresOnEntity ? row.featuresOnEntity(p.registry, e, tables(), false) : FeatureSet();
        const bool nowhere = std::string(row.name) == "ForceSource";  // without a Transform it presses nothing
        FeatureSet asked = nowhere ? FeatureSet() : row.features(row.defaults()) | onEntity;
        if (!has(asked, Feature::Sun)) asked &= ~featureSet(Feature::ObjectShadows, Feature::TerrainShadows);
        asked &= ~featureSet(Feature::LampShadows, Feature::LampHills);  // one light is the sun, or one lamp's alone
        EXPECT_EQ(sceneFeatures(p.registry, tables()), asked) << row.name;
        row.remove(p.registry, e);
        EXPECT_EQ(sceneFeatures(p.registry, tables()), before) << row.name;
        EXPECT_EQ(row.get(p.registry, e), nullptr);
    }
}

TEST(SceneFeatures, AForceIsThereWhereItsSourceStandsOrLeftTracks) {
    Project p;
    const Entity e = *addEntity(p, "e");
    ForceSource& s = *p.registry.add<ForceSource>(e);
    s.shape = ForceShape::Outline;
    EXPECT_TRUE(sceneFeatures(p.registry, tables()).none());
    EXPECT_TRUE(entitiesWith(p.registry, tables(), Feature::Forces).empty());
    s.tracks.push_back({{1, 1}, {2, 2}, 0});
    EXPECT_TRUE(has(sceneFeatures(p.registry, tables()), Feature::Forces));
    s.tracks.clear();
    p.registry.add<Transform>(e);
    EXPECT_EQ(sceneFeatures(p.registry, tables()), featureSet(Feature::Forces, Feature::ForceOutlines));
}

TEST(SceneFeatures, KnowWhichEntitiesAskForThem) {
    Project p;
    for (const char* name : {"b", "a", "c"}) p.registry.add<Light>(*addEntity(p, name));
    p.registry.get<Light>(findEntity(p, "c"))->intensity = 0;
    EXPECT_EQ(entitiesWith(p.registry, tables(), Feature::CastingLights), (std::vector<std::string>{"a", "b"}));
    EXPECT_TRUE(entitiesWith(p.registry, tables(), Feature::Fog).empty());
}

TEST(SceneFeatures, HaveNamesForPeopleAndForShaders) {
    std::set<std::string> names;
    for (size_t i = 0; i < size_t(Feature::Count); ++i) {
        std::string name = featureName(Feature(i));
        EXPECT_TRUE(names.insert(name).second);
        for (char& c : name) c = c == '-' ? '_' : char(std::toupper(c));
        EXPECT_EQ(name, featureConstant(Feature(i)));
    }
}

}  // namespace
}  // namespace sward
