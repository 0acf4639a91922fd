// The graph of frames: the budget by number and by its line.
#include "panels/frame_graph.h"

#include "editor/panels/panel_stage.h"

namespace sward {
namespace {

class FrameGraph : public test::PanelStage {
  protected:
    FrameGraph() {
        name = "Profiler";
        for (int i = 0; i < 10; ++i) addFrame(times, {8, 1});
        draw = [this] { drawFrameGraph(times, 80); };
    }
    FrameTimes times;
};

TEST_F(FrameGraph, SaysHowManyFramesItShowsAndTheirMedian) {
    frames(2);
    EXPECT_EQ(value("Profiler/Graph"), "10");
    EXPECT_EQ(value("Profiler/Frames"), "10 frames, 0 over budget");
    EXPECT_NE(value("Profiler/Times").find("median 8.0 ms"), std::string::npos);
}

TEST_F(FrameGraph, TheLineOfTheBudgetIsDragged) {
    times.budgetMs = 20;
    frames(2);
    const ui::Widget line = book.widgets.at("Profiler/Budget line");
    const double x = static_cast<double>(line.x0 + line.x1) / 2, y = static_cast<double>(line.y0 + line.y1) / 2;
    queue.push({InputKind::Move, x, y, 0, false});
    frames(2);
    queue.push({InputKind::Button, 0, 0, 0, true});
    frames(1);
    queue.push({InputKind::Move, x, y + 15, 0, false});
    frames(2);
    queue.push({InputKind::Button, 0, 0, 0, false});
    frames(2);
    EXPECT_LT(times.budgetMs, 16);
    EXPECT_GT(times.budgetMs, 4);
    const float held = times.budgetMs;
    queue.push({InputKind::Move, x, y - 15, 0, false});
    frames(2);
    EXPECT_EQ(times.budgetMs, held) << "let go";
}

}  // namespace
}  // namespace sward
