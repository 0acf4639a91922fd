// Where the brush's decal lies, and when the scene is quick enough for it.
#include "panels/viewport_scene.h"

#include <gtest/gtest.h>

#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

TEST(ViewportDecal, LiesUnderThePointerWithTheBrushsSizeWhereItPaints) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    BrushBook brushes;
    ViewportHand hand;
    EXPECT_EQ(decalOf(doc, hand, brushes).radius, 0) << "the pointer is elsewhere";
    hand.ground = glm::dvec3(12, 0, 7);
    currentBrush(brushes).radius = 3;
    const BrushDecal decal = decalOf(doc, hand, brushes);
    EXPECT_EQ(decal.radius, 3);
    EXPECT_EQ(decal.x, 12);
    EXPECT_EQ(decal.z, 7);
    hand.gesture = Gesture::Orbit;
    EXPECT_EQ(decalOf(doc, hand, brushes).radius, 0) << "the hand turns the view";
    hand.gesture = Gesture::Paint;
    brushes.tool = kViewTool;
    EXPECT_EQ(decalOf(doc, hand, brushes).radius, 0) << "looking paints nothing";
}

TEST(ViewportDecal, IsDrawnByARendererThatNeedsNoCoarserPictureWhileThingsMove) {
    ViewportPicture picture;
    FrameClock clock;
    EXPECT_TRUE(drawsDecal(picture, clock));
    picture.resolution.movingScale = 0.5;
    EXPECT_FALSE(drawsDecal(picture, clock));
    picture.resolution.movingScale = 1;
    clock.fixed = true;
    EXPECT_FALSE(drawsDecal(picture, clock)) << "pictures without a window show no pointer";
}

}  // namespace
}  // namespace sward
