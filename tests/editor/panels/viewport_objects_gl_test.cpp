// Objects in the viewport, by the real mouse and keys: chosen, moved, copied, named, hidden, placed; and all undone.
#include "editor/editor_fixture.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "model/field_walk.h"
#include "panels/viewport_input.h"
#include "world/forest_stand.h"
#include "world/view_camera.h"

namespace sward {
namespace {

class EditorObjects : public test::EditorTools {
  protected:
    void SetUp() override {
        EditorTools::SetUp();
        const Solid box{SolidKind::Box, glm::vec3(1)};
        test::writeText(doc.project().dir / "models" / "box.glb", *encodeGlb(makeMesh({&box, 1})));
        const glm::dvec3 eye = app->view.camera.eye, ahead = forwardOf(app->view.camera);
        add("box-a", eye + glm::dvec3(ahead.x, 0, ahead.z) * 6.0);
        add("box-b", eye + glm::dvec3(ahead.x, 0, ahead.z) * 6.0 + glm::dvec3(-ahead.z, 0, ahead.x) * 2.0);
        ok(ui->click("Tools/Move"));
        ok(ui->wait(2));
        first = snapshot(doc.project(), tables().components);
        label = doc.undoLabel();
    }
    void add(const std::string& name, const glm::dvec3& at) {
        ok(doc.addEntity(name));
        ok(doc.addComponent(name, "Transform"));
        ok(doc.setField(name + ".Transform.position", fmt::format("[{}, 0, {}]", at.x, at.z)));
        ok(doc.addComponent(name, "StaticMesh"));
        ok(doc.setField(name + ".StaticMesh.file", "models/box.glb"));
    }
    glm::dvec2 middle(const std::string& widget) {
        const auto r = ui->rect(widget);
        EXPECT_TRUE(r) << (r ? "" : r.error().text());
        return r ? glm::dvec2((*r)[0] + (*r)[2], (*r)[1] + (*r)[3]) / 2.0 : glm::dvec2(0);
    }
    void click(const glm::dvec2& at, const std::string& held = "") { ok(ui->drag(at.x, at.y, at.x, at.y, held)); }
    void drag(const std::string& widget, const glm::dvec2& by, const std::string& held = "") {
        const glm::dvec2 at = middle(widget);
        ok(ui->drag(at.x, at.y, at.x + by.x, at.y + by.y, held));
    }
    glm::dvec3 placeOf(const std::string& name) {
        return doc.project().registry.get<Transform>(findEntity(doc.project(), name))->position;
    }
    bool asAtFirst() { return sameProject(doc.project(), first, tables().components) && doc.undoLabel() == label; }
    std::vector<std::string>& chosen() { return app->selection.entities; }

    using Names = std::vector<std::string>;
    Project first;
    std::string label;
};

TEST_F(EditorObjects, AClickOnATreeChoosesItsForestAndTheStatusBarSaysWhichTree) {
    ok(doc.addEntity("wood"));
    ok(doc.addComponent("wood", "Forest"));
    ok(doc.setField("wood.Forest.perHectare", "150"));
    const Forest& rule = *doc.project().registry.get<Forest>(findEntity(doc.project(), "wood"));
    std::optional<glm::dvec2> at;
    double nearest = 1e9;
    for (const StandingTree& tree : standingForest(rule, doc.ground()).trees) {
        const double away = glm::length(tree.at - app->view.camera.eye);
        const auto trunk = projectPoint(app->view.camera, app->hand.rect, tree.at + glm::dvec3(0, 1, 0));
        const Rect& r = app->hand.rect;
        if (!trunk || away > nearest || trunk->x < r.x + 20 || trunk->x > r.x + r.w - 20 || trunk->y < r.y + 20 ||
            trunk->y > r.y + r.h - 20)
            continue;
        nearest = away, at = trunk;
    }
    ASSERT_TRUE(at) << "no tree is in sight";
    click(*at);
    EXPECT_EQ(chosen(), Names{"wood"});
    EXPECT_NE(app->messages.status.find("wood: " + rule.species[0].name + ", "), std::string::npos)
        << app->messages.status;
    ASSERT_TRUE(app->objects.one);
    EXPECT_NEAR(glm::length(app->objects.one->corners[0] - app->view.camera.eye), nearest, 15) << "that tree's box";
    EXPECT_TRUE(doc.undo());
}

TEST_F(EditorObjects, AClickChoosesShiftAddsCtrlTogglesAndNothingLetsGo) {
    const glm::dvec2 a = middle("Viewport/Object box-a"), b = middle("Viewport/Object box-b");
    click(a);
    EXPECT_EQ(chosen(), Names{"box-a"});
    EXPECT_TRUE(ui->exists("Inspector/box-a.StaticMesh"));
    ok(ui->click("Tools/Select"));
    click(b, "shift");
    EXPECT_EQ(chosen(), (Names{"box-a", "box-b"}));
    click(a, "ctrl");
    EXPECT_EQ(chosen(), Names{"box-b"});
    const Rect& r = app->hand.rect;
    click({static_cast<double>(r.x) + 20, static_cast<double>(r.y + r.h) - 20});
    EXPECT_TRUE(chosen().empty());
    EXPECT_TRUE(asAtFirst()) << "choosing is no edit";
}

TEST_F(EditorObjects, ABoxOnTheScreenChoosesWhatLiesInIt) {
    const glm::dvec2 a = middle("Viewport/Object box-a"), b = middle("Viewport/Object box-b");
    const glm::dvec2 low = glm::min(a, b) - 70.0, high = glm::max(a, b) + 70.0;
    ok(ui->drag(low.x, low.y, high.x, high.y));
    EXPECT_EQ(chosen(), (Names{"box-a", "box-b"}));
    ok(ui->drag(a.x - 60, a.y - 90, a.x + 30, a.y + 40, "ctrl"));
    EXPECT_EQ(chosen(), Names{"box-b"});
}

TEST_F(EditorObjects, PickedMovedCopiedAndAllUndone) {
    click(middle("Viewport/Object box-a"));
    const glm::dvec3 before = placeOf("box-a");
    drag("Viewport/Gizmo move x", {40, 0});
    const glm::dvec3 moved = placeOf("box-a");
    EXPECT_GT(std::abs(moved.x - before.x), 0.1);
    EXPECT_EQ(moved.z, before.z);
    EXPECT_EQ(doc.undoLabel(), "move box-a");
    ok(ui->key("e"));
    drag("Viewport/Gizmo turn y", {30, 0});
    EXPECT_NE(field("box-a.StaticMesh.rotationDeg"), "[0, 0, 0]");
    ok(ui->key("r"));
    drag("Viewport/Gizmo scale", {20, -20});
    EXPECT_NE(field("box-a.StaticMesh.scale"), "1");
    ok(ui->key("ctrl+d"));
    EXPECT_EQ(chosen(), Names{"box-a-2"});
    const double aside = glm::length(placeOf("box-a-2") - moved);
    EXPECT_GE(aside, 0.29) << "it is seen beside its original";
    EXPECT_LE(aside, 2.01);
    for (const char* step : {"duplicate box-a", "scale box-a", "turn box-a", "move box-a"}) {
        EXPECT_EQ(doc.undoLabel(), step);
        ok(ui->key("ctrl+z"));
    }
    EXPECT_TRUE(asAtFirst());
}

TEST_F(EditorObjects, SeveralMoveTogetherInOneStep) {
    ok(ui->click("Outliner/box-a"));
    click(middle("Viewport/Object box-b"), "shift");
    EXPECT_EQ(chosen(), (Names{"box-a", "box-b"}));
    const glm::dvec3 apart = placeOf("box-b") - placeOf("box-a"), before = placeOf("box-a");
    drag("Viewport/Gizmo move z", {30, 10});
    EXPECT_GT(glm::length(placeOf("box-a") - before), 0.1);
    EXPECT_LT(glm::length(placeOf("box-b") - placeOf("box-a") - apart), 1.5e-3) << "to the millimetre";
    EXPECT_EQ(doc.undoLabel(), "move 2 entities");
    ok(ui->key("delete"));
    EXPECT_FALSE(doc.project().entities.contains("box-a"));
    EXPECT_FALSE(doc.project().entities.contains("box-b"));
    ok(ui->key("ctrl+z"));
    ok(ui->key("ctrl+z"));
    EXPECT_TRUE(asAtFirst());
}

TEST_F(EditorObjects, EscapeGivesTheObjectBackAndCtrlSnapsItToTheGrid) {
    click(middle("Viewport/Object box-a"));
    const glm::dvec2 at = middle("Viewport/Gizmo move x");
    press(at.x, at.y);
    moveTo(at.x + 20, at.y);
    moveTo(at.x + 40, at.y);
    EXPECT_NE(placeOf("box-a").x, first.registry.get<Transform>(findEntity(first, "box-a"))->position.x);
    ok(ui->key("escape"));
    EXPECT_TRUE(asAtFirst());
    moveTo(at.x + 60, at.y);
    release();
    EXPECT_TRUE(asAtFirst()) << "the hand has let go";
    ok(ui->set("Brush/Grid", "0.25"));
    drag("Viewport/Gizmo move x", {50, 0}, "ctrl");
    const double x = placeOf("box-a").x;
    EXPECT_NEAR(x, std::round(x * 4) / 4, 1e-9);
    ok(ui->key("ctrl+z"));
    EXPECT_TRUE(asAtFirst());
}

TEST_F(EditorObjects, TheMiddleFollowsTheGround) {
    click(middle("Viewport/Object box-a"));
    drag("Viewport/Gizmo move free", {60, 30});
    const glm::dvec3 at = placeOf("box-a");
    EXPECT_EQ(at.y, 0) << "it stands on it";
    EXPECT_GT(glm::length(at - first.registry.get<Transform>(findEntity(first, "box-a"))->position), 0.2);
}

TEST_F(EditorObjects, IconsOfLampsAreClickedAndMoved) {
    ok(doc.addEntity("lamp"));
    ok(doc.addComponent("lamp", "Transform"));
    const glm::dvec3 at = app->view.camera.eye + forwardOf(app->view.camera) * 4.0 + glm::dvec3(0, 0.8, 0);
    ok(doc.setField("lamp.Transform.position", fmt::format("[{}, {}, {}]", at.x, at.y, at.z)));
    ok(doc.addComponent("lamp", "Light"));
    ok(doc.setField("lamp.Light.type", "point"));
    ok(ui->wait(2));
    click(middle("Viewport/Icon lamp"));
    EXPECT_EQ(chosen(), Names{"lamp"});
    drag("Viewport/Gizmo move y", {0, -40});
    EXPECT_GT(placeOf("lamp").y, at.y + 0.1);
    EXPECT_NEAR(placeOf("lamp").x, at.x, 1e-12);
}

TEST_F(EditorObjects, RenamedDeletedAndHiddenByKeysAndTheContextMenu) {
    ok(ui->rightClick("Viewport/Object box-a"));
    EXPECT_EQ(chosen(), Names{"box-a"});
    ok(ui->click("Context/Rename..."));
    ok(ui->set("Rename/Name", "crate"));
    ok(ui->wait(3));
    EXPECT_EQ(chosen(), Names{"crate"});
    EXPECT_FALSE(doc.project().entities.contains("box-a"));
    ok(ui->key("h"));
    EXPECT_FALSE(app->book.widgets.contains("Viewport/Object crate"));
    EXPECT_TRUE(app->picture.drawnRevision == doc.revision());
    ok(ui->key("h"));
    EXPECT_TRUE(ui->exists("Viewport/Object crate"));
    ok(ui->rightClick("Outliner/box-b"));
    ok(ui->click("Context/Delete"));
    EXPECT_FALSE(doc.project().entities.contains("box-b"));
    for (int i = 0; i < 4; ++i) ok(ui->key("ctrl+z"));
    EXPECT_TRUE(asAtFirst());
}

TEST_F(EditorObjects, FFocusesWhatIsChosen) {
    click(middle("Viewport/Object box-b"));
    ok(ui->key("f"));
    const glm::dvec3 to = pivotOf(app->view.camera), at = placeOf("box-b");
    EXPECT_NEAR(to.x, at.x, 0.01);
    EXPECT_NEAR(to.z, at.z, 0.01);
}

TEST_F(EditorObjects, AnAssetIsPlacedByClicksUntilEscape) {
    ok(ui->click("Objects/box.glb"));
    const Rect& r = app->hand.rect;
    const glm::dvec2 low{static_cast<double>(r.x + r.w * 0.3f), static_cast<double>(r.y + r.h * 0.85f)};
    click(low);
    click(low + glm::dvec2(90, 0));
    EXPECT_TRUE(doc.project().entities.contains("box"));
    EXPECT_TRUE(doc.project().entities.contains("box-2"));
    const auto ground =
        pickGround(doc.project(), viewOf(app->view.camera), static_cast<int>(r.w), static_cast<int>(r.h),
                   low.x - static_cast<double>(r.x), low.y - static_cast<double>(r.y));
    ASSERT_TRUE(ground);
    EXPECT_NEAR(placeOf("box").x, ground->x, 1e-3);
    EXPECT_NEAR(placeOf("box").z, ground->z, 1e-3);
    EXPECT_EQ(doc.undoLabel(), "place box-2");
    ok(ui->key("escape"));
    click(low + glm::dvec2(180, 0));
    EXPECT_FALSE(doc.project().entities.contains("box-3"));
    ok(ui->key("ctrl+z"));
    ok(ui->key("ctrl+z"));
    EXPECT_TRUE(asAtFirst());
}

TEST_F(EditorObjects, AFileDroppedComesInAndIsInTheHandAndAnotherKindIsRefused) {
    const Solid ball{SolidKind::Ball, glm::vec3(0.5f), glm::vec3(0, 0.5f, 0)};
    test::writeText(dir / "desktop" / "ball.glb", *encodeGlb(makeMesh({&ball, 1})));
    test::writeText(dir / "desktop" / "photo.png", "none");
    ok(ui->drop(dir / "desktop" / "ball.glb"));
    EXPECT_EQ(app->objects.placing, "models/ball.glb");
    EXPECT_TRUE(ui->exists("Objects/ball.glb"));
    ok(ui->key("escape"));
    ok(ui->drop(dir / "desktop" / "photo.png"));
    EXPECT_EQ(app->objects.placing, "");
    EXPECT_NE(app->messages.notice.find("no glTF"), std::string::npos) << app->messages.notice;
    app->messages.notice.clear();
}

TEST_F(EditorObjects, WhatIsAddedInTheInspectorAppearsWhereOneLooks) {
    ok(ui->set("Outliner/New entity", "spot"));
    ok(ui->set("Inspector/Add component", "Transform"));
    const auto ground = pickGround(doc.project(), viewOf(app->view.camera), 2, 2, 1, 1);
    ASSERT_TRUE(ground);
    EXPECT_LT(glm::length(placeOf("spot") - *ground), 2e-3);
}

TEST_F(EditorObjects, TheOutlinerSearchesAndChoosesSeveralRows) {
    ok(ui->set("Outliner/Search", "BOX"));
    ok(ui->wait(2));
    EXPECT_TRUE(app->book.widgets.contains("Outliner/box-a"));
    EXPECT_FALSE(app->book.widgets.contains("Outliner/lawn"));
    ok(ui->set("Outliner/Search", ""));
    ok(ui->click("Outliner/box-a"));
    app->queue.push({InputKind::Key, 0, 0, 340, true});  // left Shift
    ok(ui->click("Outliner/camera"));
    app->queue.push({InputKind::Key, 0, 0, 340, false});
    ok(ui->wait(2));
    EXPECT_EQ(chosen(), (Names{"box-a", "box-b", "camera"}));
}

}  // namespace
}  // namespace sward
