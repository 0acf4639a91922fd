// The Tiers panel: distances typed and dragged, what else it sets.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorTools;

TEST_F(EditorTools, ATypedDistancePushesTheOthersInOneStep) {
    const TierDistances before = tiers();
    ok(ui->set("Tiers/maxGeom", "50"));
    EXPECT_EQ(tiers()[1], 50);
    EXPECT_TRUE(tiersInOrder(tiers()));
    EXPECT_EQ(get("Tiers/minBTF"), "50");
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(tiers(), before);
    EXPECT_FALSE(doc.canUndo());
    EXPECT_FALSE(ui->set("Tiers/maxGeom", "-2"));
    EXPECT_FALSE(ui->set("Tiers/maxGeom", "far"));
    EXPECT_EQ(tiers(), before);
    ok(ui->set("Tiers/maxGeom", "inf"));
    EXPECT_EQ(get("Tiers/maxBTF"), "inf");
}

TEST_F(EditorTools, ADraggedDistanceStopsAtItsNeighboursInOneStep) {
    const TierDistances before = tiers();
    ASSERT_TRUE(ui->get("Tiers/maxGeom"));
    const auto r = ui->rect("Tiers/maxGeom");
    ASSERT_TRUE(r);
    const double y = ((*r)[1] + (*r)[3]) / 2, x = ((*r)[0] + (*r)[2]) / 2;
    ok(ui->drag(x, y, (*r)[2] + 40, y));
    EXPECT_EQ(tiers()[1], before[2]);
    EXPECT_EQ(tiers()[2], before[2]);
    ok(ui->drag(x, y, (*r)[0] - 40, y));
    EXPECT_NEAR(tiers()[1], before[0] + kTierGap, 1e-6);
    ok(ui->key("ctrl+z"));
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(tiers(), before);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(EditorTools, ThePanelSetsTechniqueFadeSlicesAndTheView) {
    ok(ui->set("Tiers/technique", "geometry"));
    EXPECT_EQ(field("lawn.GrassField.technique"), "geometry");
    ok(ui->set("Tiers/fade", "0.25"));
    EXPECT_EQ(field("lawn.GrassDrawing.fade"), "0.25");
    ok(ui->set("Tiers/slices", "6"));
    EXPECT_EQ(field("lawn.GrassSlices.slices"), "6");
    ok(ui->set("Tiers/False colours", "true"));
    EXPECT_EQ(app->view.mode, ViewMode::Tiers);
    ok(ui->set("Tiers/False colours", "false"));
    EXPECT_EQ(app->view.mode, ViewMode::Final);
    EXPECT_TRUE(ui->exists("Tiers/Blades"));
    ok(ui->set("Tiers/Measure", "true"));
    ok(ui->wait(3));
    EXPECT_NE(get("Tiers/Passes").find(" ms"), std::string::npos);
}

TEST_F(EditorTools, DistancesOutOfOrderAreOfferedToBePutInOrder) {
    EXPECT_FALSE(ui->exists("Tiers/Put in order"));
    ASSERT_TRUE(doc.setField("lawn.HybridTiers.minGeom", "30"));
    ok(ui->click("Tiers/Put in order"));
    EXPECT_TRUE(tiersInOrder(tiers()));
    EXPECT_EQ(tiers()[0], 12);
}

// By pixels nothing moves until the picture or a distance does; what is dragged or typed in metres turns pixels.
TEST_F(EditorTools, DistancesFollowThePictureWhereTheyAreByPixels) {
    const TierDistances before = tiers();
    const auto shown = [&](size_t i) { return std::stod(get(std::string("Tiers/") + kTierFields[i])); };
    ok(ui->set("Tiers/tiersBy", "pixels"));
    EXPECT_EQ(field("lawn.HybridTiers.tiersBy"), "pixels");
    for (size_t i = 0; i < kTierCount; ++i) EXPECT_NEAR(shown(i), before[i], 1e-3 * before[i]) << kTierFields[i];
    const double wide = std::stod(get("Tiers/bladePixels")), lens = app->view.camera.fovDeg;
    EXPECT_NE(get("Viewport/Ring maxBTF").find(" px high"), std::string::npos) << "rings show both";
    app->view.camera.fovDeg = lens / 2;  // a longer lens sees the same blade farther away
    ok(ui->wait(2));
    const double longer = std::tan(lens * 0.00872664626) / std::tan(lens * 0.00436332313);
    EXPECT_NEAR(shown(1), before[1] * longer, 1e-3 * shown(1));
    EXPECT_NEAR(shown(0) / shown(1), before[0] / before[1], 1e-3);
    ok(ui->set("Tiers/maxGeom", fmt::format("{}", shown(1) / 2)));
    EXPECT_NEAR(std::stod(get("Tiers/bladePixels")), 2 * wide, 0.01 * wide);
    app->view.camera.fovDeg = lens;
    ok(ui->wait(2));
    EXPECT_NEAR(shown(1), before[1] / 2, 1e-2 * before[1]);
    ok(ui->set("Tiers/tiersBy", "metres"));
    EXPECT_NEAR(tiers()[1], before[1] / 2, 1e-2 * before[1]);
    EXPECT_FALSE(ui->exists("Tiers/bladePixels"));
    for (int i = 0; i < 3; ++i) ok(ui->key("ctrl+z"));
    EXPECT_EQ(tiers(), before);
    EXPECT_FALSE(doc.canUndo());
}

}  // namespace
}  // namespace sward
