// What painting shows over the picture: counted in the vertices that it draws, and looked for where they lie.
#include "panels/viewport_shape.h"

#include "brushes/shape.h"
#include "editor/panels/panel_stage.h"
#include "panels/viewport_input.h"
#include "tools/brush_target.h"

namespace sward {
namespace {

class ShapeOverGround : public test::PanelStage {
  protected:
    ShapeOverGround() {
        camera.eye = {20, 25, 20}, camera.pitch = -1.5;
        hand.rect = view;
        draw = [this] {
            ImDrawList& list = *ImGui::GetWindowDrawList();
            const int before = list.VtxBuffer.Size;
            if (what) what();
            drawn.clear();
            for (int i = before; i < list.VtxBuffer.Size; ++i) drawn.push_back(list.VtxBuffer[i].pos);
        };
    }
    void SetUp() override {
        PanelStage::SetUp();
        keepTargetValid(doc, brushes);
        selectTool(doc, brushes, messages, "raise");
        hand.ground = glm::dvec3(20, 0, 20);
        const auto middle = projectPoint(camera, view, *hand.ground);
        ASSERT_TRUE(middle);
        under = *middle;
    }
    void shape() {
        what = [this] { drawBrushShape(doc, camera, hand, brushes); };
        std::vector<float> light(32 * 32);
        for (size_t i = 0; i < light.size(); ++i) light[i] = i % 32 < 16;  // its left half
        currentBrush(brushes).shape = makeShape("half", 32, 32, light);
        currentBrush(brushes).radius = 4;
    }
    // How far what was drawn reaches from the pointer, pixels: to the left, right.
    std::pair<double, double> reach() const {
        double left = 0, right = 0;
        for (const ImVec2& p : drawn) {
            left = std::max(left, under.x - static_cast<double>(p.x));
            right = std::max(right, static_cast<double>(p.x) - under.x);
        }
        return {left, right};
    }
    Rect view{0, 30, 800, 570};
    FlyCamera camera;
    ViewportHand hand;
    BrushBook brushes;
    glm::dvec2 under{0};
    std::function<void()> what;
    std::vector<ImVec2> drawn;
};

TEST_F(ShapeOverGround, ARoundBrushHasNoVeilAndAShapesLiesUnderThePointer) {
    shape();
    currentBrush(brushes).shape.reset();
    frames(2);
    EXPECT_TRUE(drawn.empty());
    shape();
    frames(2);
    ASSERT_FALSE(drawn.empty());
    EXPECT_EQ(value("Viewport/Brush shape"), "half");
    const auto [left, right] = reach();
    EXPECT_GT(left, 3 * right) << "its left half is light";
    const auto edge = projectPoint(camera, view, {16, 0, 20});
    ASSERT_TRUE(edge);
    EXPECT_NEAR(left, under.x - edge->x, 0.15 * (under.x - edge->x)) << "four metres";
}

TEST_F(ShapeOverGround, TheVeilTurnsWithTheShapesAngle) {
    shape();
    currentBrush(brushes).shapeAngleDeg = 180;
    frames(2);
    const auto [left, right] = reach();
    EXPECT_GT(right, 3 * left);
}

TEST_F(ShapeOverGround, WithoutGroundUnderThePointerOrABrushThereIsNone) {
    shape();
    hand.ground.reset();
    frames(2);
    EXPECT_TRUE(drawn.empty());
    hand.ground = glm::dvec3(20, 0, 20);
    hand.gesture = Gesture::Look;
    frames(2);
    EXPECT_TRUE(drawn.empty()) << "the hand turns the view";
    hand.gesture = Gesture::None;
    brushes.tool = kViewTool;
    frames(2);
    EXPECT_TRUE(drawn.empty()) << "no brush is in the hand";
}

TEST_F(ShapeOverGround, MirrorsDrawOneLineAnAxisAndACrossForEachImage) {
    what = [this] { drawMirror(doc, camera, hand, brushes); };
    frames(2);
    EXPECT_TRUE(drawn.empty());
    EXPECT_FALSE(shown("Viewport/Mirror"));
    hand.ground.reset();
    brushes.mirrorX = true;
    frames(2);
    const size_t one = drawn.size();
    EXPECT_TRUE(shown("Viewport/Mirror"));
    for (const ImVec2& p : drawn) EXPECT_NEAR(p.x, under.x, 4) << "the terrain's middle is x = 20 m";
    brushes.mirrorZ = true;
    frames(2);
    EXPECT_GT(drawn.size(), one);
    const size_t lines = drawn.size();
    hand.ground = glm::dvec3(15, 0, 18);
    frames(2);
    EXPECT_GT(drawn.size(), lines) << "where the images of the pointer are";
}

TEST_F(ShapeOverGround, PlacedHeightsLieOverTheirRectangleAndRiseWithThePicture) {
    Map heights({8, 8, 1, PixelType::F32});
    HeightPlace place;
    place.at = {15, 15}, place.size = {10, 10};
    camera.eye = {20, 8, 40}, camera.pitch = -0.3;
    what = [&] { drawPlacedHeights(doc, camera, view, heights, place); };
    const auto top = [&] {
        float y = 1e9f;
        for (const ImVec2& p : drawn) y = std::min(y, p.y);
        return y;
    };
    frames(2);
    ASSERT_FALSE(drawn.empty());
    const float level = top();
    const auto far = projectPoint(camera, view, {20, 0, 15});
    ASSERT_TRUE(far);
    EXPECT_NEAR(static_cast<double>(level), far->y, 4) << "level heights end at the rectangle's far side";
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) heights.set(x, y, 0, 4);
    frames(2);
    EXPECT_LT(top(), level - 40) << "four metres up";
    place.size = {0, 10};
    frames(2);
    EXPECT_TRUE(drawn.empty());
}

}  // namespace
}  // namespace sward
