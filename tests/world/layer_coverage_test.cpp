// How much of a layer there is where, evaluated again only where something changed.
#include "world/layer_coverage.h"

#include "scene/ground_path.h"
#include "tests/world/layered.h"

namespace sward {
namespace {

using namespace test;

constexpr MapInfo kTexels{200, 200, 1, PixelType::F32};

LayerScene sceneOf(const Project& p) {
    LayerScene scene;
    lookAt(scene, p, findGround(p));
    return scene;
}

TEST(LayerCoverage, OfAPathIsItsWeight) {
    Project p = rampLawn(0);
    put(p, "way", GroundPath{.points = {{"a", {2, 10}}, {"b", {18, 10}}}, .width = 2, .falloff = 2});
    MapLayer layer = ruleLayer("along", {});
    layer.kind = LayerKind::Path;
    layer.path = "way";
    LayerScene scene = sceneOf(p);
    Coverage c;
    ASSERT_TRUE(updateCoverage(c, scene, layer, kTexels));
    EXPECT_EQ(at(c.map, 10, 10.5), 1);
    EXPECT_NEAR(at(c.map, 10, 12), 0.5f, 0.01f) << "half way down its falloff";
    EXPECT_EQ(at(c.map, 10, 13.5), 0);
    layer.invert = true;
    ASSERT_TRUE(updateCoverage(c, scene, layer, kTexels));
    EXPECT_EQ(at(c.map, 10, 13.5), 1);
    layer.path = "nowhere";
    const Status lost = updateCoverage(c, scene, layer, kTexels);
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().message, "there is no path \"nowhere\"");
}

TEST(LayerCoverage, APathOfOnePointIsARoundSpot) {
    Project p = rampLawn(0);
    put(p, "spot", GroundPath{.points = {{"only", {10, 10}}}, .width = 4, .falloff = 0});
    MapLayer layer = ruleLayer("along", {});
    layer.kind = LayerKind::Path;
    layer.path = "spot";
    LayerScene scene = sceneOf(p);
    Coverage c;
    ASSERT_TRUE(updateCoverage(c, scene, layer, kTexels));
    EXPECT_EQ(at(c.map, 10, 10), 1);
    EXPECT_EQ(at(c.map, 11.5, 10), 1);
    EXPECT_EQ(at(c.map, 12.5, 10), 0);
    EXPECT_EQ(at(c.map, 10, 7), 0);
    p.registry.get<GroundPath>(findEntity(p, "spot"))->points.clear();
    const Status none = updateCoverage(c, scene, layer, kTexels);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "the path \"spot\" has no points");
}

TEST(LayerCoverage, IsEvaluatedAgainWhereHeightsChangedAlone) {
    Project p = rampLawn(40);
    LayerScene scene = sceneOf(p);
    Coverage c;
    const MapLayer steep = ruleLayer("steep", {maskBy(MaskBy::Slope, 0, 35)});
    ASSERT_TRUE(updateCoverage(c, scene, steep, kTexels));
    EXPECT_EQ(scene.evaluated, 4u);
    lookAt(scene, p, findGround(p));
    ASSERT_TRUE(updateCoverage(c, scene, steep, kTexels));
    EXPECT_EQ(scene.evaluated, 0u);
    p.registry.get<Terrain>(findEntity(p, "ground"))->height.map.set(20, 20, 0, 3);
    lookAt(scene, p, findGround(p));
    ASSERT_TRUE(updateCoverage(c, scene, steep, kTexels));
    EXPECT_EQ(scene.evaluated, 1u);
    EXPECT_EQ(at(c.map, 2.15, 2.05), 0) << "beside the spike";
    EXPECT_FALSE(c.zero);
}

TEST(LayerCoverage, CombinesByItsOperation) {
    EXPECT_EQ(combined(LayerOperation::Add, 2, 3), 5);
    EXPECT_EQ(combined(LayerOperation::Subtract, 2, 3), -1);
    EXPECT_EQ(combined(LayerOperation::Multiply, 2, 3), 6);
    EXPECT_EQ(combined(LayerOperation::Replace, 2, 3), 3);
    EXPECT_EQ(combined(LayerOperation::Minimum, 2, 3), 2);
    EXPECT_EQ(combined(LayerOperation::Maximum, 2, 3), 3);
}

}  // namespace
}  // namespace sward
