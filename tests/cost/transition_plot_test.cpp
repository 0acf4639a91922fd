// Popping along a path as bars.
#include "cost/transition_plot.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

Transitions made() {
    Transitions t;
    t.plan.path = "walk";
    t.seconds = {0, 1, 2, 3, 4};
    t.drawn.steps = {0.1, 0.4, 0.2, 0};
    t.drawn.worst = 0.4, t.drawn.worstStep = 1;
    t.floor.steps = {0.2, 0.2, 0.2, 0.2};
    t.floor.worst = 0.2, t.floor.worstStep = 0;
    return t;
}
constexpr PlotBox kBox{50, 10, 450, 210};

TEST(TransitionPlot, EachStepIsABarAsHighAsItPopsAndColouredByTheFloor) {
    Plot plot;
    const TransitionColors colors;
    addTransitionGraph(plot, made(), kBox, colors, -1);
    ASSERT_EQ(plot.bars.size(), 4u);
    const auto height = [&](size_t i) { return plot.bars[i].high.y - plot.bars[i].low.y; };
    EXPECT_NEAR(height(1), 4 * height(0), 1e-9);
    EXPECT_EQ(height(3), 0);
    EXPECT_EQ(plot.bars[1].color, colors.above);
    for (const size_t i : {0, 2, 3})
        EXPECT_EQ(plot.bars[i].color, colors.below) << "as much as the floor is not above it";
    for (const PlotBar& b : plot.bars) {
        EXPECT_GE(b.low.x, kBox.left);
        EXPECT_LE(b.high.x, kBox.right);
        EXPECT_GE(b.low.y, kBox.top);
        EXPECT_EQ(b.high.y, kBox.bottom);
    }
}

TEST(TransitionPlot, AStepIsFoundUnderThePointerAndNoneBesideThePath) {
    const Transitions t = made();
    EXPECT_EQ(stepAt(t, kBox, 50), 0);
    EXPECT_EQ(stepAt(t, kBox, 151), 1);
    EXPECT_EQ(stepAt(t, kBox, 450), 3);
    EXPECT_EQ(stepAt(t, kBox, 49), -1);
    EXPECT_EQ(stepAt(t, kBox, 451), -1);
    EXPECT_EQ(stepAt(Transitions{}, kBox, 100), -1);
}

TEST(TransitionPlot, TheMarkedStepHasAFrame) {
    Plot bare, marked;
    addTransitionGraph(bare, made(), kBox, {}, -1);
    addTransitionGraph(marked, made(), kBox, {}, 2);
    EXPECT_EQ(marked.lines.size(), bare.lines.size() + 1);
}

TEST(TransitionPlot, AWalkWithoutPoppingHasAGraphToo) {
    Transitions t = made();
    t.drawn.steps = t.floor.steps = {0, 0, 0, 0};
    t.drawn.worst = t.floor.worst = 0;
    const Plot plot = transitionPlot(t);
    EXPECT_EQ(plot.bars.size(), 4u);
    EXPECT_EQ(plotPixels(plot).size(), static_cast<size_t>(plot.width * plot.height * 3));
}

}  // namespace
}  // namespace sward
