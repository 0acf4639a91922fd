// The tab Effects: what its lines say, and what its buttons do.
#include "app/effect_run.h"
#include "app/frame_clock.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"
#include "tools/camera_control.h"

namespace sward {
namespace {

EffectLine line(Feature f, uint64_t changed, double low, double median) {
    EffectLine e;
    e.feature = f, e.changed = changed, e.share = static_cast<double>(changed) / 1000, e.greatest = 40;
    e.ms = {median, low, 2 * median, 0.984, 7};
    e.costsUnseen = changed == 0 && low > 0;
    return e;
}

class EffectsPanel : public test::PanelStage {
  protected:
    EffectsPanel() {
        name = "Effects";
        run.effects = {line(Feature::GrassClumps, 0, 1, 1.5), line(Feature::Sky, 123, 3, 4)};
        EffectLine broken = line(Feature::GrassDensity, 0, 0, 0);
        broken.error = "too many blades";
        run.effects.push_back(broken);
        run.present = featureSet(Feature::GrassClumps, Feature::Sky, Feature::GrassDensity);
        run.camera = "camera", run.size = {300, 200};
        draw = [this] {
            const MeasureParts measure{doc, run.program, camera, clock, messages};
            drawEffects({run, measure, edits, {300, 200}, 0});
        };
    }
    EffectRun run;
    FlyCamera camera;
    FrameClock clock;
};

TEST_F(EffectsPanel, EachLineSaysWhatChangesAndWhatItCosts) {
    run.revision = doc.revision();
    frames(2);
    EXPECT_EQ(value("Effects/grass-clumps/Changes"), "0 pixels");
    EXPECT_EQ(value("Effects/grass-clumps/Cost"), "1.5 ms (1.0 to 3.0)");
    EXPECT_EQ(value("Effects/sky/Changes"), "12.3 %");
    EXPECT_EQ(value("Effects/grass-density/Error"), "not measured");
    EXPECT_EQ(value("Effects/State"), "camera at 300 x 200");
    ASSERT_TRUE(doc.addEntity("another"));
    frames(2);
    EXPECT_EQ(value("Effects/State"), "camera at 300 x 200; the project has changed since");
}

TEST_F(EffectsPanel, TurnOffIsOneStepAndWhatIsOffHasNoButton) {
    click("Effects/grass-clumps/Turn Off");
    EXPECT_EQ(field("lawn.GrassField.species[lawn].clumpStrength"), "0");
    EXPECT_EQ(doc.undoLabel(), "turn off grass-clumps");
    EXPECT_EQ(messages.notice, "");
    run.present = featureSet(Feature::Sky);
    frames(2);
    EXPECT_FALSE(shown("Effects/grass-clumps/Turn Off"));
    EXPECT_TRUE(shown("Effects/sky/Turn Off"));
}

TEST_F(EffectsPanel, AClickOnALineLooksAtItsPicture) {
    click("Effects/sky/sky");
    EXPECT_EQ(run.shown, Feature::Sky);
    EXPECT_TRUE(run.showDue);
}

TEST_F(EffectsPanel, BeforeAnythingIsMeasuredItSaysWhatItIsForAndWhyItFailed) {
    run.effects.clear();
    frames(2);
    EXPECT_TRUE(shown("Effects/Measure"));
    EXPECT_NE(value("Effects/State").find("What each effect"), std::string::npos);
    run.error = "sward effects ended with exit code 1";
    frames(2);
    EXPECT_EQ(value("Effects/State"), run.error);
}

}  // namespace
}  // namespace sward
