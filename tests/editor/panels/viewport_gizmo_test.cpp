// The gizmo in the hand, without a picture: what a drag does to the entity, how it ends, and what takes it back.
#include "panels/viewport_gizmo.h"

#include <cmath>

#include "editor/panels/panel_stage.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "panels/viewport_input.h"
#include "world/view_camera.h"

namespace sward {
namespace {

class GizmoInHand : public test::PanelStage {
  protected:
    GizmoInHand() {
        camera.eye = {20, 6, 30}, camera.pitch = -0.45;
        draw = [this] { drawGizmo(parts()); };
    }
    void SetUp() override {
        PanelStage::SetUp();
        const Solid solid{SolidKind::Box, glm::vec3(1)};
        test::writeText(doc.project().dir / "models" / "box.glb", *encodeGlb(makeMesh({&solid, 1})));
        for (const char* box : {"box", "other"}) {
            ASSERT_TRUE(doc.addEntity(box));
            ASSERT_TRUE(doc.addComponent(box, "Transform"));
            ASSERT_TRUE(doc.addComponent(box, "StaticMesh"));
            ASSERT_TRUE(doc.setField(std::string(box) + ".StaticMesh.file", "models/box.glb"));
        }
        ASSERT_TRUE(doc.setField("box.Transform.position", "[20, 0, 20]"));
        ASSERT_TRUE(doc.setField("other.Transform.position", "[22, 0, 20]"));
        selection.entities = {"box"};
        steps = doc.stepsDone();
        frames(2);
    }
    ObjectParts parts() { return {doc, selection, tool, edits, messages, camera, view, 0, active, true}; }
    glm::dvec2 grip(const std::string& part) {
        const auto found = book.widgets.find("Viewport/Gizmo " + part);
        EXPECT_NE(found, book.widgets.end()) << part;
        if (found == book.widgets.end()) return {};
        const ui::Widget& w = found->second;
        return glm::dvec2(w.x0 + w.x1, w.y0 + w.y1) / 2.0;
    }
    bool grab(const std::string& part) {
        const glm::dvec2 at = grip(part);
        FrameInput down;
        down.x = at.x, down.y = at.y;
        start = at;
        return grabGizmo(parts(), down);
    }
    void to(double dx, double dy, bool snap = false) { dragGizmo(parts(), start.x + dx, start.y + dy, snap); }
    void release() {
        releaseGizmo(parts());
        frames(2);  // the step ends with the frame
    }
    glm::dvec3 place(const std::string& entity) {
        return doc.project().registry.get<Transform>(findEntity(doc.project(), entity))->position;
    }
    Rect view{0, 30, 800, 570};
    FlyCamera camera;
    Selection selection;
    ObjectTool tool;
    glm::dvec2 start{0};
    bool active = true;
    size_t steps = 0;
};

TEST_F(GizmoInHand, AnAxisMovesAlongItAloneInOneStepThatUndoTakesBack) {
    ASSERT_TRUE(grab("move x"));
    to(30, 4);
    to(60, 8);
    EXPECT_NE(messages.status.find("move box"), std::string::npos) << messages.status;
    release();
    EXPECT_GT(place("box").x, 20.5);
    EXPECT_EQ(place("box").y, 0);
    EXPECT_EQ(place("box").z, 20);
    EXPECT_EQ(place("other"), glm::dvec3(22, 0, 20)) << "it was not chosen";
    EXPECT_EQ(doc.stepsDone(), steps + 1);
    EXPECT_EQ(doc.undoLabel(), "move box");
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(place("box"), glm::dvec3(20, 0, 20));
}

TEST_F(GizmoInHand, ThePointerMeansAHandleOnlyWhereOneIs) {
    FrameInput beside;
    beside.x = 5, beside.y = 40;
    EXPECT_FALSE(grabGizmo(parts(), beside));
    EXPECT_FALSE(tool.drag);
    FrameInput on;
    on.x = grip("move x").x, on.y = grip("move x").y;
    hoverGizmo(parts(), on, true);
    EXPECT_NE(tool.hover, nullptr);
    hoverGizmo(parts(), on, false);
    EXPECT_EQ(tool.hover, nullptr) << "the hand does something else";
}

TEST_F(GizmoInHand, TheFirstTwoPixelsAreAClick) {
    ASSERT_TRUE(grab("move x"));
    to(1.5, 0);
    release();
    EXPECT_EQ(place("box"), glm::dvec3(20, 0, 20));
    EXPECT_EQ(doc.stepsDone(), steps);
}

TEST_F(GizmoInHand, CtrlSnapsToTheGrid) {
    tool.steps.grid = 0.5f;
    ASSERT_TRUE(grab("move x"));
    to(47, 0, true);
    release();
    const double moved = (place("box").x - 20) / 0.5;
    EXPECT_GT(moved, 0.9);
    EXPECT_NEAR(moved, std::round(moved), 1e-9);
}

TEST_F(GizmoInHand, ACancelledDragLeavesNoTrace) {
    ASSERT_TRUE(grab("move x"));
    to(60, 0);
    EXPECT_NE(place("box").x, 20);
    cancelGizmo(parts());
    frames(2);
    EXPECT_EQ(place("box"), glm::dvec3(20, 0, 20));
    EXPECT_EQ(doc.stepsDone(), steps);
    EXPECT_EQ(messages.status, "everything is back where it was");
    to(90, 0);
    EXPECT_EQ(place("box"), glm::dvec3(20, 0, 20)) << "nothing is held any more";
}

TEST_F(GizmoInHand, SeveralGoTogetherByOneWay) {
    selection.entities = {"other", "box"};
    frames(2);
    ASSERT_TRUE(grab("move x"));
    to(60, 0);
    release();
    EXPECT_NEAR(place("other").x - 22, place("box").x - 20, 1e-6);
    EXPECT_GT(place("box").x, 20.5);
    EXPECT_EQ(doc.undoLabel(), "move 2 entities");
}

TEST_F(GizmoInHand, RingsTurnAndTheMiddleScales) {
    tool.mode = GizmoMode::Turn;
    frames(2);
    EXPECT_FALSE(shown("Viewport/Gizmo move x"));
    ASSERT_TRUE(grab("turn y"));
    to(40, 40);
    release();
    EXPECT_EQ(doc.undoLabel(), "turn box");
    EXPECT_NE(field("box.StaticMesh.rotationDeg"), "[0, 0, 0]");
    tool.mode = GizmoMode::Scale;
    frames(2);
    ASSERT_TRUE(grab("scale"));
    to(40, -40);
    release();
    EXPECT_EQ(doc.undoLabel(), "scale box");
    EXPECT_GT(std::stod(field("box.StaticMesh.scale")), 1);
}

TEST_F(GizmoInHand, ItIsNotDrawnBehindTheEyeForNothingNorForAnotherTool) {
    EXPECT_TRUE(shown("Viewport/Gizmo move x"));
    camera.yaw = 3.14159265;
    frames(2);
    EXPECT_FALSE(shown("Viewport/Gizmo move x")) << "behind the eye";
    camera.yaw = 0;
    selection.entities.clear();
    frames(2);
    EXPECT_FALSE(shown("Viewport/Gizmo move x")) << "nothing is chosen";
    selection.entities = {"box"};
    active = false;
    frames(2);
    EXPECT_FALSE(shown("Viewport/Gizmo move x")) << "a brush is in the hand";
}

}  // namespace
}  // namespace sward
