// The accuracy panel through its real widgets, at a small size.
#include <epoxy/gl.h>
#include <signal.h>

#include "core/file.h"
#include "cost/cost_files.h"
#include "editor/editor_fixture.h"
#include "maps/map_io.h"

namespace sward {
namespace {

class EditorAccuracy : public test::EditorFixture {
  protected:
    // A window whose viewport is small, so that pictures come soon.
    void SetUp() override {
        ASSERT_NE(gpu, nullptr);
        ASSERT_TRUE(doc.create(dir / "meadow"));
        app = std::make_unique<EditorApp>(doc, *gpu, ui::makeHeadlessSurface(760, 520), false);
        app->layout.right = 330, app->layout.bottom = app->layout.accuracy = 290;  // tabs take three lines
        ui = makeUiDriver(*app);
        ok(ui->wait(3));
    }
    // The window as it is once all is drawn in full.
    Image shot() {
        ok(ui->screenshot(dir / "shot.png"));
        const Result<Image> image = readImage(dir / "shot.png");
        EXPECT_TRUE(image);
        return image ? *image : Image{};
    }
    // Mean distance of two shots over the viewport from share `from` to `to` of its width, away from the line and its
    // labels.
    double apart(const Image& a, const Image& b, double from, double to) {
        const Rect& r = app->hand.rect;
        double sum = 0;
        int n = 0;
        for (int y = static_cast<int>(r.y) + 40; y < static_cast<int>(r.y + r.h) - 40; ++y)
            for (int x = static_cast<int>(r.x + r.w * static_cast<float>(from));
                 x < static_cast<int>(r.x + r.w * static_cast<float>(to)); ++x, ++n)
                for (int c = 0; c < 3; ++c) {
                    const size_t i = (static_cast<size_t>(y) * static_cast<size_t>(a.width) + static_cast<size_t>(x)) *
                                         static_cast<size_t>(a.channels) +
                                     static_cast<size_t>(c);
                    sum += std::abs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]));
                }
        return sum / std::max(n, 1);
    }
    const Comparison& comparison() { return app->accuracy.comparison; }
};

TEST_F(EditorAccuracy, TheReferenceStandsRightOfTheLineAndGoesWithAllItsMemory) {
    const Image plain = shot();
    const int64_t before = gpu->ledger.contains("editor/comparison");
    EXPECT_EQ(before, 0);
    ok(ui->set("Accuracy/Against", "reference"));
    const Image split = shot();
    EXPECT_EQ(comparison().sum.passes, kHeadlessPasses);
    EXPECT_EQ(apart(plain, split, 0, 0.45), 0);
    EXPECT_GT(apart(plain, split, 0.55, 1), 0.02);
    EXPECT_LT(apart(plain, split, 0.55, 1), 0.5) << "another place altogether";
    EXPECT_TRUE(ui->exists("Accuracy/appearance"));
    EXPECT_EQ(get("Accuracy/samples"), "8 of 256");
    ASSERT_TRUE(comparison().metrics);
    EXPECT_LT(comparison().metrics->appearance.distance, 0.15);
    EXPECT_GT(comparison().metrics->appearance.distance, 0);

    // Another view starts anew on the same scene; another scene does not.
    const auto scene = comparison().scene;
    const double yaw = app->view.camera.yaw;
    ASSERT_TRUE(scene);
    app->view.camera.yaw += 0.1;
    ok(ui->wait(1));
    EXPECT_EQ(comparison().sum.passes, 0);
    EXPECT_EQ(comparison().picture.id(), 0u);
    EXPECT_EQ(comparison().scene, scene);
    app->view.camera.yaw = yaw;
    ASSERT_TRUE(doc.setField("sun.Light.elevationDeg", "20"));
    ok(ui->wait(1));
    EXPECT_FALSE(comparison().scene);
    ASSERT_TRUE(doc.undo());

    ok(ui->set("Accuracy/Against", "off"));
    EXPECT_FALSE(gpu->ledger.contains("editor/comparison"));
    EXPECT_FALSE(comparison().scene || comparison().copy || comparison().renderer || comparison().job.active());
    EXPECT_TRUE(comparison().sum.sum.empty() && comparison().own.pixels.empty() && comparison().other.pixels.empty());
    EXPECT_EQ(apart(plain, shot(), 0, 1), 0);
}

TEST_F(EditorAccuracy, ATechniqueHasARendererOfItsOwnAnErrorViewAndAGripUntilItIsOff) {
    shot();
    const auto before = gpu->ledger;
    ok(ui->set("Accuracy/Against", "flat"));
    const Image split = shot();
    EXPECT_TRUE(comparison().renderer);
    EXPECT_EQ(techniqueShown(doc), "hybrid");
    EXPECT_FALSE(doc.canUndo());
    const double bias = comparison().metrics ? comparison().metrics->appearance.distance : 0;
    EXPECT_GT(bias, 0);
    ok(ui->set("Accuracy/Show", "error"));
    const Image heat = shot();
    EXPECT_GT(apart(split, heat, 0.55, 1), 0.1);
    EXPECT_EQ(apart(split, heat, 0, 0.45), 0);
    ok(ui->set("Accuracy/Metric", "flip"));
    EXPECT_GT(apart(shot(), heat, 0.55, 1), 0.01);
    const auto grip = ui->rect("Viewport/Split");
    ASSERT_TRUE(grip);
    const double x = ((*grip)[0] + (*grip)[2]) / 2, y = ((*grip)[1] + (*grip)[3]) / 2;
    const uint64_t painted = density();
    ok(ui->click("Tools/Add"));
    ok(ui->drag(x, y, x - 100, y));
    EXPECT_LT(comparison().split, 0.4f);
    EXPECT_EQ(density(), painted);
    EXPECT_EQ(app->hand.gesture, Gesture::None);
    ok(ui->set("Accuracy/Show", "split"));
    ok(ui->set("Accuracy/Split", "0.5"));
    ok(ui->set("Accuracy/Against", "hybrid"));
    const Image same = shot();
    EXPECT_GT(apart(split, same, 0.55, 1), 0.01);
    ASSERT_TRUE(comparison().metrics);
    EXPECT_LT(comparison().metrics->appearance.distance, 1e-6) << "the same technique on the same project";
    ok(ui->set("Accuracy/Against", "off"));
    shot();
    EXPECT_EQ(gpu->ledger, before);
}

TEST_F(EditorAccuracy, APointOfThePlotIsAdoptedByAClickAndAFailedMeasurementSaysWhy) {
    CostRun run;
    run.project = "meadow", run.width = 320, run.height = 240;
    run.floors.push_back({"camera", {0.004}, {0.006}, {0.1}, 0.01, ""});
    for (const auto& [technique, settings, ms, error] : {std::tuple{"hybrid", "maxGeom=6 msaa=4", 10.0, 0.02},
                                                         {"flat", "msaa=1", 1.0, 0.1},
                                                         {"geometry", "detail=1 msaa=4", 90.0, 0.005}}) {
        CostRow row;
        row.camera = "camera", row.technique = technique, row.settings = settings;
        row.msMedian = ms, row.metrics.appearance.distance = error;
        run.rows.push_back(row);
    }
    markFrontier(run.rows);
    app->accuracy.sweep.run = run;
    ASSERT_TRUE(ui->get("Accuracy/Against"));
    const auto at = ui->rect("Accuracy/Point hybrid maxGeom=6 msaa=4");
    ASSERT_TRUE(at) << at.error().text();
    ok(ui->click("Accuracy/Point hybrid maxGeom=6 msaa=4"));
    EXPECT_EQ(field("lawn.HybridTiers.maxGeom"), "6");
    EXPECT_NE(app->messages.status.find("4 samples stay as they are"), std::string::npos) << app->messages.status;
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(doc.canUndo());

    // A measurement that fails says why and leaves no copy.
    setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
    app->accuracy.program = "/bin/false";
    ok(ui->click("Accuracy/Measure"));
    waitUntil([&] { return !measuring(app->accuracy); });
    EXPECT_FALSE(measuring(app->accuracy));
    EXPECT_NE(app->accuracy.sweep.error.find("exit code 1"), std::string::npos) << app->accuracy.sweep.error;
    EXPECT_FALSE(app->accuracy.sweep.run);
    EXPECT_TRUE(app->accuracy.sweep.copy.empty());
    unsetenv("XDG_STATE_HOME");
}

TEST_F(EditorAccuracy, AFitIsPreviewedRightOfTheLineAndChangesNothingUntilItIsAdopted) {
    const Image plain = shot();
    FitShown fitted;
    fitted.fits = true, fitted.ms = 5, fitted.appearance = 0.02;
    fitted.technique = "hybrid", fitted.settings = "minGeom=0 maxGeom=0.1 minBTF=0.1 maxBTF=0.1 sharpness=0";
    app->accuracy.fit.result = fitted;
    ok(ui->click("Accuracy/Preview"));
    const Image split = shot();
    EXPECT_EQ(comparison().against, Against::Settings);
    EXPECT_EQ(apart(plain, split, 0, 0.45), 0);
    EXPECT_GT(apart(plain, split, 0.55, 1), 0.005);
    EXPECT_FALSE(doc.canUndo());
    EXPECT_EQ(field("lawn.HybridTiers.maxGeom"), "12");
    ok(ui->click("Accuracy/Adopt"));
    ok(ui->wait(2));
    EXPECT_EQ(field("lawn.HybridTiers.maxGeom"), "0.1");
    const Image adopted = shot();
    EXPECT_LT(apart(adopted, split, 0.55, 1), 0.002) << "what was previewed is what is drawn";
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(doc.canUndo());
    ok(ui->set("Accuracy/Against", "off"));
    EXPECT_EQ(apart(plain, shot(), 0, 1), 0);
}

TEST_F(EditorAccuracy, AFitThatIsStoppedLeavesTheBestSoFarToBeAdopted) {
    setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
    const std::filesystem::path program = dir / "fits";
    test::writeText(program,
                    "#!/bin/sh\nwhile [ \"$1\" != --so-far ]; do shift; done\n"
                    "echo '{\"fits\": true, \"cut_short\": true, \"technique\": \"hybrid\", \"best\": {\"ms\": 5, "
                    "\"appearance\": 0.02, \"settings\": \"maxGeom=6\"}, \"shipped\": null}' > \"$2.part\"\n"
                    "mv \"$2.part\" \"$2\"\nexec sleep 600\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    app->accuracy.program = program.string();
    ok(ui->set("Accuracy/Search for", "1"));
    ok(ui->click("Accuracy/Fit to budget"));
    const std::filesystem::path best = app->accuracy.fit.folder / "fit.so-far";
    waitUntil([&] { return std::filesystem::exists(best); });
    ok(ui->click("Accuracy/Stop fit"));
    EXPECT_FALSE(measuring(app->accuracy));
    ASSERT_TRUE(app->accuracy.fit.result);
    ok(ui->click("Accuracy/Adopt"));
    ok(ui->wait(2));
    EXPECT_EQ(field("lawn.HybridTiers.maxGeom"), "6");
    unsetenv("XDG_STATE_HOME");
}

TEST_F(EditorAccuracy, StopEndsTheProgramThatMeasuresAndDropsItsCopy) {
    setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
    const std::filesystem::path program = dir / "measures";
    test::writeText(program, "#!/bin/sh\necho $$ > \"$0.part\" && mv \"$0.part\" \"$0.pid\"\nexec sleep 600\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    app->accuracy.program = program.string();
    for (const auto& [start, stop] :
         {std::pair{"Accuracy/Measure", "Accuracy/Stop"}, {"Accuracy/Fit to budget", "Accuracy/Stop fit"}}) {
        std::filesystem::remove(dir / "measures.pid");
        ok(ui->click(start));
        ASSERT_TRUE(measuring(app->accuracy)) << start;
        waitUntil([&] { return std::filesystem::exists(dir / "measures.pid"); });
        const std::filesystem::path copy =
            app->accuracy.sweep.copy.empty() ? app->accuracy.fit.copy : app->accuracy.sweep.copy;
        EXPECT_TRUE(std::filesystem::exists(copy / "project.json")) << "it measures a copy";
        const std::string pid = *readFile(dir / "measures.pid", 64);
        EXPECT_EQ(kill(std::stoi(pid), 0), 0);
        ok(ui->click(stop));
        EXPECT_FALSE(measuring(app->accuracy));
        EXPECT_FALSE(std::filesystem::exists(copy));
        EXPECT_NE(kill(std::stoi(pid), 0), 0) << "the program still runs";
        EXPECT_TRUE(ui->exists(start));
    }
    EXPECT_TRUE(app->accuracy.sweep.error.empty() && app->accuracy.fit.error.empty())
        << "who stops it needs no message";
    unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace sward
