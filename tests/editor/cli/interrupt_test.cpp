// What a verb that takes long says of itself.
#include "cli/interrupt.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(LongTask, SaysOnceItIsKnownHowLongItTakesAndWhatWouldTakeLess) {
    EXPECT_EQ(longTaskText("reference human", 0.025, 5, "fewer --samples take less"),
              "reference human: 3:15 left; Ctrl+C ends it; fewer --samples take less");
    EXPECT_EQ(longTaskText("scene", 0.1, 20, ""), "scene: 3:00 left; Ctrl+C ends it");
    EXPECT_EQ(longTaskText("scene", 0.1, 4, ""), "") << "too soon to tell";
    EXPECT_EQ(longTaskText("scene", 0.5, 20, ""), "") << "20 seconds are soon over";
    EXPECT_EQ(longTaskText("scene", 0, 20, ""), "") << "nothing is done yet";
}

// Off a terminal, a task that is soon over says nothing.
TEST(LongTask, ShortOnesAreSilentInALog) {
    testing::internal::CaptureStderr();
    const auto tell = progressLine("drawing");
    EXPECT_TRUE(tell(0.5));
    EXPECT_TRUE(tell(1));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace sward
