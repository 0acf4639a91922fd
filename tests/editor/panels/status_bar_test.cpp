// The status bar: large numbers shortly, and what a stroke adds.
#include "app/background_work.h"
#include "app/stroke_timing.h"
#include "app/viewport.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"
#include "tools/brush_cost.h"

namespace sward {
namespace {

TEST(Counted, HasThreeDigitsAndALetterFromTenThousandOn) {
    EXPECT_EQ(counted(0), "0");
    EXPECT_EQ(counted(9999), "9999");
    EXPECT_EQ(counted(12345), "12.3 k");
    EXPECT_EQ(counted(627'000'000), "627 M");
    EXPECT_EQ(counted(5'000'000'000), "5 G");
}

class StatusBar : public test::PanelStage {
  protected:
    StatusBar() {
        draw = [this] { drawStatusBar(doc, counts, 0.25, cost, timing, work, "ready"); };
    }
    ViewCounts counts;
    BrushCost cost;
    StrokeTiming timing;
    BackgroundWork work;
    float width = 780;
};

TEST_F(StatusBar, SaysWhatIsDrawnHowFineAndWhetherItIsSaved) {
    counts.bladesVirtual = 3'200'000, counts.populationRevision = doc.revision();
    counts.lastMs = 12.345;
    frames(2);
    EXPECT_EQ(value("Panel/Blades"), "3.2 M");
    EXPECT_EQ(value("Panel/Frame"), "12.3 ms");
    EXPECT_EQ(value("Panel/Resolution"), "25 %");
    EXPECT_EQ(value("Panel/Saved"), "true");
    EXPECT_EQ(value("Panel/Message"), "ready");
    EXPECT_FALSE(shown("Panel/Visible")) << "nothing was counted";
    ASSERT_TRUE(doc.addEntity("second"));
    counts.lastMs = 2500;
    frames(2);
    EXPECT_EQ(value("Panel/Saved"), "false");
    EXPECT_EQ(value("Panel/Frame"), "2.5 s");
}

TEST_F(StatusBar, SaysWhatAStrokeAddsAndItsTimeOnceThatWasMeasured) {
    frames(2);
    EXPECT_FALSE(shown("Panel/Stroke"));
    cost.stroke = BladeChange{0, 120};
    frames(2);
    EXPECT_EQ(value("Panel/Stroke"), "-120 blades");
    cost.stroke = BladeChange{1000, 0}, cost.grassMs = 8, counts.stats.bladesGeometry = 4000;
    frames(2);
    EXPECT_EQ(value("Panel/Stroke"), "+1000 blades, about +2 ms");
    timing.ms = PairedDifference{0.8, 0.6, 1.1, 0.984, 7}, timing.blades = PairedDifference{900, 900, 900, 0.984, 7};
    frames(2);
    EXPECT_EQ(value("Panel/Stroke"), "+1000 blades, +0.80 ms (0.60 to 1.1)") << "measured, no longer an estimate";
    cost.stroke.reset();
    frames(2);
    EXPECT_EQ(value("Panel/Stroke"), "+0.80 ms (0.60 to 1.1)") << "heights have no blades to count";
}

TEST_F(StatusBar, TellsWhatIsMadeBeside) {
    work.making = {{"slices of clover", 0.4}};
    frames(2);
    EXPECT_EQ(value("Panel/Making"), "slices of clover 40 %");
}

TEST_F(StatusBar, BladesAreNotNoneWhileTheyAreNotCounted) {
    frames(2);
    EXPECT_EQ(value("Panel/Blades"), "...");
}

TEST_F(StatusBar, WhatFindsNoRoomGivesWayToTheMessage) {
    counts.populationRevision = doc.revision();
    draw = [this] {
        ImGui::BeginChild("narrow", {width, 40});
        drawStatusBar(doc, counts, 1, cost, timing, work, std::string(200, 'm'));
        ImGui::EndChild();
    };
    frames(2);
    EXPECT_TRUE(book.widgets.at("Panel/Resolution").visible);
    width = 420;
    frames(2);
    EXPECT_FALSE(book.widgets.at("Panel/Resolution").visible);
    EXPECT_EQ(value("Panel/Resolution"), "100 %") << "scripts find it";
    EXPECT_TRUE(book.widgets.at("Panel/Frame").visible);
    EXPECT_LT(book.widgets.at("Panel/Message").x1, 440) << "it ends in dots";
}

}  // namespace
}  // namespace sward
