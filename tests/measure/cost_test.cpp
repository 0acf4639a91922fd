// What a sweep keeps and says, without drawing: settings, frontier, tables, parts, plots.
#include <gtest/gtest.h>

#include <set>

#include "core/json.h"
#include "measure/cost_files.h"
#include "measure/cost_plot.h"
#include "measure/cost_report.h"
#include "measure/cost_times.h"
#include "measure/fit.h"
#include "support.h"
#include "techniques.h"

namespace sward::test {
namespace {

Project grassy() {
    Project p;
    p.registry.add<GrassField>(*addEntity(p, "meadow"), {});
    return p;
}
CostRow row(int index, double ms, double error, const std::string& camera = "eye") {
    CostRow r;
    r.camera = camera, r.technique = "hybrid", r.settings = "maxGeom=" + std::to_string(index), r.index = index;
    r.msMedian = ms, r.msP95 = 2 * ms;
    r.metrics.appearance = {error, error / 2, error / 3, 0.1 * error};
    r.metrics.flip = 0.25, r.metrics.ssim = 0.5, r.metrics.rmse = 0.125, r.metrics.psnr = std::numeric_limits<double>::infinity();
    r.converged = r.metrics.appearance;
    r.gpuBytes = 1000, r.image = "row.png";
    return r;
}
CostRun run(std::vector<CostRow> rows, int total) {
    CostRun r;
    r.project = "park", r.hash = "abc", r.width = 320, r.height = 240, r.samples = 64, r.lighting = "full", r.total = total;
    r.machines = {{"llvmpipe", "wall-finish", 2}};
    r.floors = {{"eye", {0.01, 0.01, 0, 0.001}, {0.02, 0.01, 0, 0.001}, {0.2, 0.1, 0.1, 0.001}, 0.004, "truth.png"}};
    r.rows = std::move(rows);
    return r;
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
        EXPECT_STREQ(kTechniques[copy.registry.get<GrassField>(findEntity(copy, "meadow"))->technique], s.technique.c_str());
        const GrassField& f = *copy.registry.get<GrassField>(findEntity(copy, "meadow"));
        EXPECT_LE(f.minGeom, f.maxGeom) << s.text();
        EXPECT_LE(f.minBTF, f.maxBTF) << s.text();
        EXPECT_TRUE(texts.insert(s.technique + " " + s.text()).second) << s.text();
    }
    for (const char* name : kTechniques) EXPECT_TRUE(std::any_of(all->begin(), all->end(), [&](const CostSetting& s) { return s.technique == name; })) << name;
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
    EXPECT_FALSE(drawsNoLess({"hybrid", {"sharpness=2", "msaa=4"}}, {"hybrid", {"sharpness=1", "msaa=4"}})) << "what sharpness costs is not known";
}

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

TEST(CostFrontier, HoldsWhatNoneBeatsInBoth) {
    std::vector<CostRow> rows = {row(0, 10, 0.1), row(1, 20, 0.05), row(2, 25, 0.06), row(3, 40, 0.01), row(4, 9, 0.3), row(5, 10, 0.1), row(6, 1, 0.001, "other"), row(7, 1, 0.0001)};
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

TEST(CostFiles, CsvHasTheColumnsPromised) {
    std::vector<CostRow> rows = {row(0, 10, 0.1), row(1, 20, 0.05)};
    rows[1].skipped = "1e9 blades, \"too many\"";
    const std::string csv = costCsv(run(rows, 2));
    EXPECT_EQ(csv,
              "camera,technique,settings,ms_median,ms_p95,appearance,appearance_sigma,bias,contrast,flip,rmse,gpu_bytes,on_frontier,skipped\n"
              "eye,hybrid,maxGeom=0,10,20,0.1,0.010000000000000002,0.05,0.03333333333333333,0.25,0.125,1000,0,\n"
              "eye,hybrid,maxGeom=1,,,,,,,,,,0,\"1e9 blades, \"\"too many\"\"\"\n");
}
TEST(CostFiles, JsonComesBackBitForBit) {
    CostRun before = run({row(0, 10.0 / 3, 0.1 / 3), row(1, std::numeric_limits<double>::quiet_NaN(), 0.05)}, 2);
    before.rows[0].ms = {3, 10.0 / 3}, before.rows[0].msSigma = 0.1;
    before.rows[0].metrics.appearance.sigma = std::numeric_limits<double>::quiet_NaN();
    const std::string text = writeJson(costJson(before));
    auto json = parseJson(text, "cost.json");
    ASSERT_TRUE(json) << json.error().text();
    auto after = costFrom(*json, "cost.json");
    ASSERT_TRUE(after) << after.error().text();
    EXPECT_EQ(writeJson(costJson(*after)), text);
    json->object.erase("floors");
    auto broken = costFrom(*json, "cost.json");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().code, ExitCode::Unsound);
    EXPECT_NE(broken.error().message.find("floors"), std::string::npos);
}

TEST(CostMerge, OfPartsIsTheWholeInOrder) {
    const CostRun whole = run({row(0, 1, 1), row(1, 2, 0.5), row(2, 3, 0.2)}, 3);
    auto merged = mergeCosts({run({row(1, 2, 0.5)}, 3), run({row(0, 1, 1), row(2, 3, 0.2)}, 3)});
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_EQ(merged->machines.size(), 2u);
    EXPECT_EQ(merged->rows[1].machine, 0);
    EXPECT_EQ(merged->rows[2].machine, 1);
    for (CostRow& r : merged->rows) r.machine = 0;
    merged->machines.resize(1);
    EXPECT_EQ(writeJson(costJson(*merged)), writeJson(costJson(whole)));
}
TEST(CostMerge, RefusesOtherSweepsAndMissingOrDoubleRows) {
    CostRun other = run({row(1, 2, 0.5)}, 2);
    other.hash = "def";
    const CostRun first = run({row(0, 1, 1)}, 2), second = run({row(1, 2, 0.5)}, 2);
    EXPECT_FALSE(mergeCosts({first, other}));
    EXPECT_NE(mergeCosts({first, first}).error().message.find("two parts"), std::string::npos);
    EXPECT_NE(mergeCosts({first}).error().message.find("row 1 is in none"), std::string::npos);
    EXPECT_NE(mergeCosts({second}).error().message.find("row 0 is in none"), std::string::npos);
    EXPECT_FALSE(mergeCosts({}));
}

TEST(CostPlot, ShowsEachRowTheFrontierAndTheFloors) {
    CostRun r = run({row(0, 10, 0.1), row(1, 20, 0.05), row(2, 30, 0.07)}, 3);
    markFrontier(r.rows);
    const Plot plot = costPlot(r, "eye");
    EXPECT_EQ(std::count_if(plot.dots.begin(), plot.dots.end(), [](const PlotDot& d) { return d.title.find("maxGeom") != std::string::npos; }), 3);
    for (const char* label : {"other blades of the field", "flat rows", "milliseconds a frame (median)"})
        EXPECT_TRUE(std::any_of(plot.texts.begin(), plot.texts.end(), [&](const PlotText& t) { return t.text == label; })) << label;
    EXPECT_GT(plot.dots[0].at.y, 0);
    EXPECT_LT(plot.dots[0].at.x, plot.dots[1].at.x) << "slower is farther right";
    EXPECT_LT(plot.dots[0].at.y, plot.dots[1].at.y) << "worse is higher";
    EXPECT_EQ(costPlot(r, "nobody").width, 0);
    const auto pixels = plotPixels(plot);
    const size_t at = 3 * (static_cast<size_t>(plot.dots[1].at.y) * static_cast<size_t>(plot.width) + static_cast<size_t>(plot.dots[1].at.x));
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
    for (const char* outside : {"src=\"http", "href=", "url(", "@import", "src=\"row"}) EXPECT_EQ(html.find(outside), std::string::npos) << outside;
    for (const char* file : {"cost.csv", "cost.json", "plot-eye.svg", "plot-eye.png"}) EXPECT_TRUE(std::filesystem::exists(dir / file)) << file;
}
TEST(CostReport, Base64IsTheStandards) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(FitCameras, HeldOutOnesStandAsideAndLookElsewhere) {
    const ViewCamera c{{2, 1.7, 3}, {10, 0, 9}, 55, 0};
    const ViewCamera m = heldOutCameras({c})[0];
    const double length = glm::length(c.target - c.eye);
    EXPECT_NEAR(glm::length(m.eye - c.eye), length / 8, 1e-9);
    EXPECT_NEAR(glm::length(m.target - m.eye), length, 1e-9);
    const glm::dvec2 a(c.target.x - c.eye.x, c.target.z - c.eye.z), b(m.target.x - m.eye.x, m.target.z - m.eye.z);
    EXPECT_NEAR(glm::dot(a, b) / (glm::length(a) * glm::length(b)), std::cos(glm::radians(20.0)), 1e-9);
    EXPECT_EQ(m.eye.y, c.eye.y);
}

}  // namespace
}  // namespace sward::test
