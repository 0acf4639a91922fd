// The last frames: how many are kept, and what is told of them.
#include "app/frame_times.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(FrameTimes, KeepsTheLastAndForgetsTheOldest) {
    FrameTimes t;
    EXPECT_EQ(keptFrames(t), 0u);
    EXPECT_EQ(summaryOf(t).median, 0);
    for (int i = 0; i < 300; ++i) addFrame(t, {static_cast<float>(i), 0});
    ASSERT_EQ(keptFrames(t), kFramesKept);
    EXPECT_EQ(frameAt(t, 0).all, 60);
    EXPECT_EQ(frameAt(t, kFramesKept - 1).all, 299);
}

TEST(FrameTimes, TellsMedianSlowestAndHowManyAreOverBudget) {
    FrameTimes t;
    t.budgetMs = 10;
    for (const float ms : {5.f, 30.f, 10.f, 7.f, 11.f}) addFrame(t, {ms, ms / 10});
    const FrameSummary s = summaryOf(t);
    EXPECT_EQ(s.median, 10);
    EXPECT_EQ(s.slowest, 30);
    EXPECT_EQ(s.over, 2u) << "the budget itself is within it";
    EXPECT_EQ(s.panels, 1);
}

}  // namespace
}  // namespace sward
