// The plot of a sweep: what it shows and where.
#include "cost/cost_plot.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cost/cost_rows.h"
#include "techniques.h"

namespace sward::test {
namespace {

TEST(CostPlot, ShowsEachRowTheFrontierAndTheFloors) {
    CostRun r = run({row(0, 10, 0.1), row(1, 20, 0.05), row(2, 30, 0.07)}, 3);
    markFrontier(r.rows);
    const Plot plot = costPlot(r, "eye", tables().techniques);
    EXPECT_EQ(std::count_if(plot.dots.begin(), plot.dots.end(),
                            [](const PlotDot& d) { return d.title.find("maxGeom") != std::string::npos; }),
              3);
    for (const char* label : {"other blades of the field", "flat rows", "milliseconds a frame (median)"})
        EXPECT_TRUE(std::any_of(plot.texts.begin(), plot.texts.end(), [&](const PlotText& t) {
            return t.text == label;
        })) << label;
    EXPECT_GT(plot.dots[0].at.y, 0);
    EXPECT_LT(plot.dots[0].at.x, plot.dots[1].at.x) << "slower is farther right";
    EXPECT_LT(plot.dots[0].at.y, plot.dots[1].at.y) << "worse is higher";
    EXPECT_EQ(costPlot(r, "nobody", tables().techniques).width, 0);
    const auto pixels = plotPixels(plot);
    const size_t at = 3 * (static_cast<size_t>(plot.dots[1].at.y) * static_cast<size_t>(plot.width) +
                           static_cast<size_t>(plot.dots[1].at.x));
    EXPECT_EQ(pixels[at], 0x00);
    EXPECT_EQ(pixels[at + 1], 0x9e);
    EXPECT_EQ(pixels[0], 255);
}

TEST(CostPlot, HasABarForEachErrorAndARingForWhatShips) {
    CostRun r = run({row(0, 10, 0.1), row(1, 20, 0.05)}, 2);
    markFrontier(r.rows);
    const auto linesOf = [](const CostRun& of) { return costPlot(of, "eye", tables().techniques).lines.size(); };
    const size_t withoutTimes = linesOf(r);
    r.rows[0].msSigma = 1;
    EXPECT_EQ(linesOf(r), withoutTimes + 3) << "a bar and its two ends";
    r.rows[0].metrics.appearance.sigma = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(linesOf(r), withoutTimes);
    const auto rings = [](const CostRun& of) {
        const Plot plot = costPlot(of, "eye", tables().techniques);
        return std::count_if(plot.dots.begin(), plot.dots.end(),
                             [](const PlotDot& d) { return d.title == "as the project ships" && !d.filled; });
    };
    EXPECT_EQ(rings(r), 0);
    r.rows[1].settings = kAsItIs;
    EXPECT_EQ(rings(r), 1);
}

}  // namespace
}  // namespace sward::test
