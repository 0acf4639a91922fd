// The profiler panel: a line a pass, numbers only of what was measured.
#include "app/frame_times.h"
#include "app/viewport.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

class ProfilerPanel : public test::PanelStage {
  protected:
    ProfilerPanel() {
        counts.stats.passes = {{"grass/geometry", 3, 2, 900}, {"sky", 1, 1, 1}};
        draw = [this] { drawProfiler(counts, times, false, "a renderer"); };
    }
    ViewCounts counts;
    FrameTimes times;
};

TEST_F(ProfilerPanel, EachPassHasARowWithItsDraws) {
    frames(2);
    EXPECT_EQ(value("Panel/grass/geometry"), "2");
    EXPECT_EQ(value("Panel/sky"), "1");
}

TEST_F(ProfilerPanel, MeasureIsSwitchedOnAndOff) {
    click("Panel/Measure");
    EXPECT_TRUE(counts.measure);
    click("Panel/Measure");
    EXPECT_FALSE(counts.measure);
}

TEST_F(ProfilerPanel, BladesAreListedBySpecies) {
    frames(2);
    EXPECT_TRUE(counts.wantsSpecies) << "the list asks for them";
    counts.species = {{"lawn", "clover", 1e6, 2500}};
    frames(2);
    EXPECT_EQ(value("Panel/Species lawn/clover"), "2500");
}

}  // namespace
}  // namespace sward
