// What a person does to an editor that it was not made for: nothing crashes, nothing is lost, and it is said.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "editor/editor_fixture.h"
#include "scene/ground_path.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, AFileThatIsNotWhatItSaysIsRefusedAndNothingComesIn) {
    test::writeText(dir / "bench.glb", "this is no object");
    test::writeText(dir / "empty.gltf", "");
    for (const char* name : {"bench.glb", "empty.gltf"}) {
        ok(ui->drop(dir / name));
        EXPECT_NE(app->messages.notice.find(name), std::string::npos) << app->messages.notice;
        app->messages.notice.clear();
    }
    EXPECT_FALSE(doc.dirty());
    EXPECT_EQ(app->objects.placing, "");
    EXPECT_FALSE(std::filesystem::exists(dir / "meadow" / "models" / "bench.glb"));
}

TEST_F(EditorUi, KeysThatAreHeldWhileADialogOpensFlyNoFarther) {
    const Rect& r = app->hand.rect;
    app->queue.push(
        {InputKind::Move, static_cast<double>(r.x + r.w / 2), static_cast<double>(r.y + r.h / 2), 0, false});
    ok(ui->wait(2));
    app->queue.push({InputKind::Button, 0, 0, 1, true});
    app->queue.push({InputKind::Key, 0, 0, GLFW_KEY_W, true});
    const glm::dvec3 before = app->view.camera.eye;
    ok(ui->wait(5));
    EXPECT_NE(app->view.camera.eye, before) << "it flies";
    openPalette(app->palette);
    ok(ui->wait(4));
    EXPECT_EQ(app->hand.gesture, Gesture::None);
    const glm::dvec3 held = app->view.camera.eye;
    ok(ui->wait(5));
    EXPECT_EQ(app->view.camera.eye, held);
    app->queue.push({InputKind::Key, 0, 0, GLFW_KEY_W, false});
    app->queue.push({InputKind::Button, 0, 0, 1, false});
    ok(ui->key("escape"));
    ok(ui->wait(3));
}

TEST_F(EditorUi, ADialogThatOpensEndsTheStrokeAsOneStep) {
    ok(ui->click("Tools/Subtract"));
    const Rect& r = app->hand.rect;
    const double x = static_cast<double>(r.x + r.w / 2), y = static_cast<double>(r.y + r.h * 0.8f);
    app->queue.push({InputKind::Move, x, y, 0, false});
    ok(ui->wait(2));
    app->queue.push({InputKind::Button, 0, 0, 0, true});
    app->queue.push({InputKind::Move, x + 40, y, 0, false});
    ok(ui->wait(4));
    EXPECT_TRUE(doc.stroking());
    openPalette(app->palette);
    ok(ui->wait(6));
    EXPECT_FALSE(doc.stroking());
    EXPECT_EQ(doc.stepsDone(), 1u);
    app->queue.push({InputKind::Button, 0, 0, 0, false});
    ok(ui->key("escape"));
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(doc.dirty());
}

TEST_F(EditorUi, AWindowOfOnePointIsOutlived) {
    EditorApp small(doc, *gpu, ui::makeHeadlessSurface(1, 1), false);
    for (int i = 0; i < 5; ++i) runFrame(small);
    small.layout.tab = "Accuracy";
    for (int i = 0; i < 3; ++i) runFrame(small);
    EXPECT_EQ(small.messages.notice, "");
}

TEST_F(EditorUi, UndoWhileOcclusionIsBakedLeavesThePresentScene) {
    const test::EmptyCache cache;
    ASSERT_TRUE(doc.setField("sun.Light.elevationDeg", "20"));
    ok(ui->click("Menu/Bake/Ambient Occlusion"));
    ASSERT_TRUE(app->background.occlusion);
    ok(ui->key("ctrl+z"));
    waitUntil([&] { return !app->background.occlusion; });
    EXPECT_FALSE(app->background.occlusion);
    EXPECT_NE(field("sun.Light.elevationDeg"), "20");
    EXPECT_TRUE(doc.canUndo()) << "the sun does not move occlusion: the map came as one step";
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(doc.dirty());
}

TEST_F(EditorUi, APathOfOnePointIsDrawnWalkedAndFlattenedOrSaidToBeNone) {
    GroundPath path;
    path.points = {{"only", {10, 10}}};
    ASSERT_TRUE(doc.addEntity("spot"));
    ASSERT_TRUE(doc.assignComponent("spot", *findComponent(doc.tables().components, "GroundPath"), &path));
    choose(app->selection, "spot");
    ok(ui->wait(3));
    ok(ui->click("Menu/Object/Flatten Along Path"));
    ok(ui->click("Menu/Object/Camera Path from Path"));
    app->messages.notice.clear();
    ok(ui->wait(3));
    EXPECT_EQ(findEntity(doc.project(), "spot") == kNoEntity, false);
}

}  // namespace
}  // namespace sward
