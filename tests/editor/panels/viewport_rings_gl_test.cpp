// The rings in the viewport: when they are drawn, how they are dragged and let go.
#include "editor/editor_fixture.h"
#include "world/view_camera.h"

namespace sward {
namespace {

using test::EditorTools;

TEST_F(EditorTools, RingsAreDrawnOnlyWhileThePanelIsInSight) {
    EXPECT_FALSE(ui->exists("Viewport/Ring maxGeom"));
    ASSERT_TRUE(ui->get("Tiers/maxGeom"));
    EXPECT_TRUE(ui->exists("Viewport/Ring maxGeom"));
    ok(ui->set("Tiers/Rings", "false"));
    EXPECT_FALSE(app->book.widgets.count("Viewport/Ring maxGeom"));
    ok(ui->set("Tiers/Rings", "true"));
    ok(ui->click("Tabs/Console"));
    EXPECT_FALSE(app->book.widgets.count("Viewport/Ring maxGeom"));
}

TEST_F(EditorTools, ARingIsDraggedInOneStepAndPaintsNothing) {
    ok(ui->set("Tiers/maxGeom", "8"));
    const TierDistances before = tiers();
    const uint64_t grass = density();
    const auto [x, y] = grip("maxGeom");
    ok(ui->drag(x, y, x, y - 30));  // up on the screen is farther
    EXPECT_GT(tiers()[1], before[1] + 0.5);
    EXPECT_LE(tiers()[1], before[2]);
    EXPECT_EQ(tiers()[0], before[0]);
    EXPECT_EQ(density(), grass);
    const auto [x2, y2] = grip("maxGeom");
    EXPECT_NEAR(y2, y - 30, 25);  // it followed the hand, unless a neighbour stopped it
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(tiers(), before);
    ok(ui->key("ctrl+y"));
    EXPECT_GT(tiers()[1], before[1] + 0.5);
}

TEST_F(EditorTools, AClickOnARingChangesNothingAndEscapeLetsItGo) {
    ok(ui->set("Tiers/maxGeom", "8"));
    const TierDistances before = tiers();
    const auto [x, y] = grip("maxGeom");
    ok(ui->drag(x, y, x, y));
    EXPECT_EQ(tiers(), before);
    press(x, y);
    for (int i = 1; i <= 6; ++i) moveTo(x, y - 5 * i);
    EXPECT_GT(tiers()[1], before[1]);
    ok(ui->key("escape"));
    EXPECT_EQ(tiers(), before);
    moveTo(x, y - 50);
    release();
    EXPECT_EQ(tiers(), before);
    EXPECT_EQ(doc.undoLabel(), "set tiers of lawn");  // of the typed distance
    EXPECT_TRUE(app->edits.holding.empty());
}

TEST_F(EditorTools, RingsThatMeetPartTheWayTheHandGoes) {
    ok(ui->set("Tiers/minBTF", "8"));
    ok(ui->set("Tiers/maxGeom", "8"));
    const auto [x, y] = grip("maxGeom");
    ok(ui->drag(x, y, x, y - 20));
    EXPECT_EQ(tiers()[1], 8);
    EXPECT_GT(tiers()[2], 8.3);
    ok(ui->key("ctrl+z"));
    ok(ui->drag(x, y, x, y + 20));
    EXPECT_LT(tiers()[1], 7.9);
    EXPECT_EQ(tiers()[2], 8);
}

TEST_F(EditorTools, PinnedRingsStayWhereTheEyeWas) {
    ASSERT_TRUE(ui->get("Tiers/maxGeom"));
    ok(ui->set("Tiers/Pin rings", "true"));
    const glm::dvec3 eye = app->view.camera.eye;
    ASSERT_TRUE(app->tierView.pin);
    app->view.camera.pitch = -0.6;
    focus(app->view.camera, eye, 25);
    ok(ui->wait(2));
    EXPECT_EQ(*app->tierView.pin, eye);
    const auto [x, y] = grip("maxGeom");
    const auto ground = pickGround(doc.project(), viewOf(app->view.camera), static_cast<int>(app->hand.rect.w),
                                   static_cast<int>(app->hand.rect.h), x - static_cast<double>(app->hand.rect.x),
                                   y - static_cast<double>(app->hand.rect.y));
    ASSERT_TRUE(ground);
    EXPECT_NEAR(glm::length(*ground - eye), tiers()[1], 0.5);
    ok(ui->set("Tiers/Pin rings", "false"));
    EXPECT_FALSE(app->tierView.pin);
}

}  // namespace
}  // namespace sward
