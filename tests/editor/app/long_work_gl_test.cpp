// On maps of 4096 x 4096 texels no operation holds a frame for longer than a tenth of a second: what takes longer is
// shown with its progress, and can be cancelled. Without the pictures, which a software renderer draws in seconds.
#include <ctime>
#include <thread>

#include "app/commands.h"
#include "core/file.h"
#include "editor/editor_fixture.h"
#include "maps/map_io.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "model/assets.h"
#include "model/scatter_edits.h"
#include "model/species_presets.h"
#include "panels/map_windows.h"
#include "project/project_files.h"
#include "tools/brush_target.h"

namespace sward {
namespace {

constexpr int kSide = 4096;
constexpr double kMostMs = 100;  // of the processor, of the thread that draws
constexpr const char *kDensity = "lawn.GrassField.species[lawn].density", *kHeights = "ground.Terrain.height",
                     *kColours = "ground.Terrain.terrainMap";

double threadMs() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

// No two tiles alike, so that nothing is shared.
Map uneven(int channels, PixelType type, int side = kSide) {
    Map map({side, side, channels, type});
    std::vector<std::byte> row(static_cast<size_t>(side) * map.texelBytes());
    for (int y = 0; y < side; ++y) {
        for (size_t i = 0; i < row.size(); ++i)
            row[i] = static_cast<std::byte>((i % 2 ? 40 : 0) + (i / 64 + static_cast<size_t>(y) / 7) % 60);
        map.writeRows(y, 1, row.data());
    }
    return map;
}

class LongWork : public test::EditorFixture {
  protected:
    void SetUp() override {
        EditorFixture::SetUp();
        ok(doc.setField("ground.Terrain.size", "[2048, 2048]"));
        ok(doc.setField("ground.Terrain.heightRange", "[0, 100]"));
        ok(doc.setField("lawn.GrassField.species[lawn].bladesPerM2", "20"));
        ok(doc.setMap(kHeights, uneven(1, PixelType::U16), "heights"));
        ok(doc.setMap(kDensity, uneven(1, PixelType::U8), "density"));
        ok(doc.setMap(kColours, uneven(4, PixelType::U8), "colours"));
        ASSERT_TRUE(doc.save());
        selectMap(doc, app->brushes, kDensity);
        ok(ui->wait(3));
        app->background.waiting.patient = app->images.patient = false;
    }
    void run(const std::string& label) {
        for (const Command& c : commands())
            if (c.label == label) {
                ASSERT_TRUE(c.enabled(*app)) << label;
                return c.run(*app);
            }
        FAIL() << "there is no command " << label;
    }
    // Begins an operation, and draws frames until it has ended; none of them may take long, the beginning included.
    void expectBrief(const std::string& what, const std::function<void()>& begin) {
        const size_t windows = app->background.waiting.windows;
        double worst = 0;
        const auto timed = [&](const auto& work, const double* drawing = nullptr) {
            const double before = threadMs();
            work();
            worst = std::max(worst, threadMs() - before - (drawing ? *drawing : 0));
        };
        timed(begin);
        int frames = 0;
        for (int quiet = 0; quiet < 4; ++frames) {
            timed([&] { runFrame(*app); }, &app->pictureMs);
            const Waiting& w = app->background.waiting;
            if (waits(w) && w.shown && frames > 2) EXPECT_TRUE(app->book.widgets.contains("Waiting/Cancel")) << what;
            const bool busy = waits(w) || app->images.reading.active() || app->background.exporting ||
                              app->accuracy.fit.running() || app->accuracy.sweep.running() || app->effects.running();
            quiet = busy ? 0 : quiet + 1;
            if (busy) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        EXPECT_LT(worst, kMostMs) << what;
        std::fprintf(stderr, "%-34s at most %6.1f ms a frame, %d frames, %zu windows\n", what.c_str(), worst, frames,
                     app->background.waiting.windows - windows);
    }
    // The same, cancelled as soon as it shows its window: nothing changes then.
    void expectCancelled(const std::string& what, const std::function<void()>& begin) {
        const uint64_t revision = doc.revision();
        const size_t windows = app->background.waiting.windows;
        begin();
        if (app->background.waiting.windows == windows) return;  // it was done before a person could cancel it
        cancelWaiting(app->background.waiting);
        while (waits(app->background.waiting)) runFrame(*app);
        EXPECT_EQ(doc.revision(), revision) << what;
        app->messages.notice.clear();
    }
};

TEST_F(LongWork, WholeMapsAreChangedBesideTheFrames) {
    for (const char* map : {kDensity, kColours}) {
        selectMap(doc, app->brushes, map);
        for (const char* command : {"Fill Map", "Clear Map", "Invert Map"}) {
            expectBrief(std::string(command) + (map == kColours ? ", colours" : ""), [&] { run(command); });
            EXPECT_TRUE(doc.undo());
        }
    }
    expectCancelled("Invert Map", [&] { run("Invert Map"); });
    expectBrief("Check Maps", [&] { run("Check Maps"); });
    EXPECT_EQ(app->mapHealth.maps, 3u);
    expectBrief("Height from Density", [&] { run("Height from Density"); });
    expectBrief("Heights as Floats", [&] { run("Heights as Floats"); });
    expectBrief("Pond", [&] { run("Pond"); });
    expectBrief("undo of all", [&] { EXPECT_TRUE(doc.jumpTo(0)); });
    expectBrief("and done again", [&] { EXPECT_TRUE(doc.jumpTo(doc.stepLabels().size())); });
}

// What is added begins with maps of its own, or with ground to be looked through.
TEST_F(LongWork, WhatIsAddedHoldsNoFrame) {
    for (const char* command : {"Flowers", "Forest", "New Path", "Lamp", "Camera"})
        expectBrief(command, [&] { run(command); });
    expectBrief("Species", [&] { EXPECT_TRUE(duplicateSpecies(doc, "lawn", "lawn")); });
    const Solid box;
    std::filesystem::create_directories(doc.project().dir / kAssetFolder);
    test::writeText(doc.project().dir / kAssetFolder / "box.glb", *encodeGlb(makeMesh({&box, 1})));
    std::string scattered;
    expectBrief("Scatter", [&] {
        const Result<std::string> made = addScatter(doc, {});
        ASSERT_TRUE(made) << made.error().text();
        scattered = *made + ".Scatter.";
    });
    expectBrief("scattered anew", [&] { ok(doc.setField(scattered + "distance", "2")); });
    expectBrief("its objects", [&] { choose(app->selection, "scatter"); });
    expectBrief("undo of all", [&] { EXPECT_TRUE(doc.jumpTo(0)); });
}

// What measures works on a copy, which is written beside.
TEST_F(LongWork, MeasuringHoldsNoFrame) {
    ok(doc.setMap(kHeights, uneven(1, PixelType::U16), "unsaved heights"));
    const std::string program = "/bin/true";
    const MeasureParts parts{doc, program, app->view.camera, app->clock, app->messages};
    Accuracy& accuracy = app->accuracy;
    expectBrief("Fit", [&] { startFit(accuracy.fit, parts); });
    expectBrief("Measure", [&] { startSweep(accuracy.sweep, parts); });
    expectBrief("Effects", [&] { startEffects(app->effects, parts, {160, 120}, 0); });
}

TEST_F(LongWork, PlayBeginsAndEndsWithinAFrame) {
    expectBrief("start of play", [&] { run("Start or Stop"); });
    EXPECT_TRUE(playing(doc));
    expectBrief("end of play", [&] { run("Start or Stop"); });
    EXPECT_FALSE(playing(doc));
}

}  // namespace
}  // namespace sward
