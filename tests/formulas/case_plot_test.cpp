// Graphs and tables of hard cases.
#include "formulas/case_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

HardCase plottedCase(const std::string& key) {
    for (HardCase& h : hardCases())
        if (h.key == key) return h;
    ADD_FAILURE() << "no case " << key;
    return {};
}
constexpr PlotBox kBox{60, 30, 460, 230};
const double kNothing = std::nan("");

Plot graphOf(const HardCase& h, CaseGraph graph, double marked = kNothing) {
    Plot plot;
    plot.width = 500, plot.height = 300;
    addCaseGraph(plot, h, sweepCase(h), graph, kBox, {}, marked);
    return plot;
}

TEST(CasePlot, EveryLineAndDotOfEveryCaseLiesInItsBox) {
    for (const HardCase& h : hardCases()) {
        if (!isSwept(h)) continue;
        for (const CaseGraph graph : {CaseGraph::Values, CaseGraph::Errors}) {
            const Plot plot = graphOf(h, graph);
            EXPECT_GE(plot.lines.size(), 3u) << h.key;
            const auto inside = [&](const glm::dvec2& p) {
                return p.x >= kBox.left - 1e-6 && p.x <= kBox.right + 1e-6 && p.y >= kBox.top - 1e-6 &&
                       p.y <= kBox.bottom + 1e-6;
            };
            for (const PlotLine& l : plot.lines)
                for (const glm::dvec2& p : l.points) EXPECT_TRUE(inside(p)) << h.key << ' ' << p.x << ' ' << p.y;
            for (const PlotDot& d : plot.dots) EXPECT_TRUE(inside(d.at)) << h.key << ' ' << d.at.x << ' ' << d.at.y;
        }
    }
}

TEST(CasePlot, NoonIsAMarkOfThePrintedFormAloneAtTheLeftEdge) {
    const Plot plot = graphOf(plottedCase("B-1"), CaseGraph::Errors);
    const CaseColors colors;
    size_t marks = 0;
    for (const PlotDot& d : plot.dots)
        if (d.color == colors.published && d.at.y < kBox.top + 10) {
            ++marks;
            EXPECT_EQ(d.at.x, kBox.left);
        }
    EXPECT_EQ(marks, 1u);
    for (const PlotDot& d : plot.dots) EXPECT_FALSE(d.color == colors.ours && d.at.y < kBox.top + 10);
}

TEST(CasePlot, ThePrintedLevelsCrossOursWhereTheyTurnRound) {
    const Plot plot = graphOf(plottedCase("B-8"), CaseGraph::Values);
    const CaseColors colors;
    const auto ends = [&](const std::string& color) {
        double left = kNothing, right = kNothing;
        for (const PlotLine& l : plot.lines) {
            if (l.color != color || l.points.size() < 2) continue;
            if (l.points.front().x == kBox.left) left = l.points.front().y;
            if (l.points.back().x == kBox.right) right = l.points.back().y;
        }
        return std::pair(left, right);
    };
    const auto [oursNear, oursFar] = ends(colors.ours);
    const auto [printedNear, printedFar] = ends(colors.published);
    EXPECT_LT(oursNear, oursFar) << "up is less: ours draws blades near";
    EXPECT_GT(printedNear, printedFar) << "as printed they are far";
}

TEST(CasePlot, TheMarkedValueHasALine) {
    const HardCase h = plottedCase("B-8");
    EXPECT_EQ(graphOf(h, CaseGraph::Errors, 20).lines.size(), graphOf(h, CaseGraph::Errors).lines.size() + 1);
    EXPECT_EQ(graphOf(h, CaseGraph::Errors, 20).lines.back().points[0].x, (kBox.left + kBox.right) / 2);
}

TEST(CasePlot, APictureHasBothGraphsAndIsNotEmpty) {
    const Plot plot = casePlot(plottedCase("B-20"), 600, 500);
    EXPECT_EQ(plot.width, 600);
    const std::vector<uint8_t> pixels = plotPixels(plot);
    ASSERT_EQ(pixels.size(), 600u * 500u * 3u);
    for (const int half : {0, 1}) {
        const auto from = pixels.begin() + half * 600 * 250 * 3;
        EXPECT_GT(std::count_if(from, from + 600 * 250 * 3, [](uint8_t v) { return v < 128; }), 500);
    }
}

TEST(CasePlot, TheTableHasALineAPointAndNamesWhatIsNoNumber) {
    const HardCase h = plottedCase("B-1");
    const std::vector<CasePoint> points = sweepCase(h, 10);
    const std::string csv = caseCsv(h, points);
    EXPECT_EQ(static_cast<size_t>(std::count(csv.begin(), csv.end(), '\n')), points.size() + 1);
    EXPECT_NE(csv.find("\n0,nan,0,0,nan,0\n"), std::string::npos) << csv;
    const HardCase bare = plottedCase("H-1.2");
    EXPECT_NE(caseCsv(bare, sweepCase(bare, 10)).find(",,"), std::string::npos) << "it has no printed form";
}

TEST(CasePlot, NumbersAreShort) {
    EXPECT_EQ(caseNumber(0.0001), "0.0001");
    EXPECT_EQ(caseNumber(1.52345678e-8), "1.523e-08");
    EXPECT_EQ(caseNumber(std::nan("")), "NaN");
    EXPECT_EQ(caseNumber(-HUGE_VAL), "-inf");
}

}  // namespace
}  // namespace sward
