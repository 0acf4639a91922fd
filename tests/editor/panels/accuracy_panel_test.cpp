// The tab Accuracy: its plot is clicked, and what it has so far is shown while it measures.
#include "accuracy/accuracy.h"
#include "app/frame_clock.h"
#include "editor/panels/panel_stage.h"
#include "panels/accuracy_plot.h"
#include "panels/panels.h"
#include "tools/camera_control.h"

namespace sward {
namespace {

CostRow row(const char* technique, const char* settings, double ms, double error) {
    CostRow r;
    r.camera = "camera", r.technique = technique, r.settings = settings, r.msMedian = ms;
    r.metrics.appearance.distance = error;
    return r;
}

class AccuracyPanel : public test::PanelStage {
  protected:
    AccuracyPanel() {
        name = "Accuracy";
        CostRun run;
        run.floors.push_back({.camera = "camera"});
        run.rows = {row("flat", "msaa=4", 9, 0.036), row("hybrid", "maxGeom=6", 160, 0.03)};
        markFrontier(run.rows);
        accuracy.sweep.run = run;
        draw = [this] { drawAccuracy(accuracy, {doc, accuracy.program, camera, clock, messages}, edits, 0); };
    }
    Accuracy accuracy;
    FlyCamera camera;
    FrameClock clock;
};

TEST_F(AccuracyPanel, APointOfThePlotIsAdoptedByAClickAndToldInWords) {
    click("Accuracy/Point flat msaa=4");
    EXPECT_EQ(field("lawn.GrassField.technique"), "flat");
    EXPECT_EQ(messages.status, "adopted: flat; 4 samples stay as they are");
    ASSERT_TRUE(doc.undo());
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(AccuracyPanel, WithoutAnythingMeasuredItSaysWhatThePlotIsFor) {
    accuracy.sweep.run.reset();
    frames(2);
    EXPECT_FALSE(shown("Accuracy/Point flat msaa=4"));
    EXPECT_TRUE(shown("Accuracy/Plot"));
    EXPECT_TRUE(shown("Accuracy/Measure"));
}

TEST_F(AccuracyPanel, BesideALowBudgetTheFitSaysWhatItFound) {
    accuracy.fit.result = FitShown{true, 8, 7.5, 0.02, 12, 0.015, "hybrid", "maxGeom=6", "", ""};
    frames(2);
    EXPECT_EQ(value("Accuracy/Fitted"), "maxGeom=6");
    click("Accuracy/Adopt");
    EXPECT_EQ(field("lawn.GrassField.technique"), "hybrid");
    EXPECT_EQ(field("lawn.HybridTiers.maxGeom"), "6");
}

}  // namespace
}  // namespace sward
