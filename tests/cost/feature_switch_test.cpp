// What turns features off: every row, over the sample projects and scenes that have the rest.
#include "cost/feature_switch.h"

#include <set>

#include "cost/effect_probe.h"
#include "everything.h"
#include "project/project_files.h"
#include "scene/antialias.h"
#include "scene/ground_path.h"
#include "scene/map_layers.h"
#include "techniques.h"
#include "world/drawn_project.h"

namespace sward::test {
namespace {

FeatureSet drawnFeatures(const Project& p) {
    DrawnProject drawn;
    return sceneFeatures(drawn.of(p, tables().components).registry, tables());
}
std::vector<SwitchStep> stepsOf(const Project& p, Feature f) {
    DrawnProject drawn;
    return stepsWithout(p, drawn.of(p, tables().components), tables(), f);
}
std::vector<std::string> toldOf(const std::vector<SwitchStep>& steps) {
    std::vector<std::string> out;
    for (const SwitchStep& s : steps) out.push_back(s.told());
    return out;
}

// What `everything` has not.
Project theRest() {
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    f.grows.bladeHeight = field(filled({16, 16, 1, PixelType::U8}, 0.5f));
    f.grows.population = Population::Unique;
    f.drawing.transparency = Transparency::Both;
    setAntialias(p, Antialiasing::Temporal);
    return p;
}
// A density and a ground whose maps come from a path and from a layer as well.
Project pathsAndLayers() {
    Project p = lawn();
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density =
        field(filled({64, 64, 1, PixelType::U16}, 0.7f));
    GroundPath path;
    path.points = {{"a", {2, 2}}, {"b", {18, 18}}};
    path.tint = 0.5f;
    put(p, "path", path);
    MapLayer layer;
    layer.name = "rule", layer.map = "GrassField.species[lawn].density", layer.operation = LayerOperation::Minimum;
    layer.opacity = 0.5f;
    put(p, "grass", MapLayers{{layer}});
    put<Flowers>(p, "flowers", {.density = field(filled({16, 16, 1, PixelType::U16}, 0.5f))});
    return p;
}

std::vector<Project> scenes() {
    std::vector<Project> out;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(SWARD_SOURCE_DIR) / "projects")) {
        if (!std::filesystem::exists(entry.path() / "project.json")) continue;  // presets, templates
        auto project = loadProject(entry.path(), tables().components);
        EXPECT_TRUE(project) << project.error().text();
        if (project) out.push_back(std::move(*project));
    }
    EXPECT_GE(out.size(), 8u) << "the sample projects are made by the target projects";
    out.push_back(everything());
    out.push_back(theRest());
    out.push_back(pathsAndLayers());
    return out;
}

TEST(FeatureSwitch, EveryRowTurnsItsFeatureOffWhereverASceneHasIt) {
    std::set<Feature> met;
    for (const Project& p : scenes())
        for (const Feature f : effectsOf(p, tables())) {
            met.insert(f);
            const std::vector<SwitchStep> steps = stepsOf(p, f);
            EXPECT_FALSE(steps.empty()) << p.name << ": " << featureName(f);
            Project without = snapshot(p, tables().components);
            const Status set = takeSteps(without, tables(), steps);
            ASSERT_TRUE(set) << set.error().text();
            EXPECT_FALSE(has(drawnFeatures(without), f)) << p.name << ": " << featureName(f);
            EXPECT_TRUE(stepsOf(without, f).empty()) << "nothing is left to set";
            EXPECT_TRUE(has(drawnFeatures(p), f)) << "the project itself stays as it was";
        }
    for (const FeatureRow& row : featureRows())
        EXPECT_EQ(met.count(row.feature), canBeLeftOut(row.feature)) << row.name << ": no scene here has it";
}

TEST(FeatureSwitch, WhatASceneIsMadeOfHasNoRow) {
    std::set<std::string> kept;
    for (const FeatureRow& row : featureRows())
        if (!canBeLeftOut(row.feature)) kept.insert(row.name);
    EXPECT_EQ(kept, (std::set<std::string>{"terrain", "terrain-heights", "grass", "grass-geometry", "grass-slices",
                                           "grass-far", "grass-tessellated", "grass-raytraced", "grass-mesh-geometry",
                                           "forest-meshes", "forest-volumes"}));
}

TEST(FeatureSwitch, ADroppedMapTakesItsLayersAlongAndPathsNoLongerActOnIt) {
    const Project p = pathsAndLayers();
    EXPECT_EQ(toldOf(stepsOf(p, Feature::GrassDensity)),
              (std::vector<std::string>{"grass.GrassField.species[lawn].density = none",
                                        "grass.MapLayers.layers[rule].muted = true", "path.GroundPath.grass = 0"}));
    EXPECT_EQ(toldOf(stepsOf(p, Feature::TerrainMap)), std::vector<std::string>{"path.GroundPath.tint = 0"});
}

TEST(FeatureSwitch, SettingsThatAreAbsentComeAsComponents) {
    Project p = lawn();
    ASSERT_EQ(p.registry.get<GrassDrawing>(findEntity(p, "grass")), nullptr);
    const std::vector<SwitchStep> steps = stepsOf(p, Feature::BladeShadows);
    EXPECT_EQ(toldOf(steps), std::vector<std::string>{"grass.GrassDrawing.shadowMask = 0"});
    ASSERT_TRUE(takeSteps(p, tables(), steps));
    EXPECT_EQ(p.registry.get<GrassDrawing>(findEntity(p, "grass"))->shadowMask, 0);
}

TEST(FeatureSwitch, OneLampGoesAndTheSunStays) {
    Project p = lawn();
    put<Light>(p, "lamp", {.type = LightType::Point});
    put(p, "lamp", Transform{{5, 1, 5}});
    EXPECT_EQ(toldOf(stepsOf(p, Feature::Lamps)), std::vector<std::string>{"lamp.Light.intensity = 0"});
    EXPECT_EQ(toldOf(stepsOf(p, Feature::Sun)), std::vector<std::string>{"sun.Light.intensity = 0"});
    EXPECT_EQ(toldOf(stepsOf(everything(), Feature::Water)), std::vector<std::string>{"without lake.Water"});
    EXPECT_TRUE(stepsOf(p, Feature::Water).empty()) << "the scene has none";
    EXPECT_TRUE(stepsOf(p, Feature::Grass).empty()) << "it cannot be left out";
}

}  // namespace
}  // namespace sward::test
