// The line between two pictures: where it stops, and who may take it.
#include "panels/viewport_compare.h"

#include "editor/panels/panel_stage.h"

namespace sward {
namespace {

class SplitLine : public test::PanelStage {
  protected:
    SplitLine() {
        hand.rect = {100, 50, 400, 300};
        comparison.against = Against::Flat;
        draw = [this] { hoverSplit(comparison, hand, in, true); };
    }
    void pointTo(double x, double y) {
        queue.push({InputKind::Move, x, y, 0, false});
        frames(2);
    }
    ViewportHand hand;
    Comparison comparison;
};

TEST_F(SplitLine, StopsAtThePicturesEdges) {
    dragSplit(comparison, hand.rect, 200);
    EXPECT_FLOAT_EQ(comparison.split, 0.25f);
    dragSplit(comparison, hand.rect, -50);
    EXPECT_EQ(comparison.split, 0);
    dragSplit(comparison, hand.rect, 5000);
    EXPECT_EQ(comparison.split, 1);
}

TEST_F(SplitLine, IsTakenByItsGripAloneAndWithoutModifiers) {
    pointTo(300, 200);
    EXPECT_TRUE(grabSplit(comparison, in));
    FrameInput shifted = in;
    shifted.keys[GLFW_KEY_LEFT_SHIFT] = true;
    EXPECT_FALSE(grabSplit(comparison, shifted));
    pointTo(300, 260);
    EXPECT_FALSE(grabSplit(comparison, in)) << "the rest of the line takes no clicks";
    comparison.against = Against::Off;
    pointTo(300, 200);
    EXPECT_FALSE(grabSplit(comparison, in)) << "there is no line";
}

TEST_F(SplitLine, AGripInTheHandGoesWithItsLine) {
    hand.gesture = Gesture::Split;
    releaseSplit(comparison, hand);
    EXPECT_EQ(hand.gesture, Gesture::Split);
    comparison.against = Against::Off;
    releaseSplit(comparison, hand);
    EXPECT_EQ(hand.gesture, Gesture::None);
    hand.gesture = Gesture::Paint;
    releaseSplit(comparison, hand);
    EXPECT_EQ(hand.gesture, Gesture::Paint);
}

}  // namespace
}  // namespace sward
