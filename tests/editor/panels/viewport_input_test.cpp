// What the hand does in the viewport, with nothing but the parts it touches: no window, no picture.
#include "panels/viewport_input.h"

#include "editor/panels/panel_stage.h"
#include "tools/brush_target.h"
#include "world/view_camera.h"

namespace sward {
namespace {

const Rect kView{100, 50, 400, 300};

TEST(ViewportRays, AWorldPointIsSeenWhereItsRayGoes) {
    FlyCamera camera;
    camera.eye = {3, 2, 1}, camera.yaw = 0.7, camera.pitch = -0.3;
    for (const auto& [x, y] : {std::pair{300.0, 200.0}, {110.0, 60.0}, {450.0, 330.0}}) {
        const glm::dvec3 ray = rayThrough(camera, kView, x, y);
        EXPECT_NEAR(glm::length(ray), 1, 1e-12);
        const auto at = projectPoint(camera, kView, camera.eye + ray * 12.0);
        ASSERT_TRUE(at);
        EXPECT_NEAR(at->x, x, 1e-6);
        EXPECT_NEAR(at->y, y, 1e-6);
        EXPECT_FALSE(projectPoint(camera, kView, camera.eye - ray * 12.0)) << "behind the eye";
    }
}

class HandInViewport : public test::PanelStage {
  protected:
    HandInViewport() {
        hand.rect = kView;
        camera.eye = {20, 4, 20}, camera.pitch = -1.2;
        draw = [this] {
            const RingParts rings{doc, tiers, camera, hand.rect, 500, "", false};
            const ObjectParts objects{
                doc, selection, tool, edits, messages, camera, hand.rect, 0, brushes.tool == kViewTool};
            viewportInput({in, 1.0 / 60, true}, camera, hand,
                          {{doc, brushes, edits, messages}, rings, objects, comparison});
        };
    }
    void SetUp() override {
        PanelStage::SetUp();
        keepTargetValid(doc, brushes);
    }
    void move(double x, double y) { queue.push({InputKind::Move, x, y, 0, false}); }
    void button(int code, bool down) { queue.push({InputKind::Button, 0, 0, code, down}); }
    FlyCamera camera;
    ViewportHand hand;
    BrushBook brushes;
    TierView tiers;
    Selection selection;
    ObjectTool tool;
    Comparison comparison;
};

TEST_F(HandInViewport, TheRightButtonTurnsTheEyeInItsPlace) {
    const glm::dvec3 eye = camera.eye;
    const double yaw = camera.yaw;
    move(300, 200), button(1, true);
    frames(2);
    EXPECT_EQ(hand.gesture, Gesture::Look);
    move(350, 200);
    frames(2);
    button(1, false);
    frames(2);
    EXPECT_GT(camera.yaw, yaw);
    EXPECT_EQ(camera.eye, eye);
    EXPECT_EQ(hand.gesture, Gesture::None);
}

TEST_F(HandInViewport, TheLeftButtonPaintsOneStroke) {
    brushes.tool = "subtract";
    move(250, 200), button(0, true);
    frames(2);
    EXPECT_EQ(hand.gesture, Gesture::Paint);
    move(350, 210);
    frames(2);
    button(0, false);
    frames(2);
    while (doc.pumpStroke(0)) {
    }
    EXPECT_TRUE(doc.undoLabel().starts_with("Subtract lawn.GrassField.species[lawn].density, ")) << doc.undoLabel();
    ASSERT_TRUE(doc.undo());
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(HandInViewport, WithTheSelectToolNothingIsPainted) {
    brushes.tool = kViewTool;
    move(250, 200), button(0, true);
    frames(2);
    EXPECT_EQ(hand.gesture, Gesture::Choose);
    EXPECT_TRUE(hand.ground) << "the pointer is over the ground";
    EXPECT_FALSE(doc.stroking());
}

TEST_F(HandInViewport, WithoutAMapItIsSaidWhatToDo) {
    ASSERT_TRUE(doc.removeEntity("lawn"));
    brushes.map.clear();
    move(250, 200), button(0, true);
    frames(2);
    EXPECT_NE(messages.notice.find("add a GrassField"), std::string::npos) << messages.notice;
}

TEST_F(HandInViewport, WhileItIsPlayedAClickAsksForTheMouseAlone) {
    hand.flying = true;
    FrameInput click;
    click.pressed[0] = true;
    EXPECT_TRUE(playInput({click, 0, true}, hand));
    EXPECT_FALSE(hand.flying);
    EXPECT_FALSE(playInput({click, 0, false}, hand)) << "beside the picture";
    EXPECT_FALSE(playInput({{}, 0, true}, hand));
}

}  // namespace
}  // namespace sward
