// A small sweep and a small fit from end to end: what is kept, what a stop leaves, what shards join to.
#include "core/json.h"
#include "cost/cost_files.h"
#include "cost/fit.h"
#include "fields.h"
#include "scene/forest_technique.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

Project small_() {
    Project p = lawn();
    put(p, "ground", Terrain{}).size = {8, 8};
    FlatField f = flatField(p, "grass");
    f.minGeom = 1, f.maxGeom = 2, f.minBTF = 3, f.maxBTF = 4;
    f.slices = 3, f.sliceWidth = 32, f.sliceHeight = 16, f.farSize = 32;
    put(p, "eye", Camera{{1, 1, 1}, {4, 0, 4}, 50, 0});
    return p;
}
CostRequest request(const Project& p, const TempDir& dir, const std::string& folder) {
    CostRequest r;
    r.views = {{"eye", viewOf(*findCamera(p, "eye"))}};
    r.width = 48, r.height = 36, r.rounds = 1, r.maxMs = 1e6;
    r.truth.samples = 64, r.truth.lighting = ReferenceLighting::Direct;
    r.settings = {{"hybrid", {"msaa=4"}},
                  {"hybrid", {"maxGeom=3", "msaa=1"}},
                  {"flat", {"msaa=4"}},
                  {"geometry", {"detail=0.5"}}};
    r.folder = dir / folder;
    return r;
}
bool go(const std::string&, double) { return true; }

// All but what a clock says.
std::string withoutTimes(CostRun run) {
    for (CostRow& r : run.rows) r.msMedian = r.msP95 = r.msSigma = 0, r.ms.clear(), r.onFrontier = false, r.machine = 0;
    run.machines.clear();
    return writeJson(costJson(run));
}

TEST(CostSweep, MeasuresEachRowAndIsReadWhenRunAgain) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = small_();
    auto first = runCost(request(p, dir, "a"), p, tables(), gpu(), go);
    ASSERT_TRUE(first) << first.error().text();
    ASSERT_EQ(first->rows.size(), 4u);
    for (const CostRow& r : first->rows) {
        EXPECT_EQ(r.skipped, "") << r.settings;
        EXPECT_GT(r.msMedian, 0) << r.settings;
        EXPECT_GT(r.metrics.appearance.distance, 0) << r.settings;
        EXPECT_GT(r.converged.distance, 0) << r.settings;
        EXPECT_GT(r.gpuBytes, 0u) << r.settings;
    }
    EXPECT_TRUE(std::any_of(first->rows.begin(), first->rows.end(), [](const CostRow& r) { return r.onFrontier; }));
    const CostFloors& f = first->floors[0];
    EXPECT_GT(f.seed.distance, 0);
    EXPECT_GT(f.sampling.distance, 0);
    EXPECT_GT(f.flat.contrast, f.seed.contrast)
        << "in so small a picture a few blades make the mean, but flat rows have no contrast";
    auto again = runCost(request(p, dir, "a"), p, tables(), gpu(), go);
    ASSERT_TRUE(again);
    EXPECT_EQ(writeJson(costJson(*again)), writeJson(costJson(*first))) << "times too: nothing was measured again";
}

// Whatever moment it is stopped at; and in two shards.
TEST(CostSweep, StoppedAndGoneOnOrInShardsIsTheSame) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = small_();
    auto whole = runCost(request(p, dir, "whole"), p, tables(), gpu(), go);
    ASSERT_TRUE(whole) << whole.error().text();
    int stops = 0;
    for (int patience = 4;; patience *= 3) {
        auto part = runCost(request(p, dir, "stopped"), p, tables(), gpu(),
                            [calls = 0, patience](const std::string&, double) mutable { return ++calls < patience; });
        if (part) {
            EXPECT_EQ(withoutTimes(*part), withoutTimes(*whole));
            break;
        }
        ASSERT_EQ(part.error().code, ExitCode::Interrupted);
        for (const auto& entry : std::filesystem::directory_iterator(dir / "stopped"))
            EXPECT_NE(entry.path().extension(), ".part") << entry.path();
        ASSERT_LT(++stops, 12);
    }
    EXPECT_GE(stops, 2);

    std::vector<CostRun> parts;
    for (int i = 1; i >= 0; --i) {
        CostRequest r = request(p, dir, fmt::format("shard{}", i));
        std::filesystem::create_directories(r.folder);
        for (const auto& e : std::filesystem::directory_iterator(dir / "whole"))  // truths need not be traced again
            if (e.path().filename().string().starts_with("truth"))
                std::filesystem::copy(e.path(), r.folder / e.path().filename());
        r.shard = i, r.shards = 2;
        auto part = runCost(r, p, tables(), gpu(), go);
        ASSERT_TRUE(part) << part.error().text();
        EXPECT_EQ(part->rows.size(), 2u);
        parts.push_back(std::move(*part));
    }
    auto merged = mergeCosts(parts);
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_EQ(withoutTimes(*merged), withoutTimes(*whole));
}

TEST(CostSweep, LeavesOutWhatTakesTooLongAndSaysSo) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = small_();
    CostRequest r = request(p, dir, "a");
    r.maxMs = 1e-3;
    r.settings.push_back({"hybrid", {}});
    auto run = runCost(r, p, tables(), gpu(), go);
    ASSERT_TRUE(run) << run.error().text();
    for (const CostRow& row : run->rows) {
        EXPECT_NE(row.skipped.find("the limit is"), std::string::npos);
        if (row.settings == kAsItIs) EXPECT_EQ(row.skipped.find("a frame took"), 0u) << "not by what was reckoned";
        EXPECT_FALSE(row.onFrontier);
    }
    EXPECT_NE(costCsv(*run).find("the limit is"), std::string::npos);
}

// One camera now and 0.4 s later, in wind: blades have moved in the truth and in the pictures, and each picture is held
// against its own.
TEST(CostSweep, MomentsHaveTheirOwnSecond) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = small_();
    put(p, "wind", Wind{}).strength = 1;
    CostRequest r = request(p, dir, "a");
    r.views.push_back({"eye later", r.views[0].camera, 0.4});
    r.settings = {{"geometry", {"msaa=4"}}};
    auto run = runCost(r, p, tables(), gpu(), go);
    ASSERT_TRUE(run) << run.error().text();
    ASSERT_EQ(run->rows.size(), 2u);
    EXPECT_NE(run->rows[0].metrics.rmse, run->rows[1].metrics.rmse);
    EXPECT_NE(run->floors[0].seed.distance, run->floors[1].seed.distance);
    const auto pixels = [&](const std::string& file) { return readImage(dir / "a" / file, true)->pixels; };
    EXPECT_NE(pixels(run->floors[0].image), pixels(run->floors[1].image));
    EXPECT_NE(pixels(run->rows[0].image), pixels(run->rows[1].image));
    const auto apart = [&](size_t row, size_t truth) {
        const auto a = pixels(run->rows[row].image), b = pixels(run->floors[truth].image);
        double sum = 0;
        for (size_t i = 0; i < a.size(); ++i) sum += static_cast<double>((a[i] - b[i]) * (a[i] - b[i]));
        return sum;
    };
    for (size_t i = 0; i < 2; ++i) EXPECT_LT(apart(i, i), apart(i, 1 - i)) << "nearer to its own second's truth";
}

TEST(CostSweep, HasTheProjectAsItShipsAndEachPictureOnce) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = small_();
    CostRequest r = request(p, dir, "whole");
    r.settings = {
        {"hybrid", {}}, {"hybrid", {"maxGeom=2", "msaa=4"}}, {"hybrid", {"sharpness=0"}}, {"flat", {"msaa=4"}}};
    const auto whole = runCost(r, p, tables(), gpu(), go);
    ASSERT_TRUE(whole) << whole.error().text();
    ASSERT_EQ(whole->rows.size(), 3u) << "maxGeom is 2 as it is";
    EXPECT_EQ(whole->rows[0].settings, kAsItIs);
    EXPECT_EQ(whole->rows[1].settings, "sharpness=0");
    EXPECT_EQ(whole->total, 3);
    std::vector<CostRun> parts;
    for (int i = 0; i < 2; ++i) {
        r.shard = i, r.shards = 2;
        auto part = runCost(r, p, tables(), gpu(), go);
        ASSERT_TRUE(part) << part.error().text();
        parts.push_back(std::move(*part));
    }
    const auto merged = mergeCosts(parts);
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_EQ(withoutTimes(*merged), withoutTimes(*whole));
}

// A wood without any grass, from the side: its three techniques are rows of one table, held against traced trees.
TEST(CostSweep, HoldsVolumesMeshesAndTheFlatPictureOfAForestAgainstItsTruth) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = lawn();
    removeEntity(p, "grass");
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {100, 100};
    put<Forest>(p, "trees", {.species = {{.leaves = 1500}}, .meshesTo = 0});
    put(p, "eye", Camera{{50, 7, 150}, {50, 5, 60}, 35, 0});
    CostRequest r = request(p, dir, "wood");
    r.width = 96, r.height = 64;
    r.settings = {{"forest-texcells", {}},
                  {"forest-texcells", {"silhouetteDeg=0", "msaa=4"}},
                  {"forest-trees", {"meshDetail=1", "msaa=4"}},
                  {"forest-flat", {"msaa=4"}}};
    const auto run = runCost(r, p, tables(), gpu(), go);
    ASSERT_TRUE(run) << run.error().text();
    ASSERT_EQ(run->rows.size(), 4u) << "each draws another picture";
    std::map<std::string, double> errorOf;
    for (const CostRow& row : run->rows) {
        EXPECT_EQ(row.skipped, "") << row.technique;
        errorOf[row.technique] = std::max(errorOf[row.technique], row.metrics.appearance.distance);
        std::printf("%s %s: %.4f\n", row.technique.c_str(), row.settings.c_str(), row.metrics.appearance.distance);
    }
    EXPECT_GT(errorOf["forest-trees"], 0);
    EXPECT_LT(errorOf["forest-trees"], errorOf["forest-flat"]);
    EXPECT_LT(errorOf["forest-texcells"], errorOf["forest-flat"]);
    EXPECT_NE(costCsv(*run).find("eye,forest-flat,"), std::string::npos);
}

TEST(Fit, FindsSettingsWithinTheBudgetOrNamesTheNearest) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = small_();
    FitRequest r;
    r.cost = request(p, dir, "fit");
    r.candidates = 6;
    r.budgetMs = 1e6;
    auto wide = runFit(r, p, tables(), gpu(), go);
    ASSERT_TRUE(wide) << wide.error().text();
    EXPECT_TRUE(wide->fits);
    EXPECT_LT(wide->fitted.appearance, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(wide->given.known()) << "all fit, so nothing was given up";
    EXPECT_GE(wide->tried, 20);  // of the search and of the grid, each once
    EXPECT_GT(wide->heldOut.fitted.appearance, 0);
    EXPECT_GT(wide->heldOut.shipped.appearance, 0);
    EXPECT_FALSE(wide->unseen.rival.empty());
    r.budgetMs = 1e-6;
    auto none = runFit(r, p, tables(), gpu(), go);
    ASSERT_TRUE(none) << none.error().text();
    EXPECT_FALSE(none->fits);
    EXPECT_FALSE(none->fitted.setting.values.empty());
    EXPECT_GT(none->fitted.ms, 0);
}

// Far less time than the search would take: it measures one, the project as it is, and says that it was cut short.
TEST(Fit, HasAnAnswerHoweverLittleTimeThereIs) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = small_();
    FitRequest r;
    r.cost = request(p, dir, "fit");
    r.candidates = 40;
    r.budgetMs = 1e6;
    r.seconds = 1e-6;
    std::vector<FitCandidate> told;
    r.betterFound = [&](const FitResult& so) {
        EXPECT_TRUE(so.fits && so.cutShort);
        told.push_back(so.fitted);
    };
    const auto fit = runFit(r, p, tables(), gpu(), go);
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_TRUE(fit->fits);
    EXPECT_TRUE(fit->cutShort);
    EXPECT_EQ(fit->truthSamples, 2);
    EXPECT_EQ(fit->tried, 2);
    EXPECT_FALSE(fit->gridBest.known());
    EXPECT_NE(fit->heldOut.note.find("no time was left"), std::string::npos) << fit->heldOut.note;
    EXPECT_EQ(chosen(*fit).setting.text(), fit->fitted.setting.text());
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told[0].setting.text(), fit->fitted.setting.text());
}

// Every blade drawn by itself is the truth but for its light. A search of three candidates gets nowhere near what
// ships, nor near the grid around it.
TEST(Fit, LosesWhereItSeesTooLittle) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = small_();
    flatField(p, "grass").technique = "geometry";
    FitRequest r;
    r.cost = request(p, dir, "fit");
    r.cost.width = 96, r.cost.height = 72, r.cost.truth.samples = 32;
    r.candidates = 3;
    r.budgetMs = 1e6;
    const auto fit = runFit(r, p, tables(), gpu(), go);
    ASSERT_TRUE(fit) << fit.error().text();
    std::printf("  fitted %.4f, shipped %.4f, grid %.4f; held out %.4f, %.4f, %.4f\n", fit->fitted.appearance,
                fit->shipped.appearance, fit->gridBest.appearance, fit->heldOut.fitted.appearance,
                fit->heldOut.shipped.appearance, fit->heldOut.grid.appearance);
    EXPECT_EQ(fit->seen.outcome, FitOutcome::Loses);
    EXPECT_EQ(fit->unseen.outcome, FitOutcome::Loses);
    EXPECT_GT(fit->fitted.appearance, fit->shipped.appearance);
    EXPECT_GT(fit->heldOut.fitted.appearance, fit->heldOut.shipped.appearance);
    EXPECT_NE(chosen(*fit).setting.text(), fit->fitted.setting.text()) << "what loses is not saved";
}

TEST(Fit, TurnsTheForestWhereThereIsNoGrass) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = small_();
    removeEntity(p, "grass");
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {40, 40};
    put<Forest>(p, "trees", {.species = {{.leaves = 300}}, .meshesTo = 20, .voxel = 0.5f});
    FitRequest r;
    r.cost = request(p, dir, "fit");
    r.cost.views[0].camera = {{20, 25, 60}, {20, 3, 20}, 45, 0};
    r.candidates = 6;
    r.budgetMs = 1e6;
    const auto fit = runFit(r, p, tables(), gpu(), go);
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_TRUE(fit->fits);
    EXPECT_TRUE(findForestTechnique(fit->fitted.setting.technique)) << fit->fitted.setting.technique;
    EXPECT_LT(fit->fitted.appearance, 0.2);
    EXPECT_GE(fit->tried, 20) << "of the search and of the grid, each once";
    ViewSettings view;
    EXPECT_TRUE(applySetting(p, tables(), chosen(*fit).setting, view));
    p.registry.get<Forest>(findEntity(p, "trees"))->perHectare = 0;
    EXPECT_FALSE(runFit(r, p, tables(), gpu(), go)) << "nothing grows";
}

}  // namespace
}  // namespace sward::test
