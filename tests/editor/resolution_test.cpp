#include "editor/resolution.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

// A renderer that takes fixedMs + fullMs * area for a drawing.
struct Machine {
    double fixedMs, fullMs;
    Resolution r{};
    ResolutionPlan plan{};

    // Draws what is planned; returns the milliseconds it took.
    double step(double now, bool changed) {
        plan = planDrawing(r, now, changed);
        if (!plan.draw) return 0;
        const double ms = fixedMs + fullMs * plan.scale * plan.scale / (plan.grid * plan.grid);
        learnDrawing(r, plan, ms);
        return ms;
    }
};

TEST(Resolution, NothingIsDrawnWhenNothingChanged) {
    Machine m{1, 5};
    m.step(0, true);
    EXPECT_FALSE(planDrawing(m.r, 10, false).draw);
    EXPECT_LT(secondsToRefine(m.r, 10), 0);
}

TEST(Resolution, AFastRendererAlwaysDrawsInFullAndWhole) {
    Machine m{1, 15};
    for (int i = 0; i < 50; ++i) {
        m.step(i * 0.016, true);
        EXPECT_EQ(m.plan.scale, 1);
        EXPECT_EQ(m.plan.msaa, 4);
        EXPECT_EQ(m.plan.grid, 1);
    }
}

TEST(Resolution, ASlowRendererSettlesNearTheTargetWhileMoving) {
    Machine m{5, 600};
    double ms = 0;
    for (int i = 0; i < 20; ++i) ms = m.step(i * 0.06, true);
    EXPECT_LE(ms, 66);  // 15 frames a second
    EXPECT_GE(m.r.movingScale, kMinScale);
    EXPECT_LT(m.r.movingScale, 0.5);
}

TEST(Resolution, TheScaleNeverLeavesAQuarterToOne) {
    Machine m{900, 9000};
    for (int i = 0; i < 20; ++i) m.step(i * 0.1, true);
    EXPECT_EQ(m.plan.scale, kMinScale);
    m.fixedMs = 0.5, m.fullMs = 1;
    for (int i = 20; i < 60; ++i) m.step(i * 0.06 + 2, true);
    EXPECT_EQ(m.plan.scale, 1);
}

TEST(Resolution, AtRestEveryPartIsDrawnOnceAndNoneTakesLong) {
    Machine m{2, 1200};
    for (int i = 0; i < 20; ++i) m.step(i * 0.06, true);
    const double rest = 19 * 0.06 + kRestSeconds + 0.01;
    EXPECT_FALSE(planDrawing(m.r, rest - 0.1, false).draw);
    EXPECT_NEAR(secondsToRefine(m.r, rest - 0.06), 0.05, 1e-9);
    int parts = 0;
    for (int i = 0; i < 200; ++i) {
        const double ms = m.step(rest + i * 0.05, false);
        if (!m.plan.draw) break;
        EXPECT_EQ(m.plan.part, parts++);
        EXPECT_EQ(m.plan.msaa, 4);
        EXPECT_LT(ms, 80);
        EXPECT_EQ(m.r.drawnScale >= 1, parts == m.plan.grid * m.plan.grid);
    }
    EXPECT_GT(m.r.grid, 1);
    EXPECT_EQ(parts, m.r.grid * m.r.grid);
    EXPECT_LT(secondsToRefine(m.r, 1e6), 0);
}

TEST(Resolution, AChangeBetweenPartsBeginsAnew) {
    Machine m{2, 1200};
    for (int i = 0; i < 20; ++i) m.step(i * 0.06, true);
    for (int i = 0; i < 3; ++i) m.step(2 + i * 0.05, false);
    EXPECT_GT(m.r.part, 0);
    m.step(2.2, true);
    EXPECT_LT(m.plan.scale, 1);
    m.step(4, false);
    EXPECT_EQ(m.plan.part, 0);
}

TEST(Resolution, AChangeThatWasNotDrawnYetIsNotForgotten) {
    Machine m{1, 1};
    m.step(0, true);
    planDrawing(m.r, 1, true);  // the caller had no time to draw
    EXPECT_TRUE(planDrawing(m.r, 1.01, false).draw);
    EXPECT_TRUE(planDrawing(m.r, 5, false).draw);
}

}  // namespace
}  // namespace sward
