// What the hand does in the viewport: strokes of all kinds of brushes, by the real mouse and modifiers.
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "editor/editor_fixture.h"
#include "tools/brush_target.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

using test::EditorTools;
using test::EditorUi;

constexpr const char* kOrientation = "lawn.GrassField.orientation";
constexpr const char* kForces = "lawn.GrassField.forces";

TEST_F(EditorUi, AStrokeInTheViewportPaintsAndIsOneUndoStep) {
    const uint64_t before = density();
    ok(ui->set("Brush/Mode", "Subtract"));
    paint();
    const uint64_t painted = density();
    EXPECT_NE(painted, before);
    EXPECT_EQ(get("Status/Saved"), "false");
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(density(), before);
    EXPECT_EQ(get("Status/Saved"), "true");
    ok(ui->key("ctrl+y"));
    EXPECT_EQ(density(), painted);
    ok(ui->key("ctrl+z"));
    ok(ui->key("ctrl+shift+z"));
    EXPECT_EQ(density(), painted);
    EXPECT_FALSE(doc.canRedo());
}

// The start screen does not fill a large window: there is nothing beside it that a hand could touch.
TEST_F(EditorUi, WhereNoProjectIsOpenTheHandFindsNothing) {
    Document none(tables());
    EditorApp empty(none, *gpu, ui::makeHeadlessSurface(2560, 1440), false);
    const auto driver = makeUiDriver(empty);
    ok(driver->wait(2));
    const Rect& r = empty.hand.rect;
    ASSERT_GT(r.w, 1500);
    for (const double x : {0.01, 0.5, 0.99})
        for (const double y : {0.01, 0.99}) {
            const double px = static_cast<double>(r.x) + static_cast<double>(r.w) * x,
                         py = static_cast<double>(r.y) + static_cast<double>(r.h) * y;
            ok(driver->drag(px, py, px + 20, py - 5));
            EXPECT_FALSE(empty.hand.ground);
        }
    for (const char* key : {"g", "f", "v", "escape", "ctrl+z", "w", "r"}) ok(driver->key(key));
    EXPECT_FALSE(none.isOpen());
    EXPECT_EQ(gpu->errors, 0) << gpu->lastError;
}

TEST_F(EditorUi, ATapIsInThePictureOfTheFrameInWhichItIsPressed) {
    ok(ui->set("Brush/Mode", "Subtract"));
    const Rect& r = app->hand.rect;
    app->queue.push({InputKind::Move, static_cast<double>(r.x + r.w / 2), static_cast<double>(r.y + r.h * 0.8f)});
    runFrame(*app);
    runFrame(*app);
    const uint64_t before = density(), revision = doc.revision();
    app->queue.push({InputKind::Button, 0, 0, 0, true});
    runFrame(*app);
    EXPECT_NE(density(), before);
    EXPECT_GT(doc.revision(), revision);
    EXPECT_EQ(app->picture.drawnRevision, doc.revision());
    app->queue.push({InputKind::Button, 0, 0, 0, false});
    runFrame(*app);
    EXPECT_FALSE(doc.stroking());
    EXPECT_EQ(app->picture.drawnRevision, doc.revision()) << "nothing is left to be drawn";
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(density(), before);
}

TEST_F(EditorTools, CombingInTheViewportLaysTheGrassTheWayTheHandGoes) {
    ok(ui->click("Tools/Comb"));
    ok(ui->set("Brush/Strength", "1"));
    paint();                                     // to the right on the screen
    ASSERT_TRUE(mapOf(kOrientation).present());  // made with the stroke
    const Rect& r = app->hand.rect;
    const auto at = pickGround(doc.project(), viewOf(app->view.camera), static_cast<int>(r.w), static_cast<int>(r.h),
                               static_cast<double>(r.w) * 0.45, static_cast<double>(r.h) * 0.8);
    ASSERT_TRUE(at);
    const glm::dvec2 size = findGround(doc.project()).terrain->size;
    const Map& map = mapOf(kOrientation).map;
    const double yaw = app->view.camera.yaw;
    EXPECT_NEAR(map.sample(at->x / size.x, at->z / size.y, 0) * 2 - 1, std::cos(yaw), 0.1);
    EXPECT_NEAR(map.sample(at->x / size.x, at->z / size.y, 1) * 2 - 1, std::sin(yaw), 0.1);
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(mapOf(kOrientation).present());
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(EditorTools, PressingInTheViewportMakesTheMapAndPushesTheWayTheHandGoes) {
    ok(ui->click("Tools/Press"));
    EXPECT_EQ(app->brushes.map, kForces);
    EXPECT_NE(get("Brush/New map").find(" x "), std::string::npos);
    ok(ui->set("Brush/Strength", "1"));
    const std::vector<uint8_t> before = picture();
    paint();  // to the right on the screen
    ASSERT_TRUE(mapOf(kForces).present());
    EXPECT_EQ(overlayOf(doc, app->brushes).map, kForces);
    const Rect& r = app->hand.rect;
    const auto at = pickGround(doc.project(), viewOf(app->view.camera), static_cast<int>(r.w), static_cast<int>(r.h),
                               static_cast<double>(r.w) * 0.45, static_cast<double>(r.h) * 0.8);
    ASSERT_TRUE(at);
    const glm::dvec2 size = findGround(doc.project()).terrain->size;
    const Map& map = mapOf(kForces).map;
    const auto channel = [&](int c) { return static_cast<double>(map.sample(at->x / size.x, at->z / size.y, c)); };
    const double yaw = app->view.camera.yaw;
    EXPECT_NEAR(channel(0) * 2 - 1, std::cos(yaw), 0.1);
    EXPECT_NEAR(channel(1) * 2 - 1, std::sin(yaw), 0.1);
    EXPECT_NEAR(channel(2), 1, 0.02);
    EXPECT_NEAR(channel(3), 1, 0.02);
    const std::vector<uint8_t> shown = picture();
    ok(ui->key("o"));
    const std::vector<uint8_t> pressed = picture();
    EXPECT_NE(pressed, shown) << "the overlay shows nothing";
    EXPECT_NE(pressed, before) << "the grass stands as before";
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(mapOf(kForces).present());
    EXPECT_FALSE(doc.canUndo());
    EXPECT_EQ(picture(), before);
    ok(ui->key("ctrl+y"));
    EXPECT_EQ(picture(), pressed);
}

TEST_F(EditorTools, CtrlShiftErasesEverySpeciesInOneStep) {
    ok(ui->click("Inspector/lawn.GrassField.species/Add species"));
    const std::string second = "lawn.GrassField.species[grass].density";
    EXPECT_EQ(mapOf(second).map.mean(), 0) << "what is new grows nowhere yet";
    ok(doc.setField(second, ""));  // everywhere
    const uint64_t before = density();
    ok(ui->set("Brush/Map", "species[lawn].density"));
    const Rect& r = app->hand.rect;
    const double y = static_cast<double>(r.y) + static_cast<double>(r.h) * 0.8;
    ok(ui->drag(static_cast<double>(r.x + r.w * 0.3f), y, static_cast<double>(r.x + r.w * 0.6f), y, "ctrl+shift"));
    EXPECT_NE(mapOf("lawn.GrassField.species[lawn].density").map.hash(), before);
    ASSERT_TRUE(mapOf(second).present());
    EXPECT_LT(mapOf(second).map.mean(), 0.99999);
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(mapOf("lawn.GrassField.species[lawn].density").map.hash(), before);
    EXPECT_FALSE(mapOf(second).present());
}

TEST_F(EditorTools, ShiftErasesWithThePreset) {
    const uint64_t before = density();
    ok(ui->click("Menu/Brush/Shift Erases"));
    EXPECT_TRUE(app->brushes.shiftErases);
    const Rect& r = app->hand.rect;
    const double y = static_cast<double>(r.y) + static_cast<double>(r.h) * 0.8;
    const double mean = mapOf("lawn.GrassField.species[lawn].density").map.mean();
    ok(ui->drag(static_cast<double>(r.x + r.w * 0.3f), y, static_cast<double>(r.x + r.w * 0.6f), y, "shift"));
    EXPECT_NE(density(), before);
    EXPECT_LT(mapOf("lawn.GrassField.species[lawn].density").map.mean(), mean);
}

TEST_F(EditorTools, AClickOutsideAnOpenMenuClosesItAndPaintsNothing) {
    const auto opened = [&] { return app->book.widgets.contains("Menu/File/New..."); };
    ok(ui->click("Menu/File"));
    ok(ui->wait(2));
    EXPECT_TRUE(opened());
    const Rect& r = app->hand.rect;
    press(static_cast<double>(r.x + r.w * 0.6f), static_cast<double>(r.y + r.h * 0.8f));
    release();
    EXPECT_FALSE(opened());
    EXPECT_EQ(app->hand.gesture, Gesture::None);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(EditorTools, AStrokeThatBeginsInTheSkyOrLeavesTheWindowPaintsTheGroundAloneAndIsOneStep) {
    const Rect r = app->hand.rect;
    const double x = static_cast<double>(r.x + r.w * 0.5f), low = static_cast<double>(r.y + r.h * 0.8f);
    const uint64_t before = density();
    press(x, static_cast<double>(r.y) + 8);
    moveTo(x, low);
    release();
    EXPECT_EQ(density(), before) << "it began beside the ground";
    ok(ui->click("Tools/Subtract"));
    press(x, low);
    for (const auto& [px, py] : {std::pair{-40.0, low}, {-1e6, -1e6}, {1e6, 1e6}, {x, -5.0}, {x, low}}) moveTo(px, py);
    release();
    EXPECT_NE(density(), before);
    EXPECT_FALSE(doc.stroking());
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(density(), before);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(EditorTools, KeysHeldWhileADialogOpensAreOfNoUseBehindIt) {
    const Rect r = app->hand.rect;
    const auto key = [&](int code, bool down) { app->queue.push({InputKind::Key, 0, 0, code, down}); };
    app->queue.push(
        {InputKind::Move, static_cast<double>(r.x + r.w / 2), static_cast<double>(r.y + r.h / 2), 0, false});
    app->queue.push({InputKind::Button, 0, 0, 1, true});
    key(GLFW_KEY_W, true);
    const glm::dvec3 start = app->view.camera.eye;
    ok(ui->wait(4));
    EXPECT_NE(app->view.camera.eye, start) << "it flies";
    app->queue.push({InputKind::Button, 0, 0, 1, false});
    key(GLFW_KEY_LEFT_CONTROL, true), key(GLFW_KEY_N, true), key(GLFW_KEY_N, false);
    ok(ui->wait(6));
    ASSERT_TRUE(ui->exists("Files/Path")) << "the dialog is open, W and Ctrl are held";
    const glm::dvec3 eye = app->view.camera.eye;
    const uint64_t painted = density();
    app->queue.push({InputKind::Button, 0, 0, 0, true});  // on the dialog's own window or beside it: not on the ground
    app->queue.push({InputKind::Button, 0, 0, 0, false});
    key(GLFW_KEY_LEFT_CONTROL, false);
    ok(ui->wait(6));
    key(GLFW_KEY_W, false);
    ok(ui->key("escape"));
    ok(ui->wait(4));
    EXPECT_FALSE(ui->exists("Files/Path"));
    EXPECT_EQ(app->view.camera.eye, eye);
    EXPECT_EQ(density(), painted);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(EditorTools, ADialogThatOpensDuringAStrokeLosesNothingOfIt) {
    const Rect r = app->hand.rect;
    const double y = static_cast<double>(r.y + r.h * 0.8f);
    const uint64_t before = density();
    ok(ui->click("Tools/Subtract"));
    press(static_cast<double>(r.x + r.w * 0.3f), y);
    moveTo(static_cast<double>(r.x + r.w * 0.5f), y);
    for (const bool down : {true, false}) {
        app->queue.push({InputKind::Key, 0, 0, down ? GLFW_KEY_LEFT_CONTROL : GLFW_KEY_N, true});
        if (!down) app->queue.push({InputKind::Key, 0, 0, GLFW_KEY_N, false});
    }
    app->queue.push({InputKind::Key, 0, 0, GLFW_KEY_LEFT_CONTROL, false});
    ok(ui->wait(6));
    moveTo(static_cast<double>(r.x + r.w * 0.6f), y);
    release();
    ok(ui->key("escape"));
    ok(ui->wait(4));
    EXPECT_FALSE(ui->exists("Files/Path"));
    EXPECT_FALSE(doc.stroking());
    EXPECT_EQ(app->hand.gesture, Gesture::None);
    EXPECT_NE(density(), before);
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(density(), before);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(EditorTools, AWindowOfOnePixelRunsAndTakesKeys) {
    app.reset();
    app = std::make_unique<EditorApp>(doc, *gpu, ui::makeHeadlessSurface(1, 1), false);
    ui = makeUiDriver(*app);
    ok(ui->wait(4));
    app->queue.push({InputKind::Move, 0, 0, 0, false});
    app->queue.push({InputKind::Button, 0, 0, 0, true});
    app->queue.push({InputKind::Button, 0, 0, 0, false});
    ok(ui->wait(4));
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(doc.stroking());
    EXPECT_FALSE(doc.canUndo());
}

}  // namespace
}  // namespace sward
