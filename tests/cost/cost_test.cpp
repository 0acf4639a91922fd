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
TEST(CostFrontier, NeverJoinsTimesOfTwoMachines) {
    std::vector<CostRow> rows = {row(0, 10, 0.1), row(1, 5, 0.05)};
    rows[1].machine = 1;
    markFrontier(rows);
    EXPECT_TRUE(rows[0].onFrontier && rows[1].onFrontier);
}

}  // namespace
}  // namespace sward::test
