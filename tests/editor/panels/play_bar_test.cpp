// The play bar: it says what was pressed and does nothing itself.
#include "panels/play_bar.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"
#include "playtest/playtest.h"

namespace sward {
namespace {

class PlayBar : public test::PanelStage {
  protected:
    PlayBar() {
        draw = [this] {
            if (ImGui::BeginMainMenuBar()) ImGui::EndMainMenuBar();  // in whose row the bar lies
            if (const PlayAction a = drawPlayBar(doc); a != PlayAction::None) pressed = a;
        };
    }
    PlayAction pressed = PlayAction::None;
};

TEST_F(PlayBar, SaysThatStartWasPressed) {
    click("Panel/Start");
    EXPECT_EQ(pressed, PlayAction::Toggle);
    EXPECT_EQ(doc.play(), nullptr);
    EXPECT_EQ(value("Panel/State"), "stopped");
}

TEST_F(PlayBar, PauseAndStepAreForWhatIsPlayed) {
    click("Panel/Pause");
    EXPECT_EQ(pressed, PlayAction::None) << "disabled";
    ASSERT_TRUE(doc.startPlay({}));
    click("Panel/Pause");
    EXPECT_EQ(pressed, PlayAction::Pause);
    click("Panel/Step");
    EXPECT_EQ(pressed, PlayAction::Step);
    EXPECT_EQ(value("Panel/State"), "playing");
    doc.play()->pause(true);
    frames(2);
    EXPECT_EQ(value("Panel/State"), "paused");
    doc.stopPlay();
}

TEST_F(PlayBar, TheFrameSaysHowLongItWasPlayed) {
    draw = [this] { drawPlayFrame(doc, false, {100, 100, 400, 300}); };
    frames(2);
    EXPECT_FALSE(shown("Viewport/Playing")) << "nothing is played";
    ASSERT_TRUE(doc.startPlay({}));
    frames(2);
    EXPECT_EQ(value("Viewport/Playing"), "0.00");
    doc.play()->step(90);
    frames(2);
    EXPECT_EQ(value("Viewport/Playing"), "1.50");
    doc.stopPlay();
    frames(2);
    EXPECT_FALSE(shown("Viewport/Playing"));
}

}  // namespace
}  // namespace sward
