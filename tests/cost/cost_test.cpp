// What a sweep keeps and says, without drawing: settings, frontier, plots, report.
#include <gtest/gtest.h>

#include <set>

#include "cost/cost_plot.h"
#include "cost/cost_report.h"
#include "cost/cost_rows.h"
#include "cost/fit.h"
#include "support.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

Project grassy() {
    Project p;
    p.registry.add<GrassField>(*addEntity(p, "meadow"), {});
    return p;
}
TEST(CostSettings, EachAppliesToAProjectAndNoneIsThereTwice) {
    const Project p = grassy();
    auto all = costSettings(p);
    ASSERT_TRUE(all);
    EXPECT_GE(all->size(), 35u);
    EXPECT_LE(all->size(), 48u);
    std::set<std::string> texts;
    for (const CostSetting& s : *all) {
        Project copy = snapshot(p, tables().components);
        ViewSettings view;
        const Status done = applySetting(copy, tables(), s, view);
        EXPECT_TRUE(done) << s.technique << " " << s.text() << ": " << done.error().text();
        EXPECT_STREQ(kTechniques[copy.registry.get<GrassField>(findEntity(copy, "meadow"))->technique],
                     s.technique.c_str());
        const GrassField& f = *copy.registry.get<GrassField>(findEntity(copy, "meadow"));
        EXPECT_LE(f.minGeom, f.maxGeom) << s.text();
        EXPECT_LE(f.minBTF, f.maxBTF) << s.text();
        EXPECT_TRUE(texts.insert(s.technique + " " + s.text()).second) << s.text();
    }
    for (const char* name : kTechniques)
        EXPECT_TRUE(std::any_of(all->begin(), all->end(), [&](const CostSetting& s) { return s.technique == name; }))
            << name;
}
TEST(CostSettings, AskedForOneTechniqueGiveThatAlone) {
    auto flat = costSettings(grassy(), "flat");
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->size(), 2u);
    EXPECT_EQ(costSettings(grassy(), "felt").error().code, ExitCode::Usage);
    EXPECT_EQ(costSettings(Project{}).error().code, ExitCode::Unsound);
    Project p = grassy();
    ViewSettings view;
    EXPECT_EQ(applySetting(p, tables(), {"hybrid", {"msaa=0"}}, view).error().code, ExitCode::Usage);
    EXPECT_EQ(applySetting(p, tables(), {"hybrid", {"maxGeom=far"}}, view).error().code, ExitCode::Usage);
    EXPECT_EQ(applySetting(p, tables(), {"hybrid", {"felt=1"}}, view).error().code, ExitCode::Usage);
}

TEST(CostSettings, WhatDrawsNoLessThanASlowOneIsTakenForSlow) {
    const CostSetting slow{"hybrid", {"maxGeom=5", "maxBTF=9", "msaa=1"}};
    EXPECT_TRUE(drawsNoLess(slow, slow));
    EXPECT_TRUE(drawsNoLess({"hybrid", {"maxGeom=5", "maxBTF=20", "msaa=4"}}, slow));
    EXPECT_TRUE(drawsNoLess({"hybrid", {"maxGeom=inf", "maxBTF=9", "msaa=1"}}, slow));
    EXPECT_FALSE(drawsNoLess({"hybrid", {"maxGeom=4.9", "maxBTF=20", "msaa=4"}}, slow));
    EXPECT_FALSE(drawsNoLess({"hybrid", {"maxGeom=9", "maxBTF=9"}}, slow)) << "says nothing of samples";
    EXPECT_FALSE(drawsNoLess({"geometry", {"maxGeom=5", "maxBTF=9", "msaa=1"}}, slow));
    EXPECT_FALSE(drawsNoLess({"hybrid", {"sharpness=2", "msaa=4"}}, {"hybrid", {"sharpness=1", "msaa=4"}}))
        << "what sharpness costs is not known";
}

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

TEST(CostPlot, ShowsEachRowTheFrontierAndTheFloors) {
    CostRun r = run({row(0, 10, 0.1), row(1, 20, 0.05), row(2, 30, 0.07)}, 3);
    markFrontier(r.rows);
    const Plot plot = costPlot(r, "eye");
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
    EXPECT_EQ(costPlot(r, "nobody").width, 0);
    const auto pixels = plotPixels(plot);
    const size_t at = 3 * (static_cast<size_t>(plot.dots[1].at.y) * static_cast<size_t>(plot.width) +
                           static_cast<size_t>(plot.dots[1].at.x));
    EXPECT_EQ(pixels[at], 0x00);
    EXPECT_EQ(pixels[at + 1], 0x9e);
    EXPECT_EQ(pixels[0], 255);
}
TEST(CostReport, IsOneFileThatRefersToNothingElse) {
    const TempDir dir;
    CostRun r = run({row(0, 10, 0.1), row(1, 20, 0.05)}, 2);
    r.project = "<park> & co";
    markFrontier(r.rows);
    const std::vector<uint8_t> gray(20 * 20 * 3, 128);
    ASSERT_TRUE(writeImagePng(dir / "row.png", 20, 20, 3, gray));
    ASSERT_TRUE(writeImagePng(dir / "truth.png", 20, 20, 3, gray));
    ASSERT_TRUE(writeCostFiles(r, dir.path, dir.path));
    const std::string html = readText(dir / "report.html");
    EXPECT_NE(html.find("&lt;park&gt; &amp; co"), std::string::npos);
    EXPECT_NE(html.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
    for (const char* outside : {"src=\"http", "href=", "url(", "@import", "src=\"row"})
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
    for (const char* file : {"cost.csv", "cost.json", "plot-eye.svg", "plot-eye.png"})
        EXPECT_TRUE(std::filesystem::exists(dir / file)) << file;
}
TEST(CostReport, Base64IsTheStandards) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

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

}  // namespace
}  // namespace sward::test
