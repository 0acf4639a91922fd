// The path tool by the real mouse and keys: points added, inserted, moved and removed; each an undo step.
#include "editor/editor_fixture.h"
#include "model/field_walk.h"
#include "panels/viewport_input.h"
#include "playtest/playtest.h"
#include "world/camera_path.h"
#include "world/drawn_project.h"

namespace sward {
namespace {

class EditorPaths : public test::EditorTools {
  protected:
    void SetUp() override {
        EditorTools::SetUp();
        app->view.camera = {};
        app->view.camera.eye = {20, 14, 34};
        app->view.camera.pitch = -0.6;
        ok(ui->wait(2));
        first = snapshot(doc.project(), tables().components);
        label = doc.undoLabel();
    }
    glm::dvec2 at(double x, double y) {
        const Rect& r = app->hand.rect;
        return {static_cast<double>(r.x) + x * static_cast<double>(r.w),
                static_cast<double>(r.y) + y * static_cast<double>(r.h)};
    }
    void click(const glm::dvec2& p) { ok(ui->drag(p.x, p.y, p.x, p.y)); }
    glm::dvec2 groundUnder(const glm::dvec2& p) {
        const auto g = groundAt(doc, app->view.camera, app->hand.rect, p.x, p.y);
        EXPECT_TRUE(g);
        return g ? glm::dvec2(g->x, g->z) : glm::dvec2(0);
    }
    const GroundPath& path(const std::string& name = "path") {
        static const GroundPath none;
        const Entity e = findEntity(doc.project(), name);
        const GroundPath* p = e == kNoEntity ? nullptr : doc.project().registry.get<GroundPath>(e);
        EXPECT_TRUE(p) << name;
        return p ? *p : none;
    }
    void draw() {
        ok(ui->key("p"));
        for (const glm::dvec2& p : {at(0.3, 0.6), at(0.5, 0.5), at(0.7, 0.6)}) click(p);
    }
    glm::dvec2 middle(const std::string& widget) {
        const auto r = ui->rect(widget);
        EXPECT_TRUE(r) << (r ? "" : r.error().text());
        return r ? glm::dvec2((*r)[0] + (*r)[2], (*r)[1] + (*r)[3]) / 2.0 : glm::dvec2(0);
    }
    bool asAtFirst() { return sameProject(doc.project(), first, tables().components) && doc.undoLabel() == label; }

    Project first;
    std::string label;
};

TEST_F(EditorPaths, ClicksDrawAPathAndEachIsAnUndoStep) {
    ok(ui->click("Tools/Path"));
    EXPECT_EQ(get("Tools/Path"), "true");
    const std::vector<glm::dvec2> places{at(0.3, 0.6), at(0.5, 0.5), at(0.7, 0.6)};
    for (const glm::dvec2& p : places) click(p);
    ASSERT_EQ(path().points.size(), 3u);
    for (size_t i = 0; i < 3; ++i) EXPECT_LT(glm::length(path().points[i].at - groundUnder(places[i])), 0.002) << i;
    EXPECT_EQ(app->selection.entities, std::vector<std::string>{"path"});
    EXPECT_TRUE(ui->exists("Inspector/path.GroundPath.width"));
    EXPECT_EQ(doc.undoLabel(), "add a point to path");
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(path().points.size(), 2u);
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(doc.undoLabel(), "draw path");
    ok(ui->key("ctrl+z"));
    EXPECT_TRUE(asAtFirst());
}
TEST_F(EditorPaths, GrassAlongItGoesAndComesBackWithUndo) {
    draw();
    const auto blades = [&] { return virtualBlades(DrawnProject().of(doc.project(), tables().components)); };
    const double with = blades(), painted = virtualBlades(doc.project());
    const double area = stationsOn(groundCurve(path())).back().metres * 2;  // width and half of both falloffs
    const double perM2 = painted / (40 * 40);
    EXPECT_NEAR(painted - with, area * perM2, 0.25 * area * perM2) << "and the rounds at its ends";
    EXPECT_EQ(app->picture.drawnRevision, doc.revision());
    for (int i = 0; i < 3; ++i) ok(ui->key("ctrl+z"));
    EXPECT_EQ(blades(), painted);
}
TEST_F(EditorPaths, ADragMovesAPointAndEscapeGivesItBack) {
    draw();
    const glm::dvec2 from = middle("Viewport/Point 1"), to = at(0.5, 0.7);
    ok(ui->drag(from.x, from.y, to.x, to.y));
    EXPECT_LT(glm::length(path().points[1].at - groundUnder(to)), 0.1);
    EXPECT_EQ(doc.undoLabel(), "move point 1 of path");
    EXPECT_EQ(path().points.size(), 3u);
    ok(ui->key("ctrl+z"));
    EXPECT_LT(glm::length(path().points[1].at - groundUnder(at(0.5, 0.5))), 0.002);
    const GroundPath before = path();
    press(from.x, from.y);
    moveTo(to.x, to.y);
    EXPECT_NE(path(), before) << "live";
    ok(ui->key("escape"));
    EXPECT_EQ(path(), before);
    release();
    EXPECT_EQ(path(), before);
    EXPECT_EQ(get("Tools/Path"), "true") << "the tool stays in the hand";
}
TEST_F(EditorPaths, AClickOnTheCurveInsertsAPointThere) {
    draw();
    const CurvePiece piece = groundCurve(path()).pieces[1];
    const glm::dvec2 middleOf = placeOn(piece, 0.5);
    const auto on = projectPoint(app->view.camera, app->hand.rect, {middleOf.x, 0, middleOf.y});
    ASSERT_TRUE(on);
    click(*on);
    ASSERT_EQ(path().points.size(), 4u);
    EXPECT_LT(glm::length(path().points[2].at - middleOf), 0.1);
    EXPECT_EQ(get("Viewport/Point 2"), "true");
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(path().points.size(), 3u);
}
TEST_F(EditorPaths, DeleteRemovesTheChosenPointAndAtLastTheEntity) {
    draw();
    click(middle("Viewport/Point 1"));
    ok(ui->key("delete"));
    ASSERT_EQ(path().points.size(), 2u);
    EXPECT_EQ(doc.undoLabel(), "remove point 1 of path");
    EXPECT_LT(glm::length(path().points[1].at - groundUnder(at(0.7, 0.6))), 0.002);
    ok(ui->key("delete"));
    ok(ui->key("delete"));
    EXPECT_TRUE(path().points.empty());
    EXPECT_NE(app->messages.status.find("no points left"), std::string::npos) << app->messages.status;
    ok(ui->key("delete"));
    EXPECT_FALSE(doc.project().entities.contains("path"));
    for (int i = 0; i < 7; ++i) ok(ui->key("ctrl+z"));
    EXPECT_TRUE(asAtFirst());
}
TEST_F(EditorPaths, EnterEndsAndTheNextPathIsAnother) {
    draw();
    ok(ui->key("enter"));
    EXPECT_EQ(get("Tools/Path"), "false");
    EXPECT_EQ(app->selection.entities, std::vector<std::string>{"path"});
    click(at(0.2, 0.9));
    EXPECT_EQ(path().points.size(), 3u) << "a click chooses again";
    EXPECT_TRUE(app->selection.entities.empty());
    ok(ui->key("p"));
    click(at(0.2, 0.9));
    EXPECT_EQ(path("path-2").points.size(), 1u);
    const glm::dvec2 mid = groundUnder(at(0.5, 0.5));
    const auto on = projectPoint(app->view.camera, app->hand.rect, {mid.x, 0, mid.y});
    click(*on);
    EXPECT_EQ(app->selection.entities, std::vector<std::string>{"path"}) << "a click on another path chooses that";
    EXPECT_EQ(path().points.size(), 3u);
}
TEST_F(EditorPaths, ANewPathBeginsWhereOneLooksAndNotInTheSky) {
    ok(ui->key("shift+p"));
    ASSERT_EQ(path().points.size(), 1u);
    EXPECT_LT(glm::length(path().points[0].at - groundUnder(at(0.5, 0.5))), 0.002);
    click(at(0.6, 0.7));
    EXPECT_EQ(path().points.size(), 2u);
    ok(ui->key("ctrl+z"));
    ok(ui->key("ctrl+z"));
    EXPECT_TRUE(asAtFirst());
    app->view.camera.pitch = 0.8;
    ok(ui->wait(2));
    ok(ui->key("shift+p"));
    EXPECT_TRUE(asAtFirst());
    EXPECT_NE(app->messages.status.find("shows no terrain"), std::string::npos) << app->messages.status;
    ok(ui->key("p"));
    click(at(0.5, 0.5));
    EXPECT_TRUE(asAtFirst());
    EXPECT_NE(app->messages.status.find("there is no terrain"), std::string::npos) << app->messages.status;
}
TEST_F(EditorPaths, ACameraPathAndAWalkFollowIt) {
    draw();
    ok(ui->click("Menu/Object/Camera Path from Path"));
    const CameraPath* way = doc.project().registry.get<CameraPath>(findEntity(doc.project(), "path"));
    ASSERT_TRUE(way);
    EXPECT_NEAR(way->keys.front().eye.y, 1.7, 1e-6);
    EXPECT_NEAR(way->keys.front().eye.x, path().points[0].at.x, 1e-6);
    EXPECT_EQ(doc.undoLabel(), "camera path along path");
    const glm::dvec2 start = path().points[0].at;
    ok(ui->click("Menu/Play/Walk Along Path"));
    ASSERT_TRUE(doc.play());
    EXPECT_TRUE(doc.play()->walking());
    EXPECT_NEAR(doc.play()->state().walker.position.x, start.x, 0.5);
    doc.play()->step(60);
    EXPECT_GT(
        glm::length(glm::dvec2(doc.play()->state().walker.position.x, doc.play()->state().walker.position.z) - start),
        1.2);
    ok(ui->key("f5"));
    EXPECT_FALSE(doc.play());
}

}  // namespace
}  // namespace sward
