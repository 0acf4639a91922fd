// Pictures, the truth and the plan of a scene with layers are those of one that was painted so.
#include <epoxy/gl.h>

#include "cost/frame_stats.h"
#include "reference/reference.h"
#include "tests/rows.h"
#include "tests/world/layered.h"
#include "world/map_stacks.h"

namespace sward {
namespace {

using namespace test;

Project layered() {
    Project p = rampLawn(40);
    lay(p, {ruleLayer("not steep", {maskBy(MaskBy::Slope, 0, 35, 5)})});
    return p;
}
// The same without layers, its density painted as they leave it.
Project paintedStacks() {
    Project p = snapshot(*withLayers(layered(), rows()), rows());
    p.registry.remove<MapLayers>(findEntity(p, "grass"));
    return p;
}
std::vector<uint8_t> stackPicture(Renderer& r, const Project& p) {
    const Status drawn = r.draw(p, above(), small());
    EXPECT_TRUE(drawn) << drawn.error().text();
    return r.readImage();
}

TEST(LayeredPictures, AreThoseOfAMapThatWasPaintedSoToTheByte) {
    const NoGlErrors none;
    Renderer a(gpu(), tables()), b(gpu(), tables());
    const std::vector<uint8_t> shown = stackPicture(a, layered());
    EXPECT_EQ(shown, stackPicture(b, paintedStacks()));
    EXPECT_NE(shown, stackPicture(b, rampLawn(40))) << "the layer is seen";
}

TEST(LayeredPictures, FollowAStrokeBelowAndAMutedLayer) {
    const NoGlErrors none;
    Renderer r(gpu(), tables()), fresh(gpu(), tables());
    Project p = layered();
    const std::vector<uint8_t> before = stackPicture(r, p);
    for (int y = 60; y < 200; ++y)
        for (int x = 60; x < 120; ++x) painted(p).set(x, y, 0, 0);
    const std::vector<uint8_t> after = stackPicture(r, p);
    EXPECT_NE(after, before);
    EXPECT_EQ(after, stackPicture(fresh, p));
    p.registry.get<MapLayers>(findEntity(p, "grass"))->layers[0].muted = true;
    Project without = snapshot(p, rows());
    without.registry.remove<MapLayers>(findEntity(without, "grass"));
    EXPECT_EQ(stackPicture(r, p), stackPicture(fresh, without));
}

TEST(LayeredPictures, LeaveNothingWhereAProjectHasNoLayers) {
    const NoGlErrors none;
    Renderer r(gpu(), tables());
    const Project bare = rampLawn(40);
    const std::vector<uint8_t> before = stackPicture(r, bare);
    const uint64_t bytes = r.stats().gpuBytes;
    stackPicture(r, layered());
    EXPECT_EQ(stackPicture(r, bare), before);
    EXPECT_TRUE(r.layerNotes().empty());
    EXPECT_EQ(r.stats().gpuBytes, bytes);
    EXPECT_EQ(r.explain(bare, false).find("ayers"), std::string::npos);
}

TEST(LayeredPictures, AreExplained) {
    Renderer r(gpu(), tables());
    Project p = layered();
    MapLayer missing = ruleLayer("by water", {maskBy(MaskBy::Water, 1, 2)});
    p.registry.get<MapLayers>(findEntity(p, "grass"))->layers.push_back(missing);
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density = {};
    const std::string text = r.explain(p, false), json = r.explain(p, true);
    EXPECT_NE(text.find("grass.MapLayers.layers[not steep] (rule, multiply) over "
                        "grass.GrassField.species[lawn].density\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("skipped: mask \"mask\": the scene has no water"), std::string::npos) << text;
    EXPECT_NE(json.find("\"layers\""), std::string::npos);
    EXPECT_EQ(text.find("no species has a density map"), std::string::npos) << "the layers make one";
}

TEST(LayeredPictures, HaveTheTruthAndTheCountsOfAMapThatWasPaintedSo) {
    ReferenceSettings s;
    s.width = 48, s.height = 32, s.samples = 2;
    JobControl control;
    const auto traced = [&](const Project& p) {
        const auto scene = ReferenceScene::make(p, tables(), 0, control);
        EXPECT_TRUE(scene);
        return scene->trace(above(), s, control)->color;
    };
    const Project a = layered(), b = paintedStacks();
    EXPECT_EQ(traced(a), traced(b));
    EXPECT_NE(traced(a), traced(rampLawn(40)));
    EXPECT_EQ(visibleBlades(a, tables(), above(), 160, 120), visibleBlades(b, tables(), above(), 160, 120));
    EXPECT_LT(visibleBlades(a, tables(), above(), 160, 120), visibleBlades(rampLawn(40), tables(), above(), 160, 120));
}

}  // namespace
}  // namespace sward
