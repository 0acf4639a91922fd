// Play through the editor's own keys, buttons and mouse, without a window.
#include "editor/app/play_control.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "editor/editor_fixture.h"
#include "editor/playtest/playtest.h"
#include "project/project_files.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward {
namespace {

class EditorPlay : public test::EditorFixture {
  protected:
    uint64_t hash() { return projectHash(doc.project(), doc.tables().components); }
    void key(int code, bool down) { app->queue.push({InputKind::Key, 0, 0, code, down}); }
    std::string shown() { return get("Play/State"); }
    const PlayState& state() { return doc.play()->state(); }
};

TEST_F(EditorPlay, KeysStartPauseStepAndStop) {
    EXPECT_EQ(shown(), "stopped");
    ok(ui->key("f11"));
    EXPECT_EQ(shown(), "stopped") << "there is nothing to step";
    ok(ui->key("f5"));
    EXPECT_EQ(shown(), "playing");
    const int64_t tick = state().tick;
    ok(ui->wait(30));
    EXPECT_NEAR(static_cast<double>(state().tick - tick), 30, 6) << "a frame without a window is one step";
    EXPECT_EQ(app->picture.drawnSettings.time, doc.play()->time()) << "the scene's time is the playtest's";
    ok(ui->key("f6"));
    EXPECT_EQ(shown(), "paused");
    const int64_t held = state().tick;
    ok(ui->wait(10));
    EXPECT_EQ(state().tick, held);
    ok(ui->key("f11"));
    EXPECT_EQ(state().tick, held + 1);
    ok(ui->key("f6"));
    ok(ui->wait(5));
    EXPECT_GT(state().tick, held + 1);
    ok(ui->key("f5"));
    EXPECT_EQ(shown(), "stopped");
    ok(ui->wait(1));
    EXPECT_EQ(app->picture.drawnSettings.time, 0);
}

TEST_F(EditorPlay, BladesAreCountedThoughItBeganBeforeTheFirstPicture) {
    ASSERT_TRUE(doc.open(dir / "meadow"));
    app->counts.bladesVirtual = 0;
    ASSERT_TRUE(doc.startPlay({.view = viewOf(app->view.camera)}));
    ok(ui->wait(3));
    EXPECT_EQ(shown(), "playing");
    EXPECT_EQ(app->counts.bladesVirtual, 4000.0 * 40 * 40);
}

TEST_F(EditorPlay, ButtonsAndTheMenuDoTheSame) {
    EXPECT_FALSE(ui->click("Play/Pause")) << "disabled while nothing is played";
    ok(ui->click("Play/Start"));
    EXPECT_EQ(shown(), "playing");
    captureMouse(app->play, doc, *app->surface, false);
    ok(ui->click("Play/Pause"));
    EXPECT_EQ(shown(), "paused");
    const int64_t tick = state().tick;
    ok(ui->click("Play/Step"));
    EXPECT_EQ(state().tick, tick + 1);
    ok(ui->click("Play/Start"));
    EXPECT_EQ(shown(), "stopped");
    ok(ui->click("Menu/Play/Start or Stop"));
    EXPECT_EQ(shown(), "playing");
}

TEST_F(EditorPlay, StoppingRestoresViewSelectionUndoAndUnsavedWork) {
    ok(ui->set("Inspector/lawn.HybridTiers.maxGeom", "9"));
    ok(ui->set("Brush/Mode", "Subtract"));
    paint();
    ok(ui->key("ctrl+z"));
    ok(ui->click("Outliner/sun"));
    const uint64_t before = hash(), revision = doc.revision();
    const ViewCamera view = viewOf(app->view.camera);
    const std::string undo = doc.undoLabel(), redo = doc.redoLabel(), selected = shownEntity(app->selection),
                      tool = app->brushes.tool;
    ok(ui->key("f5"));
    key(GLFW_KEY_W, true);
    ok(ui->wait(40));
    key(GLFW_KEY_W, false);
    EXPECT_GT(glm::distance(doc.play()->view().eye, view.eye), 0.3) << "it walked";
    EXPECT_EQ(hash(), before);
    ok(ui->key("f5"));
    EXPECT_EQ(hash(), before);
    EXPECT_EQ(doc.revision(), revision);
    EXPECT_TRUE(doc.dirty());
    EXPECT_EQ(doc.undoLabel(), undo);
    EXPECT_EQ(doc.redoLabel(), redo);
    EXPECT_EQ(shownEntity(app->selection), selected);
    EXPECT_EQ(app->brushes.tool, tool);
    EXPECT_EQ(viewOf(app->view.camera).eye, view.eye);
    EXPECT_EQ(viewOf(app->view.camera).target, view.target);
    ok(ui->wait(1));
    EXPECT_EQ(app->picture.drawnCamera.eye, view.eye) << "and it is seen";
}

TEST_F(EditorPlay, NothingIsSavedTakenBackOrPaintedMeanwhileAndItIsSaid) {
    ok(ui->set("Inspector/lawn.HybridTiers.maxGeom", "9"));
    ok(ui->set("Brush/Mode", "Subtract"));
    const uint64_t before = hash();
    ok(ui->key("f5"));
    for (const auto& [chord, label] :
         {std::pair("ctrl+s", "Save"), std::pair("ctrl+z", "Undo"), std::pair("ctrl+o", "Open")}) {
        ok(ui->key(chord));
        EXPECT_NE(get("Status/Message").find(label), std::string::npos) << get("Status/Message");
        EXPECT_NE(get("Status/Message").find("not while playing"), std::string::npos);
    }
    EXPECT_TRUE(playing(doc));
    paint();
    EXPECT_EQ(hash(), before);
    EXPECT_TRUE(doc.dirty());
    captureMouse(app->play, doc, *app->surface, false);
    EXPECT_FALSE(ui->click("Tools/Add")) << "greyed";
    EXPECT_FALSE(ui->set("Inspector/lawn.HybridTiers.maxGeom", "7")) << "greyed";
    ok(ui->key("f5"));
    EXPECT_EQ(hash(), before);
    ok(ui->set("Inspector/lawn.HybridTiers.maxGeom", "7"));
}

TEST_F(EditorPlay, TheMouseTurnsTheHeadUntilEscapeFreesIt) {
    ok(ui->key("f5"));
    EXPECT_TRUE(app->play.captured);
    const double yaw = doc.play()->held().yaw;
    app->queue.push({InputKind::Move, 300, 300, 0, false});
    app->queue.push({InputKind::Move, 400, 300, 0, false});
    ok(ui->wait(3));
    EXPECT_NEAR(doc.play()->held().yaw - yaw, 0.45, 1e-9) << "a hundred pixels, as when flying";
    key(GLFW_KEY_W, true);
    ok(ui->wait(3));
    EXPECT_EQ(doc.play()->held().move.y, 1);
    ok(ui->key("escape"));
    EXPECT_FALSE(app->play.captured);
    EXPECT_EQ(doc.play()->held().move.y, 0) << "with the mouse free the walker stands";
    key(GLFW_KEY_W, false);
    const Rect& r = app->hand.rect;
    const double x = static_cast<double>(r.x + r.w / 2), y = static_cast<double>(r.y + r.h / 2);
    ok(ui->drag(x, y, x + 5, y));
    EXPECT_TRUE(app->play.captured) << "a click takes it again";
}

TEST_F(EditorPlay, PressedAmidAStrokeItFinishesTheStroke) {
    ok(ui->set("Brush/Mode", "Subtract"));
    const Rect& r = app->hand.rect;
    const double y = static_cast<double>(r.y) + static_cast<double>(r.h) * 0.8;
    app->queue.push({InputKind::Move, static_cast<double>(r.x + r.w * 0.3f), y, 0, false});
    app->queue.push({InputKind::Button, 0, 0, 0, true});
    ok(ui->wait(2));
    app->queue.push({InputKind::Move, static_cast<double>(r.x + r.w * 0.5f), y, 0, false});
    ok(ui->wait(2));
    ASSERT_TRUE(doc.stroking());
    ok(ui->key("f5"));
    EXPECT_TRUE(playing(doc));
    EXPECT_FALSE(doc.stroking());
    const uint64_t painted = density();
    app->queue.push({InputKind::Button, 0, 0, 0, false});
    ok(ui->key("f5"));
    EXPECT_EQ(density(), painted);
    EXPECT_TRUE(doc.undoLabel().starts_with("Subtract lawn.GrassField.species[lawn].density, ")) << doc.undoLabel();
}

TEST_F(EditorPlay, AHalfTypedValueAndADraggedSliderAreNotLost) {
    const std::string path = "lawn.HybridTiers.maxGeom", label = "Inspector/" + path;
    ASSERT_TRUE(ui->get(label));
    const ui::Widget w = app->book.widgets.at(label);
    const double x = static_cast<double>(w.x0 + w.x1) / 2, y = static_cast<double>(w.y0 + w.y1) / 2;
    key(GLFW_KEY_LEFT_CONTROL, true);
    app->queue.push({InputKind::Move, x, y, 0, false});
    app->queue.push({InputKind::Button, 0, 0, 0, true});
    app->queue.push({InputKind::Button, 0, 0, 0, false});
    key(GLFW_KEY_LEFT_CONTROL, false);
    ok(ui->wait(8));
    app->queue.push({InputKind::Char, 0, 0, '7', false});
    ok(ui->wait(2));
    ok(ui->key("f5"));
    EXPECT_FALSE(playing(doc));
    EXPECT_NE(get("Status/Message").find("typing"), std::string::npos) << get("Status/Message");
    ok(ui->key("enter"));
    EXPECT_EQ(field(path), "7");

    app->queue.push({InputKind::Move, x, y, 0, false});
    app->queue.push({InputKind::Button, 0, 0, 0, true});
    ok(ui->wait(3));
    app->queue.push({InputKind::Move, x + 20, y, 0, false});
    ok(ui->wait(3));
    const std::string dragged = field(path);
    EXPECT_NE(dragged, "7");
    ok(ui->key("f5"));
    EXPECT_FALSE(playing(doc));
    app->queue.push({InputKind::Button, 0, 0, 0, false});
    ok(ui->wait(3));
    EXPECT_EQ(field(path), dragged);
    ok(ui->key("f5"));
    EXPECT_TRUE(playing(doc));
}

TEST_F(EditorPlay, ClosingTheProgramStopsItAndAsksForUnsavedWork) {
    ok(ui->set("Inspector/lawn.HybridTiers.maxGeom", "9"));
    ok(ui->key("f5"));
    ok(ui->key("ctrl+q"));
    EXPECT_FALSE(playing(doc));
    EXPECT_FALSE(app->quit);
    ok(ui->click("Unsaved/Save"));
    EXPECT_TRUE(app->quit);
    EXPECT_FALSE(doc.dirty());
}

}  // namespace
}  // namespace sward
