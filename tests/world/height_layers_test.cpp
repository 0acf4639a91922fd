// Heights with layers over them: in metres, one on the other, evaluated only where something changed, nothing lost.
#include "world/height_layers.h"

#include "scene/ground_path.h"
#include "tests/rows.h"
#include "tests/world/layered.h"
#include "world/ground.h"

namespace sward {
namespace {

using namespace test;

MapLayer over(const std::string& name, LayerKind kind, LayerOperation operation, float high = 1, float low = 0) {
    MapLayer layer;
    layer.name = name;
    layer.map = "Terrain.height";
    layer.kind = kind;
    layer.operation = operation;
    layer.low = low, layer.high = high;
    return layer;
}
MapLayer image(float amount, LayerOperation operation, float high, float low = 0) {
    MapLayer layer = over("image", LayerKind::Image, operation, high, low);
    layer.amounts = field(filled({64, 64, 1, PixelType::F32}, amount), "maps/image.exr");
    return layer;
}
MapLayers& layHeights(Project& p, std::vector<MapLayer> layers) {
    return put(p, "ground", MapLayers{std::move(layers)});
}
double heightAt(const Project& p, double x, double z) { return terrainHeight(*findGround(p).terrain, x, z); }

TEST(HeightLayers, OfAProjectWithoutThemAreNone) {
    Project p = rampLawn(40);
    HeightLayers heights;
    EXPECT_EQ(heights.shown(p), nullptr);
    EXPECT_FALSE(standingOnLayers(heights, p, rows()));
    layHeights(p, {image(1, LayerOperation::Add, 2)}).layers[0].muted = true;
    EXPECT_EQ(heights.shown(p), nullptr);
}

TEST(HeightLayers, LiftAndLevelByMetresAndLeaveWhatWasSculpted) {
    constexpr double kBelow =
        5.05;  // at the texel that is asked, of a ramp; the image is 2 to 6 m at an amount of 0.75
    struct Row {
        LayerOperation operation;
        double expected;
    };
    for (const Row& row : {Row{LayerOperation::Add, kBelow + 5}, Row{LayerOperation::Subtract, kBelow - 5},
                           Row{LayerOperation::Replace, 5}, Row{LayerOperation::Minimum, 5},
                           Row{LayerOperation::Maximum, kBelow}, Row{LayerOperation::Multiply, 5 * kBelow}}) {
        Project p = rampLawn(45);
        const Map before = terrain(p).height.map;
        MapLayers& layers = layHeights(p, {image(0.75f, row.operation, 6, 2)});
        EXPECT_NEAR(heightAt(*withLayers(p, rows()), 15.05, 10), row.expected, 1e-4) << kLayerOperations[row.operation];
        EXPECT_TRUE(terrain(p).height.map.sameTiles(before)) << "what was sculpted is as it was";
        layers.layers[0].opacity = 0.5f;
        EXPECT_NEAR(heightAt(*withLayers(p, rows()), 15.05, 10), (kBelow + row.expected) / 2, 1e-4);
    }
}

TEST(HeightLayers, ARuleCountsWhereItsMasksLetIt) {
    Project p = rampLawn(45);
    MapLayer step = over("step", LayerKind::Rule, LayerOperation::Add, 3);
    step.masks = {maskBy(MaskBy::Height, 2, kInf)};
    layHeights(p, {step});
    const Project shown = *withLayers(p, rows());
    EXPECT_NEAR(heightAt(shown, 11, 10), 1, 1e-3);
    EXPECT_NEAR(heightAt(shown, 15, 10), 8, 1e-3);
    EXPECT_TRUE(shown.registry.get<MapLayers>(findEntity(shown, "ground"))->layers[0].amounts.present())
        << "for the preview";
}

TEST(HeightLayers, EachSeesTheGroundBelowIt) {
    Project p = rampLawn(0);
    MapLayer step = over("step", LayerKind::Rule, LayerOperation::Add, 3);
    step.masks = {maskBy(MaskBy::Height, 4, kInf)};
    layHeights(p, {step, image(1, LayerOperation::Add, 5)});
    EXPECT_NEAR(heightAt(*withLayers(p, rows()), 5, 5), 5, 1e-4) << "below the image the ground is low";
    layHeights(p, {image(1, LayerOperation::Add, 5), step});
    EXPECT_NEAR(heightAt(*withLayers(p, rows()), 5, 5), 8, 1e-4);
}

TEST(HeightLayers, APathLevelsTheGroundAcrossIt) {
    Project p = rampLawn(45);
    put(p, "way", GroundPath{.points = {{"a", {15, 2}}, {"b", {15, 18}}}, .width = 4, .falloff = 2});
    MapLayer level = over("way", LayerKind::Path, LayerOperation::Replace);
    level.path = "way";
    layHeights(p, {level});
    const Project shown = *withLayers(p, rows());
    EXPECT_NEAR(heightAt(shown, 13.5, 10), 5, 1e-3);
    EXPECT_NEAR(heightAt(shown, 16.5, 10), 5, 1e-3);
    EXPECT_NEAR(heightAt(shown, 12, 10), 3.5, 0.05) << "half way down its falloff";
    EXPECT_NEAR(heightAt(shown, 10.5, 10), 0.5, 1e-3) << "beside it";
    p.registry.get<MapLayers>(findEntity(p, "ground"))->layers[0].low = -0.5f;
    EXPECT_NEAR(heightAt(*withLayers(p, rows()), 15, 10), 4.5, 1e-3) << "a sunken road";
    p.registry.get<MapLayers>(findEntity(p, "ground"))->layers[0].operation = LayerOperation::Minimum;
    const Project cut = *withLayers(p, rows());
    EXPECT_NEAR(heightAt(cut, 13.5, 10), 3.5, 1e-3) << "it only cuts";
    EXPECT_NEAR(heightAt(cut, 16.5, 10), 4.5, 1e-3);
}

TEST(HeightLayers, SayWhyTheySkipWhatCannotBe) {
    struct Row {
        std::function<void(Project&, MapLayer&)> make;
        std::string says;
    };
    const Row table[] = {
        {[](Project&, MapLayer& l) { l.kind = LayerKind::Path; }, "it names no path"},
        {[](Project&, MapLayer& l) { l.kind = LayerKind::Path, l.operation = LayerOperation::Add; }, "minimum"},
        {[](Project&, MapLayer& l) { l.kind = LayerKind::Path, l.invert = true; }, "switch invert off"},
        {[](Project&, MapLayer& l) { l.kind = LayerKind::Image, l.amounts.file = "maps/lost.exr"; }, "lost.exr"},
        {[](Project& p, MapLayer&) { terrain(p).heightTiling = 2; }, "is mirrored"},
        {[](Project&, MapLayer& l) { l.masks = {maskBy(MaskBy::Height, 50, 60)}; }, "0 everywhere"},
    };
    for (const Row& row : table) {
        Project p = rampLawn(0);
        MapLayer layer = over("it", LayerKind::Rule, LayerOperation::Replace);
        row.make(p, layer);
        layHeights(p, {layer});
        HeightLayers heights;
        const Map* shown = heights.shown(p);
        ASSERT_EQ(heights.notes().size(), 1u) << row.says;
        EXPECT_EQ(heights.notes()[0].layer, "ground.MapLayers.layers[it]");
        EXPECT_NE(heights.notes()[0].message.find(row.says), std::string::npos) << heights.notes()[0].message;
        EXPECT_EQ(shown == nullptr, heights.notes()[0].skipped);
    }
}

TEST(HeightLayers, OfIntegersAreMetresAndOfNothingLevelGround) {
    Project p = rampLawn(0);
    terrain(p).height = field(filled({256, 256, 1, PixelType::U16}, 0.5f), "maps/heights.png");
    terrain(p).heightRange = {10, 30};
    layHeights(p, {image(1, LayerOperation::Add, 2)});
    EXPECT_NEAR(heightAt(*withLayers(p, rows()), 5, 5), 22, 1e-3);
    terrain(p).heightRange = {0, 20};
    EXPECT_NEAR(heightAt(*withLayers(p, rows()), 5, 5), 12, 1e-3);
    terrain(p).height = {};
    EXPECT_NEAR(heightAt(*withLayers(p, rows()), 5, 5), 2, 1e-6);
}

TEST(HeightLayers, AreEvaluatedWhereAStrokeWasAlone) {
    Project p = rampLawn(10);
    terrain(p).height = field(filled({1024, 1024, 1, PixelType::F32}, 1), "maps/heights.exr");
    put(p, "way", GroundPath{.points = {{"a", {2, 2}}, {"b", {18, 2}}}, .width = 1, .falloff = 0.5f});
    MapLayer level = over("way", LayerKind::Path, LayerOperation::Replace),
             bumps = over("bumps", LayerKind::Rule, LayerOperation::Add);
    level.path = "way";
    bumps.masks = {maskBy(MaskBy::Noise, 1, 1, 1)};
    layHeights(p, {bumps, level});
    HeightLayers heights;
    ASSERT_TRUE(heights.shown(p));
    EXPECT_EQ(heights.evaluatedTiles(), 4u * 64);
    ASSERT_TRUE(heights.shown(p));
    EXPECT_EQ(heights.evaluatedTiles(), 0u);
    terrain(p).height.map.set(960, 960, 0, 4);
    const Map now = *heights.shown(p);
    EXPECT_EQ(heights.evaluatedTiles(), 2u) << "one tile a layer; the noise stays";
    HeightLayers fresh;
    const Map anew = *fresh.shown(p);
    EXPECT_EQ(now.hash(), anew.hash());
    p.registry.get<GroundPath>(findEntity(p, "way"))->points[1].at = {18, 5};
    EXPECT_EQ(heights.shown(p)->hash(), HeightLayers().shown(p)->hash()) << "where the path was, and where it is";
    terrain(p).height.map.set(200, 140, 0, 9);  // beside the path's middle: what it carries aside
    EXPECT_EQ(heights.shown(p)->hash(), HeightLayers().shown(p)->hash());
}

TEST(HeightLayers, OtherLayersSeeTheGroundAsItStands) {
    Project p = rampLawn(0, 1);
    layHeights(p, {image(1, LayerOperation::Add, 5)});
    lay(p, {ruleLayer("low", {maskBy(MaskBy::Height, -1, 2)})});
    EXPECT_EQ(density(*withLayers(p, rows())).mean(), 0) << "the ground was lifted out of it";
}

TEST(HeightLayers, AProjectStandsOnThemWithoutThem) {
    Project p = rampLawn(0);
    layHeights(p, {image(1, LayerOperation::Add, 5)});
    HeightLayers heights;
    const Project standing = *standingOnLayers(heights, p, rows());
    EXPECT_NEAR(heightAt(standing, 5, 5), 5, 1e-6);
    EXPECT_NEAR(heightAt(withLayers(standing, rows()).value_or(snapshot(standing, rows())), 5, 5), 5, 1e-6)
        << "not twice";
}

}  // namespace
}  // namespace sward
