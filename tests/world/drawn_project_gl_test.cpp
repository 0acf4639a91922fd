// A path in the pictures: of the renderer by each technique, and of the ray-traced truth.
#include <gtest/gtest.h>

#include "cost/frame_stats.h"
#include "reference/reference.h"
#include "scenes.h"
#include "world/drawn_project.h"

namespace sward::test {
namespace {

GroundPath clearing() {
    GroundPath p;
    p.points = {{"", {0, 10}}, {"", {20, 10}}};
    p.width = 30, p.falloff = 0;
    return p;
}
std::vector<uint8_t> drawn(Renderer& renderer, const Project& p) {
    const Status s = renderer.draw(p, eyeHeight(), small());
    EXPECT_TRUE(s) << (s ? "" : s.error().text());
    return renderer.readImage();
}

TEST(DrawnProject, APathThatClearsAllIsTheSameAsAFieldWithoutBladesInEveryTechnique) {
    const NoGlErrors noErrors;
    Renderer renderer(gpu(), tables());
    for (const TechniqueRow& row : tables().techniques) {
        Project p = lawn();
        GrassField& grass = *p.registry.get<GrassField>(findEntity(p, "grass"));
        grass.technique = row.name;
        grass.species[0].density = field(filled({256, 256, 1, PixelType::U16}, 1));
        const std::vector<uint8_t> full = drawn(renderer, p);
        put(p, "way", clearing());
        const std::vector<uint8_t> cleared = drawn(renderer, p);
        p.registry.remove<GroundPath>(findEntity(p, "way"));
        EXPECT_EQ(drawn(renderer, p), full) << row.name << ": without it, byte for byte as before";
        EXPECT_NE(full, cleared) << row.name;
        grass.species[0].density = field(filled({256, 256, 1, PixelType::U16}, 0));
        EXPECT_EQ(drawn(renderer, p), cleared) << row.name;
    }
}
TEST(DrawnProject, StatisticsCountTheBladesThatAreLeft) {
    Project p = lawn();
    Renderer renderer(gpu(), tables());
    ViewSettings s = small();
    s.measure = true;
    ASSERT_TRUE(renderer.draw(p, above(), s));
    EXPECT_EQ(renderer.stats().bladesVirtual, 80000);
    const uint64_t seen = visibleBlades(p, tables(), above(), 160, 120);
    GroundPath half = clearing();
    half.width = 10;
    put(p, "way", half);
    ASSERT_TRUE(renderer.draw(p, above(), s));
    EXPECT_NEAR(renderer.stats().bladesVirtual, 40000, 400);
    EXPECT_LT(visibleBlades(p, tables(), above(), 160, 120), seen / 2);
    ASSERT_TRUE(renderer.stats().features.end() !=
                std::find(renderer.stats().features.begin(), renderer.stats().features.end(), "grass-density"));
}
TEST(DrawnProject, TheTruthMeetsNoBladeOnIt) {
    Project p = lawn();
    const auto share = [&](const Project& of) {
        JobControl control;
        auto scene = ReferenceScene::make(of, tables(), 0, control);
        EXPECT_TRUE(scene) << (scene ? "" : scene.error().text());
        ReferenceSettings s;
        s.width = 40, s.height = 30, s.samples = 2, s.lighting = ReferenceLighting::Direct;
        const auto truth = scene->trace(above(), s, control);
        EXPECT_TRUE(truth);
        float sum = 0;
        for (const float g : truth->grass) sum += g;
        return sum;
    };
    EXPECT_GT(share(p), 20);
    put(p, "way", clearing());
    EXPECT_EQ(share(p), 0);
}

}  // namespace
}  // namespace sward::test
