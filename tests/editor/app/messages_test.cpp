// What is said: the red bar for errors, the status line for the rest.
#include "app/messages.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(Messages, AnErrorRaisesTheBarWithPlaceAndRemedy) {
    Messages m;
    showError(m, {ExitCode::Failed, "the disk is full", "maps/a.png", 0, 0, "free some space"});
    EXPECT_EQ(m.notice, "maps/a.png: the disk is full (free some space)");
    EXPECT_EQ(m.status, "");
}

TEST(Messages, WhatThePersonStoppedIsSaidWithoutTheBar) {
    Messages m;
    EXPECT_FALSE(accept(m, Status(interruption("Importing hills.png: cancelled", "nothing has changed"))));
    EXPECT_EQ(m.notice, "");
    EXPECT_EQ(m.status, "Importing hills.png: cancelled (nothing has changed)");
}

TEST(Messages, WhatSucceedsIsAcceptedInSilence) {
    Messages m;
    m.notice = "an older one";
    EXPECT_TRUE(accept(m, {}));
    EXPECT_EQ(m.notice, "an older one");
    EXPECT_FALSE(accept(m, Status(Error{ExitCode::Usage, "no", "", 0, 0, ""})));
    EXPECT_EQ(m.notice, "no") << "the newest stands";
}

TEST(Messages, TheLastThingSaidStandsInTheStatusBar) {
    Messages m;
    say(m, "saved");
    say(m, "undone: stroke");
    EXPECT_EQ(m.status, "undone: stroke");
    EXPECT_EQ(m.notice, "");
}

}  // namespace
}  // namespace sward
