// Layers edited through the document: one undo step each, and nothing left behind.
#include "model/layer_edits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "maps/map_io.h"
#include "support.h"
#include "techniques.h"
#include "world/map_stacks.h"

namespace sward {
namespace {

using test::TempDir;
constexpr const char* kLawnDensity = "lawn.GrassField.species[lawn].density";

struct LayeredField {
    TempDir dir;
    Document doc{tables()};
    LayeredField() { EXPECT_TRUE(doc.create(dir / "p")); }
    std::vector<std::string> names() {
        std::vector<std::string> out;
        for (const LayerOf& l : layersOver(doc.project(), kLawnDensity)) out.push_back(l.layer->name);
        return out;
    }
    const MapLayer& layer(size_t i) { return *layersOver(doc.project(), kLawnDensity)[i].layer; }
    bool hasComponent() { return doc.project().registry.get<MapLayers>(findEntity(doc.project(), "lawn")); }
};
using Names = std::vector<std::string>;

TEST(LayerEdits, AddEachKindInOneStepWithoutChangingWhatIsPainted) {
    LayeredField f;
    const Map before =
        static_cast<const MapField*>(findMap(f.doc.project(), tables().components, kLawnDensity)->value)->map;
    for (const LayerKind kind : {LayerKind::Rule, LayerKind::Image, LayerKind::Painted})
        ASSERT_TRUE(addLayer(f.doc, kLawnDensity, kind));
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Rule));
    EXPECT_EQ(f.names(), (Names{"rule", "image", "painted", "rule 2"}));
    EXPECT_EQ(f.doc.stepsDone(), 4u);
    EXPECT_EQ(f.layer(0).map, "GrassField.species[lawn].density");
    EXPECT_EQ(f.layer(0).masks.size(), 1u);
    EXPECT_TRUE(f.layer(2).amounts.present());
    EXPECT_FALSE(f.layer(1).amounts.present());
    const Map after =
        static_cast<const MapField*>(findMap(f.doc.project(), tables().components, kLawnDensity)->value)->map;
    EXPECT_TRUE(after.sameTiles(before));
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(f.doc.undo());
    EXPECT_FALSE(f.hasComponent());
    EXPECT_FALSE(f.doc.dirty());
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(f.doc.redo());
    EXPECT_EQ(f.names(), (Names{"rule", "image", "painted", "rule 2"}));
}

TEST(LayerEdits, MoveAmongTheLayersOfTheirMap) {
    LayeredField f;
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Rule));
    ASSERT_TRUE(addLayer(f.doc, "lawn.GrassField.bladeHeight", LayerKind::Rule));
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Image));
    const std::string image = "lawn.MapLayers.layers[image]", rule = "lawn.MapLayers.layers[rule]";
    const size_t steps = f.doc.stepsDone();
    ASSERT_TRUE(moveLayer(f.doc, image, false));
    EXPECT_EQ(f.names(), (Names{"image", "rule"}));
    ASSERT_TRUE(moveLayer(f.doc, image, false)) << "nothing below it";
    EXPECT_EQ(f.doc.stepsDone(), steps + 1);
    ASSERT_TRUE(moveLayer(f.doc, image, true));
    EXPECT_EQ(f.names(), (Names{"rule", "image"}));
    EXPECT_EQ(layersOver(f.doc.project(), "lawn.GrassField.bladeHeight").size(), 1u);
    EXPECT_TRUE(f.doc.undo());
    EXPECT_EQ(f.names(), (Names{"image", "rule"}));
    EXPECT_FALSE(moveLayer(f.doc, "lawn.MapLayers.layers[none]", true));
    EXPECT_FALSE(f.doc.moveListElement(rule, 3));
}

TEST(LayerEdits, TheLastOneTakesTheComponentWithIt) {
    LayeredField f;
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Painted));
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Rule));
    ASSERT_TRUE(removeLayer(f.doc, "lawn.MapLayers.layers[painted]"));
    EXPECT_EQ(f.names(), Names{"rule"});
    ASSERT_TRUE(removeLayer(f.doc, "lawn.MapLayers.layers[rule]"));
    EXPECT_FALSE(f.hasComponent());
    EXPECT_FALSE(f.doc.dirty());
    EXPECT_TRUE(f.doc.undo());
    EXPECT_TRUE(f.doc.undo());
    EXPECT_TRUE(f.layer(0).amounts.present()) << "what was painted on it is back";
}

TEST(LayerEdits, AStrokeOnALayerLeavesTheMapBelowAlone) {
    LayeredField f;
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Painted));
    const std::string amounts = "lawn.MapLayers.layers[painted].amounts";
    EXPECT_EQ(stackedMap(f.doc.project(), amounts), kLawnDensity);
    EXPECT_EQ(stackedMap(f.doc.project(), kLawnDensity), kLawnDensity);
    BrushSettings b;
    b.mode = "subtract";
    b.map = amounts;
    b.radius = 3;
    b.strength = 1;
    ASSERT_TRUE(f.doc.beginStroke(b, 10, 10));
    f.doc.endStroke();
    f.doc.pumpStroke(0);
    EXPECT_LT(f.layer(0).amounts.map.mean(), 1);
    MapStacks stacks;
    const Project& shown = stacks.shown(f.doc.project(), tables().components);
    const auto mean = [](const Project& p) {
        return static_cast<const MapField*>(findMap(p, tables().components, kLawnDensity)->value)->map.mean();
    };
    EXPECT_LT(mean(shown), mean(f.doc.project()));
    EXPECT_TRUE(f.doc.undo());
    EXPECT_EQ(f.layer(0).amounts.map.mean(), 1);
}

TEST(LayerEdits, ImportAnImageInOneStepAndRememberHow) {
    LayeredField f;
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Image));
    Map map({4, 4, 1, PixelType::U8});
    map.set(0, 0, 0, 1);
    ASSERT_TRUE(writeMap(f.dir / "in.png", map));
    const std::string path = "lawn.MapLayers.layers[image]";
    EXPECT_FALSE(importLayer(f.doc, path, f.dir / "none.png", {}));
    const size_t steps = f.doc.stepsDone();
    ASSERT_TRUE(importLayer(f.doc, path, f.dir / "in.png", {.flip = true, .range = {}}));
    EXPECT_EQ(f.doc.stepsDone(), steps + 1);
    EXPECT_EQ(f.layer(0).amounts.map.at(0, 3), 1);
    EXPECT_TRUE(f.doc.project().imports.at(path + ".amounts").flip);
}

TEST(LayerEdits, LayersFollowTheirSpeciesWhenItIsRenamed) {
    LayeredField f;
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Rule));
    ASSERT_TRUE(f.doc.setField("lawn.GrassField.species[lawn].name", "clover"));
    EXPECT_EQ(layersOver(f.doc.project(), "lawn.GrassField.species[clover].density").size(), 1u);
    EXPECT_TRUE(f.doc.undo());
    EXPECT_EQ(f.names(), Names{"rule"}) << "in the same step";
    EXPECT_EQ(f.doc.stepsDone(), 1u);
}

TEST(LayerEdits, WhatALayerLiesOverMayGoAndComeBack) {
    LayeredField f;
    ASSERT_TRUE(f.doc.addListElement("lawn.GrassField.species"));
    const std::string added =
        elementSelectors(*findField(f.doc.project(), tables().components, "lawn.GrassField.species")->row->list,
                         findField(f.doc.project(), tables().components, "lawn.GrassField.species")->value)[1];
    const std::string map = "lawn.GrassField.species[" + added + "].density";
    ASSERT_TRUE(addLayer(f.doc, map, LayerKind::Rule));
    ASSERT_TRUE(f.doc.removeListElement("lawn.GrassField.species[" + added + "]"));
    MapStacks stacks;
    stacks.shown(f.doc.project(), tables().components);
    ASSERT_EQ(stacks.notes().size(), 1u);
    EXPECT_NE(stacks.notes()[0].message.find("there is no map " + map), std::string::npos);
    EXPECT_TRUE(f.doc.undo());
    EXPECT_EQ(layersOver(f.doc.project(), map).size(), 1u);
}

// --- over heights

constexpr const char* kHeights = "ground.Terrain.height";

TEST(LayerEdits, OverHeightsBeginGently) {
    LayeredField f;
    for (const LayerKind kind : {LayerKind::Rule, LayerKind::Painted}) ASSERT_TRUE(addLayer(f.doc, kHeights, kind));
    EXPECT_EQ(kindUnder(f.doc, kHeights), MapKind::Heights);
    EXPECT_EQ(kindUnder(f.doc, "ground.MapLayers.layers[painted].amounts"), MapKind::Heights);
    EXPECT_EQ(kindUnder(f.doc, kLawnDensity), MapKind::Amounts);
    const MapLayer& bumps = *layersOver(f.doc.project(), kHeights)[0].layer;
    EXPECT_EQ(bumps.operation, LayerOperation::Add);
    EXPECT_EQ(bumps.masks.at(0).by, MaskBy::Noise);
    float lowest = 9, highest = -9;
    for (int i = 0; i < 400; ++i) {
        const float height = static_cast<float>(terrainHeight(*f.doc.ground().terrain, i % 20 * 2 + 1, i / 20 * 2 + 1));
        lowest = std::min(lowest, height), highest = std::max(highest, height);
    }
    EXPECT_GE(lowest, 0);
    EXPECT_LE(highest, 1);
    EXPECT_GT(highest - lowest, 0.3f) << "the ground that hands find is that of the layers";
    const Terrain& painted = *findGround(f.doc.project()).terrain;
    EXPECT_FALSE(painted.height.present()) << "nothing was sculpted";
    EXPECT_TRUE(f.doc.undo() && f.doc.undo());
    EXPECT_EQ(&f.doc.standing(), &f.doc.project());
}

TEST(LayerEdits, WhoSculptsIsToldHowManyLayersLieAbove) {
    LayeredField f;
    EXPECT_EQ(sculptsBelow(f.doc, kHeights), "");
    for (const LayerKind kind : {LayerKind::Rule, LayerKind::Painted}) ASSERT_TRUE(addLayer(f.doc, kHeights, kind));
    EXPECT_EQ(sculptsBelow(f.doc, kHeights), "below 2 layers");
    EXPECT_EQ(sculptsBelow(f.doc, "ground.MapLayers.layers[painted].amounts"), "") << "on a layer nothing is below";
    ASSERT_TRUE(f.doc.setField("ground.MapLayers.layers[rule].muted", "true"));
    EXPECT_EQ(sculptsBelow(f.doc, kHeights), "below 1 layer");
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Rule));
    EXPECT_EQ(sculptsBelow(f.doc, kLawnDensity), "") << "what is painted there is not seen as a height";
}

TEST(LayerEdits, OverColoursBeginOnWhatIsSteep) {
    LayeredField f;
    const std::string colours = "ground.Terrain.terrainMap";
    for (const LayerKind kind : {LayerKind::Rule, LayerKind::Painted}) ASSERT_TRUE(addLayer(f.doc, colours, kind));
    EXPECT_EQ(kindUnder(f.doc, colours), MapKind::Colours);
    const MapLayer& steep = *layersOver(f.doc.project(), colours)[0].layer;
    EXPECT_EQ(steep.operation, LayerOperation::Replace);
    EXPECT_EQ(steep.masks.at(0).by, MaskBy::Slope);
    EXPECT_EQ(steep.masks.at(0).from, 35);
    MapStacks stacks;
    const Map& shown = findGround(stacks.shown(f.doc.project(), tables().components)).terrain->terrainMap.map;
    EXPECT_EQ(shown.mean(3), 0) << "a level project shows neither";
    EXPECT_TRUE(f.doc.undo() && f.doc.undo());
    EXPECT_FALSE(f.doc.dirty());
}

TEST(LayerEdits, APathsLayerTakesTheFirstPath) {
    LayeredField f;
    ASSERT_TRUE(f.doc.addEntity("way"));
    ASSERT_TRUE(f.doc.addComponent("way", "GroundPath"));
    ASSERT_TRUE(addLayer(f.doc, kHeights, LayerKind::Path));
    const MapLayer& level = *layersOver(f.doc.project(), kHeights)[0].layer;
    EXPECT_EQ(level.path, "way");
    EXPECT_EQ(level.operation, LayerOperation::Replace);
    ASSERT_TRUE(addLayer(f.doc, kLawnDensity, LayerKind::Path));
    EXPECT_EQ(f.layer(0).operation, LayerOperation::Multiply);
}

TEST(LayerEdits, APictureOfMetresKeepsThem) {
    LayeredField f;
    Map metres({64, 64, 1, PixelType::F32});
    for (int x = 0; x < 64; ++x)
        for (int y = 0; y < 64; ++y) metres.set(x, y, 0, 3 + static_cast<float>(x) / 63 * 5);
    ASSERT_TRUE(writeMap(f.dir / "metres.exr", metres));
    ASSERT_TRUE(addLayer(f.doc, kHeights, LayerKind::Image));
    const std::string layer = "ground.MapLayers.layers[image]";
    ASSERT_TRUE(importLayer(f.doc, layer, f.dir / "metres.exr", {}));
    EXPECT_EQ(layersOver(f.doc.project(), kHeights)[0].layer->low, 3);
    EXPECT_EQ(layersOver(f.doc.project(), kHeights)[0].layer->high, 8);
    const glm::dvec2 size = f.doc.ground().terrain->size;
    EXPECT_NEAR(terrainHeight(*f.doc.ground().terrain, 0.5 * size.x / 64, 5), 3, 0.01);  // between the terrain's texels
    EXPECT_NEAR(terrainHeight(*f.doc.ground().terrain, 63.5 * size.x / 64, 5), 8,
                0.01);  // between the terrain's texels
    ASSERT_TRUE(f.doc.save());
    const double height = terrainHeight(*f.doc.ground().terrain, 11.3, 7.7);
    Document again(tables());
    ASSERT_TRUE(again.open(f.dir / "p"));
    EXPECT_EQ(terrainHeight(*again.ground().terrain, 11.3, 7.7), height);
    ASSERT_TRUE(f.doc.undo());
    EXPECT_EQ(layersOver(f.doc.project(), kHeights)[0].layer->high, 1) << "one step";
    ASSERT_TRUE(writeImagePng(f.dir / "eight.png", 1, 1, 1, {7}));
    const Status refused = importLayer(f.doc, layer, f.dir / "eight.png", {});
    EXPECT_FALSE(refused) << "8 bits are no heights";
}

}  // namespace
}  // namespace sward
