#include "editor/resolution.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

// Draws what is planned on a renderer that takes fixedMs + fullMs * area; returns the milliseconds.
double step(Resolution& r, double now, bool changed, double fixedMs, double fullMs, ResolutionPlan* out = nullptr) {
    const ResolutionPlan plan = planDrawing(r, now, changed);
    if (out) *out = plan;
    if (!plan.draw) return 0;
    const double ms = fixedMs + fullMs * plan.scale * plan.scale;
    learnDrawing(r, plan.scale, ms);
    return ms;
}

TEST(Resolution, NothingIsDrawnWhenNothingChanged) {
    Resolution r;
    step(r, 0, true, 1, 5);
    EXPECT_FALSE(planDrawing(r, 10, false).draw);
    EXPECT_LT(secondsToRefine(r, 10), 0);
}

TEST(Resolution, AFastRendererAlwaysDrawsInFull) {
    Resolution r;
    for (int i = 0; i < 50; ++i) {
        ResolutionPlan plan;
        step(r, i * 0.016, true, 1, 15, &plan);
        EXPECT_EQ(plan.scale, 1);
        EXPECT_EQ(plan.msaa, 4);
    }
}

TEST(Resolution, ASlowRendererSettlesNearTheTargetWhileMoving) {
    Resolution r;
    double ms = 0;
    for (int i = 0; i < 20; ++i) ms = step(r, i * 0.06, true, 5, 600);
    EXPECT_LE(ms, 66);  // 15 frames a second
    EXPECT_GT(r.movingScale, kMinScale * 0.99);
    EXPECT_LT(r.movingScale, 0.5);
}

TEST(Resolution, TheScaleNeverLeavesAQuarterToOne) {
    Resolution r;
    ResolutionPlan plan;
    for (int i = 0; i < 20; ++i) step(r, i * 0.5, true, 900, 9000, &plan);
    EXPECT_EQ(plan.scale, kMinScale);
    for (int i = 20; i < 60; ++i) step(r, i * 0.06, true, 0.5, 1, &plan);
    EXPECT_EQ(plan.scale, 1);
}

TEST(Resolution, AtRestTheImageBecomesFullWithinTwoDrawings) {
    Resolution r;
    for (int i = 0; i < 20; ++i) step(r, i * 0.06, true, 5, 900);
    const double last = 19 * 0.06;
    EXPECT_FALSE(planDrawing(r, last + 0.1, false).draw);
    EXPECT_NEAR(secondsToRefine(r, last + 0.1), kRestSeconds - 0.1, 1e-9);
    ResolutionPlan plan;
    for (int i = 0; i < 2; ++i) step(r, last + 1 + i, false, 5, 900, &plan);
    EXPECT_EQ(plan.scale, 1);
    EXPECT_EQ(plan.msaa, 4);
    EXPECT_FALSE(planDrawing(r, last + 5, false).draw);
}

TEST(Resolution, AChangeThatWasNotDrawnYetIsNotForgotten) {
    Resolution r;
    step(r, 0, true, 1, 1);
    planDrawing(r, 1, true);  // the caller had no time to draw
    EXPECT_TRUE(planDrawing(r, 1.01, false).draw);
}

}  // namespace
}  // namespace sward
