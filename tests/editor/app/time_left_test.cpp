// How a task's rest is told.
#include "app/time_left.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(TimeLeft, FollowsFromTheShareDoneAndIsSaidWhenThereIsSomethingToGoBy) {
    EXPECT_EQ(timeLeft(0.5, 40), "40 s left");
    EXPECT_EQ(timeLeft(0.25, 100), "5:00 left");
    EXPECT_EQ(timeLeft(0.1, 1000), "2:30 h left");
    EXPECT_EQ(timeLeft(0.999, 100), "1 s left");
    EXPECT_EQ(timeLeft(0.004, 100), "") << "too little is done";
    EXPECT_EQ(timeLeft(0.5, 1), "") << "too soon";
    EXPECT_EQ(timeLeft(1, 50), "");
}

TEST(TimeLeft, AStopwatchBeginsAnewWithEachTask) {
    Stopwatch watch;
    EXPECT_LT(watch.of(true), 1);
    watch.begun -= std::chrono::seconds(10);
    EXPECT_GE(watch.of(true), 10);
    EXPECT_EQ(watch.of(false), 0);
    EXPECT_LT(watch.of(true), 1);
}

}  // namespace
}  // namespace sward
