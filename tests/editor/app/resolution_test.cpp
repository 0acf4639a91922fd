#include "editor/app/resolution.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sward {
namespace {

// A renderer that takes fixedMs + bladeMs * detail + fullMs * area for a drawing.
struct Machine {
    double fixedMs, fullMs, bladeMs = 0;
    Resolution r{};
    ResolutionPlan plan{};

    // Draws what is planned; returns the milliseconds it took.
    double step(double now, bool changed) {
        plan = planDrawing(r, now, changed);
        if (!plan.draw) return 0;
        const double ms = fixedMs + (bladeMs * plan.detail + fullMs * plan.scale * plan.scale) * plan.piece.area();
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
        EXPECT_TRUE(m.plan.piece.whole());
        EXPECT_EQ(m.plan.detail, 1);
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

TEST(Resolution, WhereTheSmallestImageIsTooSlowBladesGiveWayAndComeBack) {
    Machine m{5, 100, 600};
    double ms = 0;
    for (int i = 0; i < 30; ++i) ms = m.step(i * 0.06, true);
    EXPECT_EQ(m.plan.scale, kMinScale);
    EXPECT_LE(ms, 66);
    EXPECT_LT(m.plan.detail, 0.2);
    m.bladeMs = 10, m.fullMs = 10;
    for (int i = 30; i < 80; ++i) m.step(i * 0.06, true);
    EXPECT_EQ(m.plan.detail, 1);
    EXPECT_EQ(m.plan.scale, 1);
}

TEST(Resolution, AtRestPiecesCoverThePictureOnceAndNoneTakesLong) {
    Machine m{2, 1200, 800};
    for (int i = 0; i < 20; ++i) m.step(i * 0.06, true);
    const double rest = 19 * 0.06 + kRestSeconds + 0.01;
    EXPECT_FALSE(planDrawing(m.r, rest - 0.1, false).draw);
    EXPECT_NEAR(secondsToRefine(m.r, rest - 0.06), 0.05, 1e-9);
    double covered = 0;
    PicturePiece last{0, 1, 0, 0};
    int pieces = 0;
    for (; pieces < 2000; ++pieces) {
        const double ms = m.step(rest + pieces * 0.05, false);
        if (!m.plan.draw) break;
        const PicturePiece piece = m.plan.piece;
        if (piece.left > 0) {
            EXPECT_EQ(piece.left, last.right);
            EXPECT_EQ(piece.from, last.from);
            EXPECT_EQ(piece.to, last.to);
        } else {
            EXPECT_EQ(piece.from, last.to);
            EXPECT_EQ(last.right, 1);
        }
        EXPECT_EQ(m.plan.msaa, 4);
        EXPECT_EQ(m.plan.detail, 1);
        EXPECT_LE(ms, 30);
        covered += piece.area();
        last = piece;
        EXPECT_EQ(m.r.drawnScale >= 1, piece.right >= 1 && piece.to >= 1);
    }
    EXPECT_NEAR(covered, 1, 1e-9);
    EXPECT_GT(pieces, 60) << "of the 2000 ms no more than 30 a piece";
    EXPECT_LT(pieces, 400);
    EXPECT_LT(secondsToRefine(m.r, 1e6), 0);
}

// Sky above, then grass: a thousand times as dear.
TEST(Resolution, PiecesGrowSlowlyWhereTheyCostNothing) {
    Resolution r;
    r.movingScale = 0.25;
    ResolutionPlan plan = planDrawing(r, 0, true);
    learnDrawing(r, plan, 100);  // 1600 ms in full
    double most = 0, now = 1;
    for (int i = 0; i < 2000 && (plan = planDrawing(r, now, false)).draw; ++i, now += 0.05) {
        const PicturePiece& p = plan.piece;
        const double grass = std::max(0.0, p.to - std::max(p.from, 0.4)) * (p.right - p.left);
        const double ms = 1 + 1 * p.area() + 2500 * grass;
        learnDrawing(r, plan, ms);
        most = std::max(most, ms);
    }
    EXPECT_EQ(r.drawnScale, 1);
    EXPECT_LT(most, 170) << "the first piece of grass alone is a surprise";
}

// A hedge in a meadow: a narrow strip that costs forty times as much. Nothing tells of it beforehand, once.
TEST(Resolution, WhatWasDearOnceIsCutFinelyFromThenOn) {
    Resolution r;
    r.movingScale = 0.25;
    learnDrawing(r, planDrawing(r, 0, true), 100);  // 1600 ms in full
    double most[2] = {0, 0}, now = 1;
    for (double& longest : most) {
        ResolutionPlan plan;
        for (int i = 0; i < 4000 && (plan = planDrawing(r, now, false)).draw; ++i, now += 0.05) {
            const PicturePiece& p = plan.piece;
            const double hedge = std::max(0.0, std::min(p.to, 0.6) - std::max(p.from, 0.5)) * (p.right - p.left);
            const double ms = 1 + 500 * p.area() + 20000 * hedge;
            learnDrawing(r, plan, ms);
            longest = std::max(longest, ms);
        }
        EXPECT_EQ(r.drawnScale, 1);
        planDrawing(r, now, true);  // the same view again, as after a stroke
        learnDrawing(r, {.draw = true, .scale = 0.25}, 40);
        now += 1;
    }
    EXPECT_GT(most[0], 40) << "the first piece of it is a surprise";
    EXPECT_LE(most[1], 30);
    EXPECT_LT(most[1], most[0]);
}

TEST(Resolution, APieceSaysWhatItWillCost) {
    Machine m{0, 1600};
    for (int i = 0; i < 20; ++i) m.step(i * 0.06, true);
    for (int i = 0; i < 2000 && (i == 0 || m.plan.draw); ++i) m.step(3 + i * 0.05, false);
    m.step(200, true);
    m.step(201, false);
    ASSERT_FALSE(m.plan.piece.whole());
    EXPECT_NEAR(m.plan.expectedMs, 1600 * m.plan.piece.area(), 1e-6);
}

TEST(Resolution, AChangeBetweenPiecesBeginsAnew) {
    Machine m{2, 1200};
    for (int i = 0; i < 20; ++i) m.step(i * 0.06, true);
    for (int i = 0; i < 3; ++i) m.step(2 + i * 0.05, false);
    EXPECT_GT(m.r.row.from, 0);
    m.step(2.2, true);
    EXPECT_LT(m.plan.scale, 1);
    m.step(4, false);
    EXPECT_TRUE(m.plan.piece.first());
}

TEST(Resolution, AChangeThatWasNotDrawnYetIsNotForgotten) {
    Machine m{1, 1};
    m.step(0, true);
    planDrawing(m.r, 1, true);  // the caller had no time to draw
    EXPECT_TRUE(planDrawing(m.r, 1.01, false).draw);
    EXPECT_TRUE(planDrawing(m.r, 5, false).draw);
}

// A picture whose blades take five minutes, at a share that takes a second.
TEST(Resolution, WhereAllBladesTakeTooLongTheFullPictureHasFewOfThem) {
    Machine m{5, 20, 300'000};
    limitDetail(m.r, 1.0 / 300);
    double now = 0;
    for (int i = 0; i < 20; ++i) EXPECT_LE(m.step(now += 0.05, true), 1100);
    EXPECT_LE(m.plan.detail, 1.0 / 300);
    for (int i = 0; i < 2000 && m.r.drawnScale < 1; ++i) m.step(now += 0.3, false);
    EXPECT_EQ(m.r.drawnScale, 1) << "it is refined";
    EXPECT_EQ(m.plan.detail, 1.0 / 300);
    limitDetail(m.r, 1.0 / 300);
    EXPECT_FALSE(planDrawing(m.r, now += 1, false).draw) << "the same limit changes nothing";
    m.bladeMs = 20;
    limitDetail(m.r, 1);
    EXPECT_EQ(secondsToRefine(m.r, now), 0) << "what is shown is stale";
    for (int i = 0; i < 2000 && (i == 0 || m.r.drawnScale < 1); ++i) m.step(now += 0.3, false);
    EXPECT_EQ(m.plan.detail, 1);
}

}  // namespace
}  // namespace sward
