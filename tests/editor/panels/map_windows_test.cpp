// The list of what is wrong with maps, whose lines fly there; and heights that are placed once they are accepted.
#include "panels/map_windows.h"

#include "editor/panels/panel_stage.h"
#include "maps/map_io.h"
#include "model/layer_edits.h"
#include "tools/camera_control.h"
#include "world/ground.h"

namespace sward {
namespace {

class MapWindows : public test::PanelStage {
  protected:
    std::string slope() {
        Map ramp({64, 64, 1, PixelType::U16});
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) ramp.set(x, y, 0, static_cast<float>(x) / 63);
        EXPECT_TRUE(writeMap(dir / "slope.png", ramp));
        return (dir / "slope.png").string();
    }
    Status place(const std::string& file, bool flipX) {
        Status ended;
        beginPlacing(placing, doc, waiting, file, flipX, false, [&](const Status& s) { ended = s; });
        return ended;
    }
    double height(double x, double z) { return terrainHeight(*findGround(doc.project()).terrain, x, z); }
    MapHealthView health;
    HeightPlacing placing;
    FlyCamera camera;
};

TEST_F(MapWindows, ALineOfAFindingFliesToWhereItIsWorst) {
    name = "Map health";
    draw = [this] { drawMapHealth(health, doc, camera, edits, waiting); };
    Map cut({256, 256, 1, PixelType::U16});
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            cut.set(x, y, 0, x > 200 && y > 200 ? 1.0f : 0.3f + 0.001f * static_cast<float>((x * 7 + y * 3) % 500));
    ASSERT_TRUE(doc.setMap("ground.Terrain.height", cut, "heights"));
    checkMaps(health, doc, waiting);
    ASSERT_FALSE(health.findings.empty());
    EXPECT_FALSE(health.findings[0].meant) << "faults come first";
    frames(3);
    EXPECT_NE(value("Map health/0/Line").find("cut off"), std::string::npos) << value("Map health/0/Line");
    EXPECT_NE(value("Map health/Told").find("1 fault"), std::string::npos) << value("Map health/Told");
    click("Map health/0/Go");
    const glm::dvec3 looked = camera.eye + forwardOf(camera) * 12.0;
    EXPECT_NEAR(looked.x, health.findings[0].worst.x, 0.01);
    EXPECT_NEAR(looked.z, health.findings[0].worst.y, 0.01);
    EXPECT_GT(health.findings[0].worst.x, 31);
    ASSERT_TRUE(doc.undo());
    frames(2);
    EXPECT_NE(value("Map health/Told").find("changed since"), std::string::npos);
    click("Map health/Check again");
    EXPECT_TRUE(health.findings.empty() || health.findings[0].meant);
    click("Map health/Close");
    EXPECT_FALSE(health.open);
}

TEST_F(MapWindows, HeightsAreTakenByAcceptAndDroppedByCancel) {
    name = "Place heights";
    draw = [this] { drawHeightPlacing(placing, doc, edits, messages, waiting); };
    EXPECT_FALSE(place((dir / "none.png").string(), false));
    ASSERT_TRUE(place(slope(), false));
    EXPECT_EQ(placing.place.at, glm::dvec2(10, 10));
    EXPECT_EQ(placing.place.size, glm::dvec2(20, 20));
    const size_t steps = doc.stepsDone();
    frames(3);
    click("Place heights/Cancel");
    EXPECT_TRUE(placing.file.empty());
    EXPECT_EQ(doc.stepsDone(), steps);
    ASSERT_TRUE(place(slope(), true));
    placing.place.low = 1, placing.place.high = 5;
    frames(3);
    click("Place heights/Accept");
    EXPECT_TRUE(placing.file.empty()) << placing.error;
    EXPECT_EQ(doc.stepsDone(), steps + 1);
    EXPECT_NEAR(height(20, 20), 3, 0.1);
    EXPECT_GT(height(14, 20), height(26, 20)) << "flipped";
    ASSERT_TRUE(place(slope(), false));
    placing.place.at = {500, 0};
    frames(3);
    click("Place heights/Accept");
    frames(2);
    EXPECT_NE(value("Place heights/Error").find("beside the terrain"), std::string::npos);
}

TEST_F(MapWindows, PlacedHeightsSayThatTheyGoBelowLayers) {
    name = "Place heights";
    draw = [this] { drawHeightPlacing(placing, doc, edits, messages, waiting); };
    ASSERT_TRUE(place(slope(), false));
    frames(2);
    EXPECT_FALSE(shown("Place heights/Below"));
    ASSERT_TRUE(addLayer(doc, "ground.Terrain.height", LayerKind::Rule));
    frames(2);
    EXPECT_EQ(value("Place heights/Below"), "below 1 layer");
}

TEST_F(MapWindows, TheListOfFindingsLiesWithinASmallWindow) {
    name = "Map health";
    float right = 1e9f, low = 1e9f;
    draw = [&] {
        drawMapHealth(health, doc, camera, edits, waiting);
        ImGui::Begin("Map health");  // the same window once more
        right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
        low = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
        ImGui::End();
    };
    checkMaps(health, doc, waiting);
    frames(3);
    EXPECT_LE(right, 800);
    EXPECT_LE(low, 600);
}

}  // namespace
}  // namespace sward
