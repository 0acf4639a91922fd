// Which rows of a sweep lie on the frontier of cost and likeness.
#include "cost/cost.h"

#include <gtest/gtest.h>

#include <limits>

#include "cost/cost_rows.h"

namespace sward::test {
namespace {

TEST(CostFrontier, HoldsWhatNoneBeatsInBoth) {
    std::vector<CostRow> rows = {row(0, 10, 0.1), row(1, 20, 0.05), row(2, 25, 0.06),          row(3, 40, 0.01),
                                 row(4, 9, 0.3),  row(5, 10, 0.1),  row(6, 1, 0.001, "other"), row(7, 1, 0.0001)};
    rows[7].skipped = "too slow";
    rows.push_back(row(8, std::numeric_limits<double>::quiet_NaN(), 0.001));
    markFrontier(rows);
    std::vector<int> on;
    for (const CostRow& r : rows)
        if (r.onFrontier) on.push_back(r.index);
    EXPECT_EQ(on, (std::vector<int>{0, 1, 3, 4, 5, 6}));
}
TEST(CostFrontier, RowsThatDifferByLessThanTheirErrorsAreOnePoint) {
    std::vector<CostRow> rows = {row(0, 10, 0.1),    row(1, 10.4, 0.099), row(2, 9.8, 0.101),
                                 row(3, 11, 0.0999), row(4, 30, 0.098),   row(5, 10, 0.13)};
    for (CostRow& r : rows) r.msSigma = 0.5, r.metrics.appearance.sigma = 0.002;
    markFrontier(rows);
    EXPECT_TRUE(rows[0].onFrontier && rows[1].onFrontier && rows[2].onFrontier);
    EXPECT_FALSE(rows[3].onFrontier) << "no nearer beyond doubt than rows[2], and slower";
    EXPECT_FALSE(rows[4].onFrontier) << "a little nearer, but not surely, and three times as slow";
    EXPECT_FALSE(rows[5].onFrontier);
    EXPECT_TRUE(beats(rows[0], rows[4]));
    EXPECT_FALSE(beats(rows[0], rows[1]) || beats(rows[1], rows[0]));
}
TEST(CostRows, OfOneTechniqueThatDrawTheSamePictureAreOne) {
    CostRun whole = run({row(0, 10, 0.1), row(1, 11, 0.1), row(2, 12, 0.1), row(3, 13, 0.1), row(4, 14, 0.1)}, 5);
    for (CostRow& r : whole.rows) r.pixels = "a";
    whole.rows[0].settings = kAsItIs;
    whole.rows[2].technique = "slices";
    whole.rows[3].pixels.clear(), whole.rows[3].skipped = "too slow";
    whole.rows[4].camera = "other";
    keepDistinct(whole);
    ASSERT_EQ(whole.rows.size(), 4u);
    EXPECT_EQ(whole.rows[0].settings, kAsItIs);
    EXPECT_EQ(whole.rows[1].technique, "slices") << "another way to the same picture has its own time";
    EXPECT_EQ(whole.rows[3].camera, "other");
    EXPECT_EQ(whole.total, 4);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(whole.rows[static_cast<size_t>(i)].index, i);
}
TEST(CostFrontier, NeverJoinsTimesOfTwoMachines) {
    std::vector<CostRow> rows = {row(0, 10, 0.1), row(1, 5, 0.05)};
    rows[1].machine = 1;
    markFrontier(rows);
    EXPECT_TRUE(rows[0].onFrontier && rows[1].onFrontier);
}

}  // namespace
}  // namespace sward::test
