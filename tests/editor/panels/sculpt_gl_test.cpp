// Sculpting by the real mouse: what follows the ground, what the status says, and straight lines.
#include <cmath>

#include "editor/editor_fixture.h"
#include "pixels.h"
#include "tools/brush_target.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

using test::EditorTools;

constexpr const char* kHeight = "ground.Terrain.height";

class Sculptor : public EditorTools {
  protected:
    double x(float share) const { return static_cast<double>(app->hand.rect.x + app->hand.rect.w * share); }
    double y(float share) const { return static_cast<double>(app->hand.rect.y + app->hand.rect.h * share); }
    std::optional<glm::dvec3> ground(float sx, float sy) {
        const Rect& r = app->hand.rect;
        return pickGround(doc.project(), viewOf(app->view.camera), static_cast<int>(r.w), static_cast<int>(r.h),
                          static_cast<double>(r.w * sx), static_cast<double>(r.h * sy));
    }
    double heightAt(const glm::dvec3& p) const { return terrainHeight(*findGround(doc.project()).terrain, p.x, p.z); }
    void take(const std::string& tool, const std::string& radius, const std::string& height = "") {
        ok(ui->click("Tools/" + tool));
        ok(ui->set("Brush/Radius", radius));
        if (!height.empty()) ok(ui->set("Brush/Height", height));
    }
    void drag(float x0, float y0, float x1, float y1, const std::string& keys = "") {
        ok(ui->drag(x(x0), y(y0), x(x1), y(y1), keys));
    }
    // By an editor that has drawn nothing before, from the same place.
    std::vector<uint8_t> pictureOpenedAnew() {
        const FlyCamera camera = app->view.camera;
        const auto project = doc.project().dir;
        ui.reset();
        app.reset();
        EXPECT_TRUE(doc.open(project));
        openEditor();
        app->view.camera = camera;
        ok(ui->click("Tools/Select"));
        return picture();
    }
};

TEST_F(Sculptor, RaisingByTheMouseMakesTheMapAndCtrlLowersAndShiftSmooths) {
    ASSERT_FALSE(mapOf(kHeight).present());
    take("Raise", "3", "0.4");
    EXPECT_EQ(app->brushes.map, kHeight);
    EXPECT_FALSE(overlayShown(doc, app->brushes)) << "ground shows itself";
    const auto at = ground(0.45f, 0.8f);
    ASSERT_TRUE(at);
    drag(0.3f, 0.8f, 0.6f, 0.8f);
    ASSERT_TRUE(mapOf(kHeight).present());
    EXPECT_EQ(mapOf(kHeight).map.info().type, PixelType::F32);
    const double raised = heightAt(*at);
    EXPECT_GT(raised, 0.4);
    EXPECT_EQ(get("Status/Saved"), "false");
    drag(0.3f, 0.7f, 0.6f, 0.7f, "shift");
    EXPECT_LT(heightAt(*at), raised);
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(heightAt(*at), raised);
    drag(0.3f, 0.8f, 0.6f, 0.8f, "ctrl");
    EXPECT_LT(heightAt(*at), raised);
    ok(ui->key("ctrl+z"));
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(mapOf(kHeight).present());
    EXPECT_FALSE(doc.canUndo());
}

// Hills with shadows, grass, and an object on the ground: all that is kept from frame to frame has to follow.
TEST_F(Sculptor, APictureAfterStrokesEqualsThatOfTheProjectSavedAndOpenedAnew) {
    ok(doc.setField("ground.Terrain.castShadows", "true"));
    ok(doc.addEntity("lake"));
    ok(doc.addComponent("lake", "Water"));
    ok(doc.setField("lake.Water.level", "-0.3"));
    take("Raise", "4", "0.6");
    const std::vector<uint8_t> flat = picture();
    drag(0.3f, 0.8f, 0.6f, 0.7f);
    picture();  // what follows is brought up to date from here
    drag(0.7f, 0.9f, 0.8f, 0.8f, "ctrl");
    take("Erode", "5");
    drag(0.3f, 0.75f, 0.6f, 0.75f);
    take("Ramp", "1");
    drag(0.5f, 0.75f, 0.8f, 0.9f);
    ok(ui->click("Tools/Select"));
    const std::vector<uint8_t> sculpted = picture();
    EXPECT_NE(sculpted, flat);
    ok(ui->key("ctrl+s"));
    EXPECT_FALSE(doc.dirty());
    EXPECT_EQ(test::difference(pictureOpenedAnew(), sculpted), "") << "something stale was drawn";
}

// The same where balls and rocks with grass on them stand on the ground and press on what grows there.
TEST_F(Sculptor, ObjectsStandOnTheGroundThatIsMadeUnderThem) {
    ASSERT_TRUE(doc.open(std::filesystem::path(SWARD_SOURCE_DIR) / "projects/rockery"));
    ASSERT_TRUE(doc.saveAs(dir / "rockery"));
    ok(ui->wait(3));
    ok(ui->click("Tools/Select"));
    const std::vector<uint8_t> before = picture();
    BrushSettings brush;
    brush.map = kHeight, brush.mode = "raise", brush.radius = 2, brush.value = 0.3f;
    const glm::dvec2 size = findGround(doc.project()).terrain->size;
    for (const double at : {0.5, 0.6, 0.45}) {
        ASSERT_TRUE(doc.beginStroke(brush, size.x * at, size.y * 0.5));
        doc.endStroke();
        picture();
    }
    const std::vector<uint8_t> sculpted = picture();
    EXPECT_NE(sculpted, before);
    ASSERT_TRUE(doc.save());
    EXPECT_EQ(test::difference(pictureOpenedAnew(), sculpted), "") << "something stale was drawn";
}

TEST_F(Sculptor, FlattenGoesToTheHeightThatIWasPressedOver) {
    take("Raise", "4", "0.5");
    drag(0.3f, 0.8f, 0.31f, 0.8f);
    const auto top = ground(0.3f, 0.8f), beside = ground(0.7f, 0.8f);
    ASSERT_TRUE(top && beside);
    take("Flatten", "2");
    EXPECT_EQ(get("Brush/From start"), "true");
    app->queue.push({InputKind::Move, x(0.3f), y(0.8f), 0, false});
    ok(ui->wait(2));
    ok(ui->key("i"));
    EXPECT_EQ(get("Brush/From start"), "false");
    EXPECT_NE(app->messages.status.find("Flatten goes to"), std::string::npos) << app->messages.status;
    ok(ui->set("Brush/Strength", "1"));
    drag(0.7f, 0.8f, 0.71f, 0.8f);
    EXPECT_NEAR(heightAt(*beside), heightAt(*top), 0.02);
}

TEST_F(Sculptor, AltShiftAndAClickGoStraightOnFromTheLastStrokesEnd) {
    take("Raise", "0.4", "0.5");
    const auto middle = ground(0.45f, 0.8f);
    ASSERT_TRUE(middle);
    ok(ui->drag(x(0.6f), y(0.8f), x(0.6f), y(0.8f), "alt+shift"));
    EXPECT_NE(app->messages.status.find("paint one first"), std::string::npos) << app->messages.status;
    EXPECT_FALSE(mapOf(kHeight).present());
    drag(0.3f, 0.8f, 0.31f, 0.8f);
    EXPECT_EQ(heightAt(*middle), 0);
    const FlyCamera camera = app->view.camera;
    ok(ui->drag(x(0.6f), y(0.8f), x(0.6f), y(0.8f), "alt+shift"));
    EXPECT_GT(heightAt(*middle), 0.1) << app->messages.status;
    EXPECT_EQ(app->view.camera.yaw, camera.yaw) << "it does not orbit";
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(heightAt(*middle), 0) << "one step";
}

TEST_F(Sculptor, TheStatusSaysWhatAClickErased) {
    ok(ui->set("Brush/Map", "species[lawn].density"));
    ok(ui->set("Brush/Radius", "4"));
    ok(ui->drag(x(0.5f), y(0.8f), x(0.5f), y(0.8f), "ctrl+shift"));
    const std::string text = get("Status/Stroke");
    EXPECT_EQ(text.substr(0, 1), "-") << text;
    ASSERT_TRUE(app->brushCost.stroke);
    EXPECT_GT(app->brushCost.stroke->removed, 1000);
    EXPECT_EQ(app->brushCost.stroke->added, 0);
}

// Ground that rises under a hand that rests would otherwise come nearer to the eye, and the stroke with it.
TEST_F(Sculptor, GroundThatRisesUnderTheHandDoesNotDrawTheStrokeAlong) {
    take("Raise", "2", "0.8");
    const auto at = ground(0.5f, 0.7f);
    ASSERT_TRUE(at);
    press(x(0.5f), y(0.7f));
    for (int i = 0; i < 6; ++i) moveTo(x(0.5f) + (i % 2), y(0.7f));
    ASSERT_TRUE(app->hand.ground);
    EXPECT_NEAR(app->hand.ground->x, at->x, 0.1);
    EXPECT_NEAR(app->hand.ground->z, at->z, 0.1);
    EXPECT_NEAR(heightAt(*at), 0.4, 0.02) << "one stamp of strength 0.5";
    release();
}

TEST_F(Sculptor, TheRingLiesOnTheGroundThatItMakesAndHeightsHaveAnOverlay) {
    take("Raise", "4", "1");
    press(x(0.5f), y(0.8f));
    ok(ui->wait(2));
    ASSERT_TRUE(app->hand.ground);
    EXPECT_GT(app->hand.ground->y, 0.2);
    EXPECT_NEAR(app->hand.ground->y, heightAt(*app->hand.ground), 1e-9);
    release();
    const std::vector<uint8_t> plain = picture();
    ok(ui->key("o"));
    EXPECT_EQ(overlayOf(doc, app->brushes).map, kHeight);
    EXPECT_NE(picture(), plain);
}

}  // namespace
}  // namespace sward
