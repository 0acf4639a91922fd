// The fit's held-out cameras; fitting itself: cost_gl_test.cpp.
#include "cost/fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sward::test {
namespace {

TEST(FitCameras, HeldOutOnesStandAsideAndLookElsewhere) {
    const ViewCamera c{{2, 1.7, 3}, {10, 0, 9}, 55, 0};
    const ViewCamera m = heldOutCamera(c);
    const double length = glm::length(c.target - c.eye);
    EXPECT_NEAR(glm::length(m.eye - c.eye), length / 8, 1e-9);
    EXPECT_NEAR(glm::length(m.target - m.eye), length, 1e-9);
    const glm::dvec2 a(c.target.x - c.eye.x, c.target.z - c.eye.z), b(m.target.x - m.eye.x, m.target.z - m.eye.z);
    EXPECT_NEAR(glm::dot(a, b) / (glm::length(a) * glm::length(b)), std::cos(glm::radians(20.0)), 1e-9);
    EXPECT_EQ(m.eye.y, c.eye.y);
}

TEST(FitVerdicts, AreAgainstTheBetterRivalAndWithinTheErrorEven) {
    const FitScore none;
    EXPECT_EQ(verdictOf({0.02, 0.001}, none, none).rival, "");
    const FitVerdict wins = verdictOf({0.02, 0.001}, {0.03, 0.001}, {0.025, 0.001});
    EXPECT_EQ(wins.outcome, FitOutcome::Wins);
    EXPECT_EQ(wins.rival, "grid");
    EXPECT_EQ(verdictOf({0.02, 0.001}, {0.0195, 0.001}, none).outcome, FitOutcome::Even);
    const FitVerdict loses = verdictOf({0.02, 0.001}, {0.015, 0.001}, {0.025, 0.001});
    EXPECT_EQ(loses.outcome, FitOutcome::Loses);
    EXPECT_EQ(loses.rival, "shipped");
}
TEST(FitVerdicts, WhatIsHadFromASearchThatLosesIsItsRival) {
    FitResult r;
    r.fitted.setting = {"flat", {"msaa=1"}}, r.gridBest.setting = {"hybrid", {"maxGeom=2"}};
    EXPECT_EQ(chosen(r).setting.technique, "flat");
    r.unseen = {FitOutcome::Even, "grid"};
    EXPECT_EQ(chosen(r).setting.technique, "flat");
    r.unseen = {FitOutcome::Loses, "grid"};
    EXPECT_EQ(chosen(r).setting.technique, "hybrid");
    r.unseen = {FitOutcome::Loses, "shipped"};
    EXPECT_TRUE(chosen(r).setting.values.empty()) << "the project as it is";
}

}  // namespace
}  // namespace sward::test
