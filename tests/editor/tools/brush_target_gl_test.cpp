// What the brush paints on, by the editor's own tools and keys: maps that follow tools, overlays, picked colours.
#include <fmt/format.h>

#include "editor/editor_fixture.h"
#include "tools/brush_target.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

using test::EditorTools;

constexpr const char* kLawnOrientation = "lawn.GrassField.orientation";
constexpr const char* kVegetation = "lawn.GrassField.vegetation";
constexpr const char* kLawnForces = "lawn.GrassField.forces";

TEST_F(EditorTools, TheCombGoesToTheOrientationMapAndOffersToCreateIt) {
    ok(ui->click("Tools/Comb"));
    EXPECT_EQ(app->brushes.map, kLawnOrientation);
    EXPECT_NE(get("Brush/New map").find(" x "), std::string::npos);
    ok(ui->click("Brush/Create map"));
    ASSERT_TRUE(mapOf(kLawnOrientation).present());
    EXPECT_EQ(mapOf(kLawnOrientation).map.info().channels, 2);
    EXPECT_FALSE(ui->exists("Brush/Create map"));
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(mapOf(kLawnOrientation).present());
    ok(ui->click("Tools/Add"));
    EXPECT_TRUE(app->brushes.map.ends_with(".density"));
    ok(ui->set("Brush/Map", kLawnOrientation));
    EXPECT_EQ(app->brushes.tool, "comb");  // the tool last used on directions
}

TEST_F(EditorTools, TheOverlayOfForcesShowsWhatStandsThereToo) {
    ok(ui->set("Brush/Map", kLawnForces));
    EXPECT_EQ(app->brushes.tool, "press");
    EXPECT_EQ(overlayOf(doc, app->brushes).map, "") << "nothing presses";
    const Rect& r = app->hand.rect;
    const auto at = pickGround(doc.project(), viewOf(app->view.camera), static_cast<int>(r.w), static_cast<int>(r.h),
                               static_cast<double>(r.w) * 0.5, static_cast<double>(r.h) * 0.8);
    ASSERT_TRUE(at);
    ASSERT_TRUE(doc.addEntity("stone"));
    ASSERT_TRUE(doc.addComponent("stone", "ForceSource"));
    ASSERT_TRUE(doc.addComponent("stone", "Transform"));
    ASSERT_TRUE(doc.setField("stone.Transform.position", fmt::format("[{}, {}, {}]", at->x, at->y, at->z)));
    EXPECT_EQ(overlayOf(doc, app->brushes).map, kLawnForces);
    const std::vector<uint8_t> shown = picture();
    ok(ui->key("o"));
    EXPECT_NE(picture(), shown);
}

TEST_F(EditorTools, TheOverlayShowsDirectionsUnaskedAndDensitiesOnDemand) {
    EXPECT_FALSE(overlayShown(doc, app->brushes));
    const std::vector<uint8_t> plain = picture();
    ok(ui->click("Brush/Overlay"));
    EXPECT_NE(picture(), plain);
    ok(ui->key("o"));
    EXPECT_EQ(picture(), plain);
    ok(ui->click("Tools/Comb"));
    EXPECT_EQ(picture(), plain);  // there is no such map yet
    ok(ui->click("Brush/Create map"));
    EXPECT_TRUE(overlayShown(doc, app->brushes));
    EXPECT_NE(picture(), plain);
    for (const char* map : {"ambientOcclusion", "vegetation", "forces"}) {
        ok(ui->set("Brush/Map", map));
        ok(ui->click("Brush/Create map"));
        EXPECT_TRUE(overlayShown(doc, app->brushes)) << map;
        EXPECT_EQ(overlayOf(doc, app->brushes).map, std::string("lawn.GrassField.") + map);
    }
}

TEST_F(EditorTools, PaintingAColourMakesTheMapAndPickingFindsItAgain) {
    ok(ui->set("Brush/Map", kVegetation));
    ok(ui->set("Brush/Colour", "#8020a0"));
    ok(ui->set("Brush/Strength", "1"));
    const std::vector<uint8_t> before = picture();
    paint();
    ASSERT_TRUE(mapOf(kVegetation).present());
    EXPECT_EQ(mapOf(kVegetation).map.info().channels, 4);
    const std::vector<uint8_t> shown = picture();
    ok(ui->key("o"));
    const std::vector<uint8_t> tinted = picture();
    EXPECT_NE(tinted, shown) << "the overlay shows nothing";
    EXPECT_NE(tinted, before) << "the grass has its own colour still";
    ok(ui->set("Brush/Colour", "#000000"));
    const Rect& r = app->hand.rect;
    const auto pickAt = [&](float across) {
        moveTo(static_cast<double>(r.x + r.w * across), static_cast<double>(r.y) + static_cast<double>(r.h) * 0.8);
        ok(ui->wait(2));
        ok(ui->key("i"));
    };
    pickAt(0.45f);
    EXPECT_EQ(get("Brush/Colour"), "#8020a0");
    ok(ui->set("Brush/Colour", "#000000"));
    pickAt(0.95f);
    EXPECT_EQ(get("Brush/Colour"), "#000000") << "nothing is painted there";
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(mapOf(kVegetation).present());
    EXPECT_FALSE(doc.canUndo());
    EXPECT_EQ(picture(), before);
    ok(ui->key("ctrl+y"));
    EXPECT_EQ(picture(), tinted);
}

}  // namespace
}  // namespace sward
