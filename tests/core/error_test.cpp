// Errors: how they read, and what their makers put where.
#include "core/error.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(Errors, SayWhatIsKnownAndNothingElse) {
    EXPECT_EQ(failed("is full").text(), "is full");
    EXPECT_EQ(failed("is full", "free some space").text(), "is full (free some space)");
    EXPECT_EQ(unsound("is no map").at("a.png").text(), "a.png: is no map");
    EXPECT_EQ(unsound("is no map").at("a.json", 3).text(), "a.json:3: is no map");
    EXPECT_EQ(unsound("is no map", "export it").at("a.json", 3, 7).text(), "a.json:3:7: is no map (export it)");
    EXPECT_EQ(unsound("is no map").at("a.json", 0, 7).text(), "a.json: is no map") << "a column alone is no place";
}

TEST(Errors, MakersSayTheExitCode) {
    EXPECT_EQ(failed("x").code, ExitCode::Failed);
    EXPECT_EQ(usage("x").code, ExitCode::Usage);
    EXPECT_EQ(unsound("x").code, ExitCode::Unsound);
    EXPECT_EQ(noContext("x").code, ExitCode::NoContext);
    EXPECT_EQ(interruption("x").code, ExitCode::Interrupted);
}

TEST(Errors, AnotherPlaceReplacesTheOldOneAndKeepsTheRest) {
    const Error moved = usage("is none", "name one").at("a", 3, 7).at("b");
    EXPECT_EQ(moved.code, ExitCode::Usage);
    EXPECT_EQ(moved.text(), "b: is none (name one)");
    EXPECT_EQ(moved.line, 0);
    EXPECT_EQ(moved.column, 0);
}

TEST(Results, HoldAValueOrAnError) {
    Result<int> good = 7;
    ASSERT_TRUE(good);
    *good += 1;
    EXPECT_EQ(*good, 8);
    const Result<int> bad = failed("broke");
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().message, "broke");
    EXPECT_TRUE(Status());
    EXPECT_FALSE(Status(failed("broke")));
}

}  // namespace
}  // namespace sward
