// Where a project's own settings stand in a sweep.
#include "cost/cost_shipped.h"

#include <gtest/gtest.h>

#include "cost/cost_rows.h"

namespace sward::test {
namespace {

CostRow shipped(double ms, double error, const std::string& camera = "eye") {
    CostRow r = row(0, ms, error, camera);
    r.settings = kAsItIs;
    return r;
}

TEST(CostShipped, IsHeldAgainstOtherBladesAndFlatRows) {
    const CostRun r = run({shipped(10, 0.03), row(1, 20, 0.1)}, 2);
    const auto standings = shippedStandings(r);
    ASSERT_EQ(standings.size(), 1u);
    EXPECT_NEAR(standings[0].ofBlades, 3, 1e-9);
    EXPECT_NEAR(standings[0].ofFlatRows, 0.15, 1e-9);
    EXPECT_TRUE(standings[0].beatenBy.empty());
    EXPECT_EQ(standingText(standings[0]), "3.00 times other blades, 0.15 of flat rows, on the frontier");
}

TEST(CostShipped, NamesTheNearestOfThoseThatBeatIt) {
    CostRow slower = row(4, 90, 0.001), left = row(5, 1, 0.001), elsewhere = row(6, 1, 0.001);
    left.skipped = "too long", elsewhere.machine = 1;
    const CostRun r =
        run({shipped(10, 0.1), row(1, 5, 0.09), row(2, 5, 0.05), row(3, 9, 0.2), slower, left, elsewhere}, 7);
    const auto standings = shippedStandings(r);
    ASSERT_EQ(standings.size(), 1u);
    ASSERT_EQ(standings[0].beatenBy.size(), 2u);
    EXPECT_EQ(standings[0].beatenBy[0]->settings, "maxGeom=2");
    EXPECT_NE(standingText(standings[0]).find("beaten by hybrid maxGeom=2, 0.0500 at 5 ms, and 1 more"),
              std::string::npos);
}

TEST(CostShipped, HasARowACameraThatWasDrawn) {
    CostRow left = shipped(10, 0.1, "far");
    left.skipped = "too long";
    CostRun r = run({shipped(10, 0.03), left}, 2);
    r.floors.push_back({"far"}), r.floors.push_back({"none"});
    EXPECT_EQ(shippedRows(r), "| `park` | 320x240 | `eye` | 0.0300 ± 0.0030 | 10 | 3.00 | 0.15 | on the frontier |\n");
    const auto columns = [](const std::string& line) { return std::count(line.begin(), line.end(), '|'); };
    EXPECT_EQ(columns(shippedHeader()), 2 * columns(shippedRows(r)));
}

}  // namespace
}  // namespace sward::test
