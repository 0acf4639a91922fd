// What maps with layers come to: by kinds and operations, evaluated only where something changed, and nothing lost.
#include "world/map_stacks.h"

#include "tests/rows.h"
#include "tests/world/layered.h"

namespace sward {
namespace {

using namespace test;

MapLayer paintedLayer(const std::string& name, float amount, LayerOperation operation) {
    MapLayer layer = ruleLayer(name, {}, operation);
    layer.kind = LayerKind::Painted;
    layer.amounts = field(filled({256, 256, 1, PixelType::U16}, amount), "maps/" + name + ".png");
    return layer;
}

TEST(MapStacks, HandAProjectWithoutLayersThrough) {
    const Project p = rampLawn(40);
    MapStacks stacks;
    EXPECT_EQ(&stacks.shown(p, rows()), &p);
    EXPECT_EQ(stacks.evaluatedTiles(), 0u);
    EXPECT_FALSE(withLayers(p, rows()));
}

TEST(MapStacks, NoGrassAbove35DegreesAndNoneBelowOneMetreLeavesWhatWasPainted) {
    Project p = rampLawn(40);
    lay(p, {ruleLayer("not steep", {maskBy(MaskBy::Slope, 0, 35)})});
    const Map before = painted(p);
    MapStacks stacks;
    const Project& steep = stacks.shown(p, rows());
    EXPECT_NEAR(at(density(steep), 5, 5), 0.8f, 1e-4f);
    EXPECT_EQ(at(density(steep), 15, 5), 0);
    EXPECT_TRUE(painted(p).sameTiles(before)) << "the painted map is as it was";
    EXPECT_EQ(density(steep).info(), before.info());
    lay(p, {ruleLayer("not low", {maskBy(MaskBy::Height, 1, std::numeric_limits<float>::infinity())})});
    const Project& low = stacks.shown(p, rows());
    EXPECT_EQ(at(density(low), 5, 5), 0);
    EXPECT_NEAR(at(density(low), 15, 5), 0.8f, 1e-4f);
    lay(p, {ruleLayer("not steep", {maskBy(MaskBy::Slope, 0, 35)}),
            ruleLayer("not low", {maskBy(MaskBy::Height, 1, std::numeric_limits<float>::infinity())})});
    EXPECT_EQ(density(stacks.shown(p, rows())).mean(), 0) << "steep where it is not low";
}

TEST(MapStacks, CombineAsTheirOperationsSay) {
    struct Row {
        LayerOperation operation;
        float expected;  // of 0.6 below and 0.3
    };
    for (const Row& row :
         {Row{LayerOperation::Multiply, 0.18f}, Row{LayerOperation::Add, 0.9f}, Row{LayerOperation::Subtract, 0.3f},
          Row{LayerOperation::Replace, 0.3f}, Row{LayerOperation::Minimum, 0.3f}, Row{LayerOperation::Maximum, 0.6f}}) {
        Project p = rampLawn(0, 0.6f);
        MapLayers& layers = lay(p, {paintedLayer("over", 0.3f, row.operation)});
        EXPECT_NEAR(at(density(*withLayers(p, rows())), 3, 3), row.expected, 1e-4f) << kLayerOperations[row.operation];
        layers.layers[0].opacity = 0.5f;
        EXPECT_NEAR(at(density(*withLayers(p, rows())), 3, 3), (0.6f + row.expected) / 2, 1e-4f);
        layers.layers[0].opacity = 1;
        layers.layers[0].invert = true;
        layers.layers[0].operation = LayerOperation::Replace;
        EXPECT_NEAR(at(density(*withLayers(p, rows())), 3, 3), 0.7f, 1e-4f);
    }
    Project p = rampLawn(0, 0.6f);
    lay(p, {paintedLayer("more", 0.7f, LayerOperation::Add), paintedLayer("less", 0.7f, LayerOperation::Subtract)});
    EXPECT_NEAR(at(density(*withLayers(p, rows())), 3, 3), 0.3f, 1e-4f)
        << "the sum is kept at 1, the first lies lowest";
    std::swap(p.registry.get<MapLayers>(findEntity(p, "grass"))->layers[0],
              p.registry.get<MapLayers>(findEntity(p, "grass"))->layers[1]);
    EXPECT_NEAR(at(density(*withLayers(p, rows())), 3, 3), 0.7f, 1e-4f);
}

TEST(MapStacks, MultiplyTheMasksOfARule) {
    Project p = rampLawn(40, 1);
    MapMask right = maskBy(MaskBy::Height, 1, 100);
    lay(p, {ruleLayer("both", {maskBy(MaskBy::Slope, 0, 39, 2), right}, LayerOperation::Replace)});
    const Map both = density(*withLayers(p, rows()));
    EXPECT_EQ(at(both, 5, 5), 0);
    EXPECT_NEAR(at(both, 15, 5), 0.5f, 0.01f);
    p.registry.get<MapLayers>(findEntity(p, "grass"))->layers[0].invert = true;
    EXPECT_NEAR(at(density(*withLayers(p, rows())), 5, 5), 1, 1e-4f);
}

TEST(MapStacks, LayAnImageOfAnySizeOverAMap) {
    Project p = rampLawn(0, 1);
    MapLayer image = paintedLayer("image", 0, LayerOperation::Multiply);
    image.kind = LayerKind::Image;
    image.amounts.map = Map({2, 1, 1, PixelType::U8});
    image.amounts.map.set(1, 0, 0, 1);
    lay(p, {image});
    const Map shown = density(*withLayers(p, rows()));
    EXPECT_EQ(at(shown, 2, 10), 0);
    EXPECT_NEAR(at(shown, 10, 10), 0.5f, 0.01f);
    EXPECT_EQ(at(shown, 18, 10), 1);
}

TEST(MapStacks, MakeTheMapThatNobodyPainted) {
    Project p = rampLawn(40);
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density = {};
    lay(p, {ruleLayer("not steep", {maskBy(MaskBy::Slope, 0, 35)})});
    const std::optional<Project> shown = withLayers(p, rows());
    EXPECT_EQ(at(density(*shown), 5, 5), 1);
    EXPECT_EQ(at(density(*shown), 15, 5), 0);
    EXPECT_TRUE(painted(p).empty());
}

TEST(MapStacks, KeepMutedLayersAndThoseOfNoOpacityWithoutATrace) {
    Project p = rampLawn(40);
    MapLayers& layers = lay(p, {ruleLayer("not steep", {maskBy(MaskBy::Slope, 0, 35)})});
    layers.layers[0].muted = true;
    EXPECT_FALSE(withLayers(p, rows()));
    layers.layers[0].muted = false;
    layers.layers[0].opacity = 0;
    EXPECT_FALSE(withLayers(p, rows()));
}

// 1024 x 1024 texels: 8 x 8 tiles.
Project wide() {
    Project p = rampLawn(20);
    painted(p) = filled({1024, 1024, 1, PixelType::U16}, 0.8f);
    lay(p,
        {ruleLayer("not steep", {maskBy(MaskBy::Slope, 0, 35)}), ruleLayer("spots", {maskBy(MaskBy::Noise, 0.3f, 1)})});
    return p;
}

TEST(MapStacks, EvaluateOnlyTheTilesThatAStrokeChanged) {
    Project p = wide();
    MapStacks stacks;
    const Map first = density(stacks.shown(p, rows()));
    EXPECT_EQ(stacks.evaluatedTiles(), 3u * 64);
    EXPECT_TRUE(density(stacks.shown(p, rows())).sameTiles(first));
    EXPECT_EQ(stacks.evaluatedTiles(), 0u);
    for (int y = 150; y < 250; ++y)
        for (int x = 260; x < 380; ++x) painted(p).set(x, y, 0, 0.1f);
    const Map second = density(stacks.shown(p, rows()));
    EXPECT_EQ(stacks.evaluatedTiles(), 1u);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) EXPECT_EQ(second.tile(x, y) == first.tile(x, y), x != 2 || y != 1);
    EXPECT_TRUE(second.sameTiles(density(*withLayers(p, rows()))) ||
                second.hash() == density(*withLayers(p, rows())).hash());
}

TEST(MapStacks, EvaluateMasksOfSlopeAnewWhereHeightsChanged) {
    Project p = wide();
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    Map heights({512, 512, 1, PixelType::F32});
    t.height.map = heights;
    MapStacks stacks;
    const Map first = density(stacks.shown(p, rows()));
    for (int y = 300; y < 310; ++y)
        for (int x = 300; x < 310; ++x) t.height.map.set(x, y, 0, static_cast<float>(x - 300));
    const Map second = density(stacks.shown(p, rows()));
    EXPECT_EQ(stacks.evaluatedTiles(), 2u) << "one of the slope's, and one of what they come to";
    EXPECT_LT(at(second, 305.5 / 512 * 20, 305.5 / 512 * 20), 0.01f);
    EXPECT_EQ(second.hash(), density(*withLayers(p, rows())).hash()) << "as if evaluated at once";
}

TEST(MapStacks, SettingsOfOneLayerLeaveTheOthersAsTheyAre) {
    Project p = wide();
    MapStacks stacks;
    stacks.shown(p, rows());
    MapLayers& layers = *p.registry.get<MapLayers>(findEntity(p, "grass"));
    layers.layers[1].opacity = 0.5f;
    stacks.shown(p, rows());
    EXPECT_EQ(stacks.evaluatedTiles(), 64u) << "combined anew";
    layers.layers[1].masks[0].seed = 7;
    stacks.shown(p, rows());
    EXPECT_GT(stacks.evaluatedTiles(), 64u) << "one of two layers evaluated anew ...";
    EXPECT_LE(stacks.evaluatedTiles(), 128u) << "... and combined where it differs";
    layers.layers.clear();
    EXPECT_EQ(&stacks.shown(p, rows()), &p);
    EXPECT_EQ(stacks.evaluatedTiles(), 0u);
}

struct Said {
    const char* what;
    void (*change)(Project&);
    const char* message;
    bool skipped;
};
MapLayer& first(Project& p) { return p.registry.get<MapLayers>(findEntity(p, "grass"))->layers[0]; }

TEST(MapStacks, SkipLayersWithoutWhatTheyGoByAndSaySo) {
    const Said kSaid[] = {
        {"no water", [](Project& p) { first(p).masks[0].by = MaskBy::Water; }, "the scene has no water", true},
        {"no object",
         [](Project& p) {
             first(p).masks[0].by = MaskBy::Object;
             first(p).masks[0].object = "bench";
         },
         "mask \"mask\": there is no entity \"bench\"", true},
        {"no texels", [](Project& p) { first(p).kind = LayerKind::Painted; }, "it has no amounts yet", true},
        {"no file",
         [](Project& p) {
             first(p).kind = LayerKind::Image;
             first(p).amounts.file = "maps/gone.png";
         },
         "its file maps/gone.png is not there", true},
        {"no map", [](Project& p) { first(p).map = "GrassField.species[moss].density"; },
         "there is no map grass.GrassField.species[moss].density", true},
        {"directions", [](Project& p) { first(p).map = "GrassField.orientation"; },
         "holds no amounts or colours on the terrain", true},
        {"repeats",
         [](Project& p) { p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].densityTiling = 2; },
         "repeats, and layers lie on the whole terrain", true},
        {"hides all", [](Project& p) { first(p).masks[0].from = 80, first(p).masks[0].to = 90; },
         "hides all of the map", false},
        {"does nothing",
         [](Project& p) {
             first(p).masks[0].from = 80, first(p).masks[0].to = 90;
             first(p).operation = LayerOperation::Add;
         },
         "it is 0 everywhere and changes nothing", false},
    };
    for (const Said& row : kSaid) {
        Project p = rampLawn(40);
        lay(p, {ruleLayer("it", {maskBy(MaskBy::Slope, 0, 35)})});
        row.change(p);
        MapStacks stacks;
        const bool changed = &stacks.shown(p, rows()) != &p;
        EXPECT_EQ(changed, !row.skipped) << row.what;
        ASSERT_EQ(stacks.notes().size(), 1u) << row.what;
        EXPECT_EQ(stacks.notes()[0].layer, "grass.MapLayers.layers[it]");
        EXPECT_NE(stacks.notes()[0].message.find(row.message), std::string::npos) << stacks.notes()[0].message;
        EXPECT_EQ(stacks.notes()[0].skipped, row.skipped) << row.what;
    }
}

TEST(MapStacks, GoOnWithTheOtherLayersWhereOneIsSkipped) {
    Project p = rampLawn(40);
    lay(p,
        {ruleLayer("by water", {maskBy(MaskBy::Water, 1, 2)}), ruleLayer("not steep", {maskBy(MaskBy::Slope, 0, 35)})});
    EXPECT_EQ(at(density(*withLayers(p, rows())), 15, 5), 0);
    EXPECT_NEAR(at(density(*withLayers(p, rows())), 5, 5), 0.8f, 1e-4f);
}

TEST(MapStacks, ALayerThatWasSkippedComesBackWithWhatChangedMeanwhile) {
    Project p = rampLawn(40, 1);
    lay(p, {ruleLayer("dry and level", {maskBy(MaskBy::Slope, 0, 35),
                                        maskBy(MaskBy::Water, 0.5f, std::numeric_limits<float>::infinity())})});
    put<Water>(p, "pond").level = -1;
    MapStacks stacks;
    EXPECT_EQ(at(density(stacks.shown(p, rows())), 5, 5), 1);
    removeEntity(p, "pond");
    EXPECT_EQ(&stacks.shown(p, rows()), &p);
    Map& heights = p.registry.get<Terrain>(findEntity(p, "ground"))->height.map;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) heights.set(x, y, 0, static_cast<float>(x) * 0.2f);
    stacks.shown(p, rows());
    put<Water>(p, "pond").level = -1;
    const Map back = density(stacks.shown(p, rows()));
    EXPECT_EQ(at(back, 5, 5), 0);
    EXPECT_EQ(back.hash(), density(*withLayers(p, rows())).hash());
}

TEST(MapStacks, ShowTheCoverageOfARuleAsItsAmounts) {
    Project p = rampLawn(40);
    lay(p, {ruleLayer("not steep", {maskBy(MaskBy::Slope, 0, 35)})});
    std::optional<Project> shown = withLayers(p, rows());
    const Map& coverage = first(*shown).amounts.map;
    EXPECT_EQ(at(coverage, 5, 5), 1);
    EXPECT_EQ(at(coverage, 15, 5), 0);
    EXPECT_TRUE(first(p).amounts.map.empty());
}

}  // namespace
}  // namespace sward
