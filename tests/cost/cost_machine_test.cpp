// Times of several machines: never in one table, and one frontier each.
#include "cost/cost_machine.h"

#include <gtest/gtest.h>

#include "cost/cost_files.h"
#include "cost/cost_rows.h"

namespace sward::test {
namespace {

CostRun partBy(const std::string& host, std::vector<CostRow> rows, int total) {
    CostRun r = run(std::move(rows), total);
    r.machines[0].host = host, r.machines[0].cpu = "a processor";
    return r;
}

TEST(CostMachine, ThisOneSaysItsNameAndThreads) {
    const CostMachine m = thisMachine("llvmpipe", "wall-finish");
    EXPECT_FALSE(m.host.empty());
    EXPECT_GE(m.cores, 1);
    EXPECT_TRUE(isSameMachine(m, thisMachine("llvmpipe", "wall-finish")));
    EXPECT_FALSE(isSameMachine(m, thisMachine("another driver", "wall-finish")));
}
TEST(CostMachine, PartsOfOneAreOneAndOfUnknownOnesNever) {
    const auto joined = mergeCosts(
        {partBy("a", {row(0, 1, 1)}, 3), partBy("b", {row(1, 2, 0.5)}, 3), partBy("a", {row(2, 3, 0.2)}, 3)});
    ASSERT_TRUE(joined) << joined.error().text();
    ASSERT_EQ(joined->machines.size(), 2u);
    EXPECT_EQ(joined->rows[0].machine, joined->rows[2].machine);
    EXPECT_NE(joined->rows[0].machine, joined->rows[1].machine);
    EXPECT_EQ(mergeCosts({run({row(0, 1, 1)}, 2), run({row(1, 2, 0.5)}, 2)})->machines.size(), 2u);
}
// Row 1 is beaten by row 0 on a machine of its own alone.
TEST(CostMachine, FrontiersAreEachMachinesOwn) {
    std::vector<CostRow> rows = {row(0, 1, 0.1), row(1, 5, 0.9)};
    for (CostRow& r : rows) r.msSigma = 0, r.metrics.appearance.sigma = 0, r.onFrontier = true;  // each of its own part
    const auto one = mergeCosts({partBy("a", {rows[0]}, 2), partBy("a", {rows[1]}, 2)});
    const auto two = mergeCosts({partBy("a", {rows[0]}, 2), partBy("b", {rows[1]}, 2)});
    ASSERT_TRUE(one && two);
    EXPECT_TRUE(one->rows[0].onFrontier && !one->rows[1].onFrontier);
    EXPECT_TRUE(two->rows[0].onFrontier && two->rows[1].onFrontier);
}
TEST(CostMachine, EachHasATableOfItsOwnRows) {
    const auto joined = mergeCosts(
        {partBy("a/b", {row(0, 1, 1)}, 3), partBy("a b", {row(1, 2, 0.5)}, 3), partBy("", {row(2, 3, 0.2)}, 3)});
    ASSERT_TRUE(joined);
    const auto tables = runsByMachine(*joined);
    ASSERT_EQ(tables.size(), 3u);
    EXPECT_EQ(tables[0].first, "a-b");
    EXPECT_EQ(tables[1].first, "a-b-2");
    EXPECT_EQ(tables[2].first, "machine");
    for (size_t i = 0; i < tables.size(); ++i) {
        ASSERT_EQ(tables[i].second.rows.size(), 1u);
        EXPECT_EQ(tables[i].second.rows[0].index, static_cast<int>(i));
        EXPECT_EQ(tables[i].second.machines.size(), 1u);
    }
}

}  // namespace
}  // namespace sward::test
