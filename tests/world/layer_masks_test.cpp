// What masks measure: known slopes, heights and distances, and what is said where there is nothing to measure.
#include "world/layer_masks.h"

#include "scene/ground_path.h"
#include "tests/objects.h"
#include "tests/world/layered.h"

namespace sward {
namespace {

using namespace test;

struct Measured {
    Project project;
    MaskScene scene;
    explicit Measured(Project p) : project(std::move(p)) {
        scene.project = &project;
        scene.ground = findGround(project);
    }
    Result<Measure> by(const MapMask& mask) { return maskRows()[static_cast<size_t>(mask.by)].measure(scene, mask); }
    float at(const MapMask& mask, double x, double z) {
        const Result<Measure> measure = by(mask);
        EXPECT_TRUE(measure) << (measure ? "" : measure.error().text());
        return measure ? (*measure)(x, z) : -1;
    }
};

TEST(LayerMasks, FallStraightBeyondBothEnds) {
    const MapMask mask = maskBy(MaskBy::Height, 2, 5, 2);
    EXPECT_EQ(maskShare(mask, 2), 1);
    EXPECT_EQ(maskShare(mask, 5), 1);
    EXPECT_FLOAT_EQ(maskShare(mask, 1), 0.5f);
    EXPECT_FLOAT_EQ(maskShare(mask, 6.5f), 0.25f);
    EXPECT_EQ(maskShare(mask, 0), 0);
    EXPECT_EQ(maskShare(mask, 1e9f), 0);
    const MapMask sharp = maskBy(MaskBy::Height, 2, std::numeric_limits<float>::infinity());
    EXPECT_EQ(maskShare(sharp, std::numeric_limits<float>::infinity()), 1);
    EXPECT_EQ(maskShare(sharp, 1.999f), 0);
    MapMask inverted = mask;
    inverted.invert = true;
    EXPECT_FLOAT_EQ(maskShare(inverted, 1), 0.5f);
    EXPECT_EQ(maskShare(inverted, 3), 0);
}

TEST(LayerMasks, SlopeAndHeightAreThoseOfARamp) {
    Measured m(rampLawn(30));
    EXPECT_NEAR(m.at(maskBy(MaskBy::Slope, 0, 90), 5, 5), 0, 1e-4f);
    EXPECT_NEAR(m.at(maskBy(MaskBy::Slope, 0, 90), 15, 5), 30, 0.01f);
    EXPECT_NEAR(m.at(maskBy(MaskBy::Slope, 0, 90), 19.99, 19.99), 30, 0.01f) << "at the terrain's edge, too";
    EXPECT_NEAR(m.at(maskBy(MaskBy::Height, 0, 90), 15, 5), 5 * std::tan(glm::radians(30.0)), 1e-3);
}

TEST(LayerMasks, NoiseLiesWithinItsRangeFollowsItsSeedAndVariesAsWideAsItsSize) {
    Measured m(lawn());
    MapMask a = maskBy(MaskBy::Noise, 0, 1), b = a;
    b.seed = 2;
    float low = 1, high = 0, differ = 0, step = 0;
    for (int i = 0; i < 400; ++i) {
        const double x = i * 0.05 * 7, z = i * 0.03;
        const float v = m.at(a, x, z);
        low = std::min(low, v), high = std::max(high, v);
        differ = std::max(differ, std::abs(v - m.at(b, x, z)));
        step = std::max(step, std::abs(v - m.at(a, x + 0.03, z)));
    }
    EXPECT_GE(low, 0);
    EXPECT_LE(high, 1);
    EXPECT_GT(high - low, 0.5f);
    EXPECT_GT(differ, 0.2f);
    EXPECT_LT(step, 0.05f) << "a hundredth of a spot of 3 m";
}

TEST(LayerMasks, DistanceToWaterCountsFromTheShore) {
    Project p = rampLawn(45);
    put<Water>(p, "pond").level = 2;  // the ramp is 2 m high at x = 12
    Measured m(std::move(p));
    const MapMask mask = maskBy(MaskBy::Water, 0, 1);
    EXPECT_EQ(m.at(mask, 11, 10), 0);
    EXPECT_NEAR(m.at(mask, 14, 10), 2, 0.06f);
    EXPECT_NEAR(m.at(mask, 19, 3), 7, 0.06f);
}

TEST(LayerMasks, DistanceToWaterIsThatToTheNearestOfAllPondsWithinTheirPlaces) {
    Project p = rampLawn(45);
    for (const auto& [name, x] : {std::pair("low", 6.0), std::pair("high", 15.0)}) {
        put<Transform>(p, name).position = {x, 0, 10};
        Water& pond = *p.registry.add<Water>(findEntity(p, name));
        pond.level = 10, pond.radius = 2;
    }
    Measured m(std::move(p));
    const MapMask mask = maskBy(MaskBy::Water, 0, 1);
    EXPECT_EQ(m.at(mask, 6, 10), 0);
    EXPECT_EQ(m.at(mask, 15, 11), 0);
    EXPECT_NEAR(m.at(mask, 9, 10), 1, 0.06f);
    EXPECT_NEAR(m.at(mask, 12, 10), 1, 0.06f);
    EXPECT_NEAR(m.at(mask, 6, 16), 4, 0.06f);
}

TEST(LayerMasks, DistanceToWaterFollowsItsLevelAndTheGround) {
    Measured m(rampLawn(45));
    const MapMask mask = maskBy(MaskBy::Water, 0, 1);
    EXPECT_EQ(m.by(mask).error().message, "the scene has no water");
    Water& water = put<Water>(m.project, "pond");
    water.level = 2;
    EXPECT_NEAR(m.at(mask, 15, 10), 3, 0.06f);
    water.level = -1;
    EXPECT_TRUE(std::isinf(m.at(mask, 15, 10)));
    water.level = 2;
    Terrain& t = *m.project.registry.get<Terrain>(findEntity(m.project, "ground"));
    t.size = {40, 40};
    EXPECT_NEAR(m.at(mask, 30, 20), 6, 0.12f) << "the land is as high, and twice as wide";
}

TEST(LayerMasks, DistanceToAnObjectIsThatToItsOutlineOrItsPlace) {
    TempDir dir;
    Project p = lawn();
    p.dir = dir.path;
    const Entity box = *addEntity(p, "box");
    p.registry.add<Transform>(box, {{10, 0, 6}});
    MapMask mask = maskBy(MaskBy::Object, 0, 1);
    mask.object = "box";
    Measured m(std::move(p));
    EXPECT_NEAR(m.at(mask, 13, 10), 5, 1e-4f) << "its place";
    putObject(m.project, "box", {{.size = {2, 1, 4}}}, {10, 0, 6});
    m.project.registry.get<StaticMesh>(findEntity(m.project, "box"))->scale = 1.5f;
    EXPECT_EQ(m.at(mask, 10, 6), 0) << "inside";
    EXPECT_NEAR(m.at(mask, 14.5, 6), 3, 0.1f) << "half of 2 m, half as large again";
    EXPECT_NEAR(m.at(mask, 10, 12), 3, 0.1f);
    m.project.registry.get<StaticMesh>(findEntity(m.project, "box"))->rotationDeg.y = 90;
    EXPECT_NEAR(m.at(mask, 14.5, 6), 1.5f, 0.1f) << "turned";
}

TEST(LayerMasks, DistanceToAPathCountsFromItsEdge) {
    Project p = lawn();
    GroundPath path;
    path.points = {{"a", {5, 0}}, {"b", {5, 10}}, {"c", {5, 20}}};
    path.width = 2;
    put(p, "way", path);
    Measured m(std::move(p));
    MapMask mask = maskBy(MaskBy::Path, 0, 4, 3);
    mask.object = "way";
    EXPECT_EQ(m.at(mask, 5.5, 7), 0);
    EXPECT_NEAR(m.at(mask, 9, 7), 3, 1e-3f);
    EXPECT_NEAR(m.at(mask, 0, 12), 4, 1e-3f);
    EXPECT_GE(m.at(mask, 19, 12), 7) << "beyond its falloff it need not be exact";
    const std::string before = maskRows()[static_cast<size_t>(MaskBy::Path)].inputs(m.scene, mask);
    m.project.registry.get<GroundPath>(findEntity(m.project, "way"))->points[1].at.x = 6;
    EXPECT_NE(maskRows()[static_cast<size_t>(MaskBy::Path)].inputs(m.scene, mask), before) << "it follows the path";
    m.project.registry.get<GroundPath>(findEntity(m.project, "way"))->points.clear();
    EXPECT_EQ(m.by(mask).error().message, "the path \"way\" has no points");
    mask.object = "sun";
    EXPECT_EQ(m.by(mask).error().message, "there is no path \"sun\"");
}

TEST(LayerMasks, SayWhatTheyMiss) {
    Measured m(lawn());
    MapMask mask = maskBy(MaskBy::Object, 0, 1);
    EXPECT_EQ(m.by(mask).error().message, "it names no object");
    mask.object = "bench";
    EXPECT_EQ(m.by(mask).error().message, "there is no entity \"bench\"");
    mask.object = "sun";
    EXPECT_EQ(m.by(mask).error().message, "\"sun\" stands nowhere");
    StaticMesh gone;
    gone.file = "gone.glb";
    put(m.project, "bench", gone);
    mask.object = "bench";
    EXPECT_NE(m.by(mask).error().text().find("gone.glb"), std::string::npos);
}

}  // namespace
}  // namespace sward
