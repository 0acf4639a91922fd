// Strokes: where a hand is heading, what brushes are refused, and how maps lie on the terrain.
#include "tools/stroke.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "model/document.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

TEST(Stroke, AHeadingFollowsTheHandAndForgetsWhatLiesBehind) {
    EXPECT_EQ(headingAfter({0.2, 0.3}, 0, 0, 0, 1), glm::dvec2(0.2, 0.3)) << "no motion";
    glm::dvec2 heading{0};
    for (int i = 0; i < 50; ++i) heading = headingAfter(heading, 0.1, 0, 0.1, 0.5);
    EXPECT_NEAR(heading.x, 1, 1e-3);
    EXPECT_EQ(heading.y, 0);
    const glm::dvec2 turned = headingAfter(heading, 0, 0.1, 0.1, 0.5);
    EXPECT_GT(turned.x, 0.5) << "one small step does not turn it";
    for (int i = 0; i < 50; ++i) heading = headingAfter(heading, 0, 0.1, 0.1, 0.5);
    EXPECT_NEAR(heading.y, 1, 1e-3);
}

TEST(Stroke, BrushesOutOfTheirRangesAreRefused) {
    BrushSettings good;
    good.mode = "add", good.radius = 2;
    EXPECT_TRUE(checkBrush(good));
    const float nan = std::nanf("");
    for (const auto& change : std::initializer_list<std::function<void(BrushSettings&)>>{
             [](BrushSettings& b) { b.mode = "spray"; }, [&](BrushSettings& b) { b.radius = nan; },
             [](BrushSettings& b) { b.radius = -1; }, [](BrushSettings& b) { b.strength = 2; },
             [&](BrushSettings& b) { b.falloff = nan; }, [](BrushSettings& b) { b.value = 1e9f; }}) {
        BrushSettings bad = good;
        change(bad);
        const Status s = checkBrush(bad);
        ASSERT_FALSE(s);
        EXPECT_EQ(s.error().code, ExitCode::Usage);
    }
}

TEST(Stroke, AMapLiesOnItsTerrainOnceOrAsOftenAsItsTilingSays) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    const auto scale = [&] {
        const auto f = findField(doc.project(), tables().components, "lawn.GrassField.species[lawn].density");
        return mapScale(doc.project(), *f);
    };
    ASSERT_TRUE(scale());
    EXPECT_EQ(scale()->width, 40);
    EXPECT_FALSE(scale()->repeats);
    ASSERT_TRUE(doc.setField("lawn.GrassField.species[lawn].densityTiling", "4"));
    EXPECT_EQ(scale()->width, 10);
    EXPECT_TRUE(scale()->repeats);
    ASSERT_TRUE(doc.removeEntity("ground"));
    ASSERT_FALSE(scale());
    EXPECT_NE(scale().error().text().find("add an entity with a Terrain"), std::string::npos);
}

}  // namespace
}  // namespace sward
