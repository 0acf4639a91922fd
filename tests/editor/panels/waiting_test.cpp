// The window of what is waited for: how far it is, Cancel, and that it goes when the work has ended.
#include <thread>

#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

class WaitingWindow : public test::PanelStage {
  protected:
    WaitingWindow() {
        waiting.patient = false;
        draw = [this] {
            followWaiting(waiting);
            drawWaiting(waiting);
        };
    }
    void begin() {
        waitFor(
            waiting, "Importing hills.png",
            [this](JobControl& c) -> Result<Taking> {
                while (!go && !c.cancelled()) c.setProgress(progress);
                return failed(c.cancelled() ? "cancelled" : "done");
            },
            [this](const Status& s) { ended = s.error().message; });
        frames(3);
    }
    // Frames until the work has ended.
    void finish() {
        while (waits(waiting)) frames();
        frames(2);
    }
    std::atomic<bool> go = false;
    std::atomic<double> progress = 0;
    std::string ended;
};

TEST_F(WaitingWindow, SaysHowFarItIsAndGoesAtTheEnd) {
    begin();
    EXPECT_TRUE(ImGui::GetIO().WantCaptureMouse) << "nothing else is to be clicked";
    EXPECT_NE(value("Panel/Progress").find(" s"), std::string::npos) << value("Panel/Progress");
    progress = 0.4;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    frames(2);
    EXPECT_EQ(value("Panel/Progress").substr(0, 4), "40 %");
    go = true;
    finish();
    EXPECT_EQ(ended, "done");
    EXPECT_FALSE(shown("Panel/Cancel"));
    EXPECT_FALSE(waiting.shown);
}

TEST_F(WaitingWindow, CancelEndsTheWork) {
    begin();
    click("Panel/Cancel");
    finish();
    EXPECT_EQ(ended, "cancelled");
    EXPECT_FALSE(shown("Panel/Cancel"));
}

TEST_F(WaitingWindow, EscapeEndsItToo) {
    begin();
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_ESCAPE, true});
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_ESCAPE, false});
    frames(3);
    finish();
    EXPECT_EQ(ended, "cancelled");
}

}  // namespace
}  // namespace sward
