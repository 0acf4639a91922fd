// Times of a sweep's rows: how many rounds, what they are worth, and what is kept of them.
#include "cost/cost_times.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support.h"

namespace sward::test {
namespace {

TEST(CostTimes, SlowRowsAreTimedInFewerRoundsAndTheirMedianIsWorthLess) {
    EXPECT_EQ(roundsFor(1, 5), 5);
    EXPECT_EQ(roundsFor(1e6, 5), kLeastRounds);
    EXPECT_EQ(roundsFor(1e6, 1), 1);
    for (double ms = 1; ms < 1e4; ms *= 1.5) EXPECT_LE(roundsFor(1.5 * ms, 50), roundsFor(ms, 50));
    CostRow few, many;
    takeTimes(few, {10, 12, 11});
    takeTimes(many, {10, 12, 11, 10, 12, 11, 10, 12, 11, 10, 12, 11});
    EXPECT_EQ(few.msMedian, 11);
    EXPECT_EQ(few.msP95, 12);
    EXPECT_NEAR(few.msSigma, std::sqrt(std::acos(-1.0) / 2 / 3), 1e-12);  // their deviation is 1
    EXPECT_LT(many.msSigma, few.msSigma / 1.9);
    takeTimes(few, {10});
    EXPECT_TRUE(std::isnan(few.msSigma));
}

TEST(CostTimes, KeptOnesComeBackAndOfOtherRowsAreNone) {
    const TempDir dir;
    ASSERT_TRUE(keepTimes({dir / "times.json", {{1.5, 2.25}, {}}}));
    EXPECT_EQ(keptTimes(dir / "times.json", 2).ms, (std::vector<std::vector<double>>{{1.5, 2.25}, {}}));
    EXPECT_EQ(keptTimes(dir / "times.json", 3).ms, std::vector<std::vector<double>>(3));
    writeText(dir / "times.json", "[[1, \"x\"], ");
    EXPECT_EQ(keptTimes(dir / "times.json", 2).ms, std::vector<std::vector<double>>(2));
}

}  // namespace
}  // namespace sward::test
