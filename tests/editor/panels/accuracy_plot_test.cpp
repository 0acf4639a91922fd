// The time-appearance plot: where points lie, what a click hands back, and what is left out.
#include "panels/accuracy_plot.h"

#include <cmath>
#include <limits>

#include "accuracy/accuracy.h"
#include "editor/panels/panel_stage.h"

namespace sward {
namespace {

CostRow plotRow(const char* technique, const char* settings, double ms, double error) {
    CostRow r;
    r.camera = "camera", r.technique = technique, r.settings = settings, r.msMedian = ms;
    r.metrics.appearance.distance = error;
    return r;
}

class AccuracyPlot : public test::PanelStage {
  protected:
    AccuracyPlot() {
        name = "Accuracy";
        run.emplace();
        run->floors.push_back({.camera = "camera"});
        run->rows = {plotRow("flat", "msaa=4", 9, 0.036), plotRow("hybrid", "maxGeom=6", 160, 0.03),
                     plotRow("hybrid", "maxGeom=2", 38, 0.033)};
        draw = [this] {
            if (auto setting = drawCostPlot(run, doc, false, {})) adopted = setting;
        };
    }
    ui::Widget point(const std::string& of) {
        const auto found = book.widgets.find("Accuracy/Point " + of);
        EXPECT_NE(found, book.widgets.end()) << of;
        return found == book.widgets.end() ? ui::Widget{} : found->second;
    }
    std::optional<CostRun> run;
    std::optional<CostSetting> adopted;
};

TEST_F(AccuracyPlot, QuickerIsFartherLeftAndTruerLowerByTheLogarithm) {
    frames(2);
    const ui::Widget quick = point("flat msaa=4"), slow = point("hybrid maxGeom=6"),
                     between = point("hybrid maxGeom=2");
    EXPECT_LT(quick.x0, between.x0);
    EXPECT_LT(between.x0, slow.x0);
    EXPECT_LT(quick.y0, between.y0);
    EXPECT_LT(between.y0, slow.y0);
    const float share = (between.x0 - quick.x0) / (slow.x0 - quick.x0);
    EXPECT_NEAR(share, std::log(38.0 / 9) / std::log(160.0 / 9), 1e-3) << "9, 38 and 160 ms";
    EXPECT_EQ(quick.value, "0.0360");
}

TEST_F(AccuracyPlot, PointsLieWithinThePlotWhateverTheyAre) {
    run->rows.push_back(plotRow("flat", "msaa=1", 1e-4, 3));
    run->rows.push_back(plotRow("flat", "msaa=2", 1e6, 1e-7));
    frames(2);
    const ui::Widget plot = book.widgets.at("Accuracy/Plot");
    for (const char* of : {"flat msaa=1", "flat msaa=2", "flat msaa=4", "hybrid maxGeom=6"}) {
        const ui::Widget w = point(of);
        EXPECT_GT(w.x0, plot.x0) << of;
        EXPECT_LT(w.x1, plot.x1) << of;
        EXPECT_GT(w.y0, plot.y0) << of;
        EXPECT_LT(w.y1, plot.y1) << of;
    }
}

TEST_F(AccuracyPlot, WhatWasNotDrawnOrHasNoTimeIsLeftOut) {
    run->rows.push_back(plotRow("flat", "skipped", 5, 0.05));
    run->rows.back().skipped = "it takes longer than a frame may";
    run->rows.push_back(plotRow("flat", "unmeasured", std::numeric_limits<double>::quiet_NaN(), 0.05));
    run->rows.push_back(plotRow("flat", "exact", 5, 0));
    frames(2);
    EXPECT_TRUE(shown("Accuracy/Point flat msaa=4"));
    for (const char* of : {"skipped", "unmeasured", "exact"})
        EXPECT_FALSE(shown("Accuracy/Point flat " + std::string(of)));
}

TEST_F(AccuracyPlot, AClickHandsBackThePointsSettingsAndBesideItNothing) {
    click("Accuracy/Point hybrid maxGeom=2");
    ASSERT_TRUE(adopted);
    EXPECT_EQ(adopted->technique, "hybrid");
    EXPECT_EQ(adopted->text(), "maxGeom=2");
    adopted.reset();
    click("Accuracy/Plot");
    EXPECT_FALSE(adopted) << "the middle of the plot is no point";
}

TEST_F(AccuracyPlot, WhatTheProjectIsAlreadyCannotBeAdopted) {
    run->rows = {plotRow("hybrid", kAsItIs, 20, 0.03), plotRow("flat", "msaa=4", 9, 0.036)};
    click("Accuracy/Point hybrid " + std::string(kAsItIs));
    EXPECT_FALSE(adopted);
}

TEST_F(AccuracyPlot, ARunWithoutFloorsIsAnEmptyFrame) {
    run->floors.clear();
    frames(2);
    EXPECT_TRUE(shown("Accuracy/Plot"));
    EXPECT_FALSE(shown("Accuracy/Point flat msaa=4"));
}

}  // namespace
}  // namespace sward
