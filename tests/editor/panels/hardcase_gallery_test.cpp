// The tab Hard Cases: its list, the slider, the graphs and the formula's text.
#include "panels/hardcase_gallery.h"

#include "app/frame_clock.h"
#include "editor/panels/panel_stage.h"

namespace sward::test {
namespace {

struct HardCasePanel : PanelStage {
    HardCasePanel() {
        name = "Hard Cases";
        draw = [this] {
            followHardCases(run, nullptr, clock);
            ImGui::BeginChild("room", {width, 0});
            drawHardCases(run, edits);
            ImGui::EndChild();
        };
    }
    std::string labelOf(const std::string& key) const {
        for (const HardCase& h : run.cases)
            if (h.key == key) return key + "  " + h.row.name;
        return "no case " + key;
    }
    HardCaseRun run;
    FrameClock clock;
    float width = 0;
};

TEST_F(HardCasePanel, ListsEveryCaseWithItsVerdict) {
    frames(90);
    for (const HardCase& h : run.cases) {
        EXPECT_TRUE(shown("Hard Cases/" + labelOf(h.key))) << h.key;
        EXPECT_EQ(value("Hard Cases/" + h.key + "/Verdict"), "ok") << h.key;
    }
    run.results[0].pass = false;
    frames();
    EXPECT_EQ(value("Hard Cases/B-1/Verdict"), "failing");
}

TEST_F(HardCasePanel, AClickShowsACaseItsNumbersAndWhatGoesWrong) {
    frames(6);
    EXPECT_NE(value("Hard Cases/Here").find("as printed NaN"), std::string::npos) << value("Hard Cases/Here");
    EXPECT_NE(value("Hard Cases/Here").find("ours 0"), std::string::npos);
    click("Hard Cases/" + labelOf("B-4"));
    EXPECT_EQ(run.cases[run.shown].key, "B-4");
    EXPECT_NE(value("Hard Cases/Picture").find("lantern"), std::string::npos);
    EXPECT_EQ(value("Hard Cases/Used by"), "light of slices");
    EXPECT_TRUE(shown("Hard Cases/Errors"));
    EXPECT_TRUE(shown("Hard Cases/Values"));
}

TEST_F(HardCasePanel, AClickInAGraphMovesTheSlider) {
    frames(6);
    click("Hard Cases/" + labelOf("B-4"));
    click("Hard Cases/Errors");
    EXPECT_GT(run.here.at, -30);
    EXPECT_LT(run.here.at, 30);
    const ui::Widget graph = book.widgets.at("Hard Cases/Errors");
    EXPECT_NEAR(run.here.at, 60 * ((graph.x1 - graph.x0) / 2 - 56) / (graph.x1 - graph.x0 - 68) - 30, 0.5);
    EXPECT_NE(value("Hard Cases/At"), "0");
}

TEST_F(HardCasePanel, TheFormulasTextOpensAndCloses) {
    frames(6);
    EXPECT_FALSE(shown("Hard Cases/Source"));
    click("Hard Cases/weights.h");
    EXPECT_NE(value("Hard Cases/Source").find("FN LightWeights lightWeights(vec3 l)"), std::string::npos);
    EXPECT_NE(value("Hard Cases/Source").find("weightsPublished"), std::string::npos);
    EXPECT_FALSE(shown("Hard Cases/Errors"));
    click("Hard Cases/weights.h");
    EXPECT_TRUE(shown("Hard Cases/Errors"));
}

TEST_F(HardCasePanel, WhatCannotBeSweptSaysWhy) {
    frames(6);
    run.shown = run.cases.size();
    for (size_t i = 0; i < run.cases.size(); ++i)
        if (run.cases[i].key == "J-3") run.shown = i;
    frames(3);
    EXPECT_FALSE(shown("Hard Cases/Errors"));
    EXPECT_FALSE(shown("Hard Cases/At"));
    EXPECT_TRUE(shown("Hard Cases/Picture"));
}

TEST_F(HardCasePanel, WhereThereIsLittleRoomTheListIsACombo) {
    width = 380;
    frames(6);
    EXPECT_EQ(value("Hard Cases/Case"), labelOf("B-1"));
    EXPECT_FALSE(shown("Hard Cases/" + labelOf("B-2")));
    EXPECT_TRUE(shown("Hard Cases/Errors"));
}

}  // namespace
}  // namespace sward::test
