// A long day on the largest common map: a hundred strokes and all of them undone, and what a frame takes while ten such
// maps are copied in the background after a stroke.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "app/app.h"
#include "bench/limits.h"
#include "scene/map_fields.h"
#include "techniques.h"
#include "tests/support.h"
#include "ui/surface.h"

namespace {
using namespace sward;

constexpr int kHistorySide = 4096;
constexpr const char* kDensity = "lawn.GrassField.species[lawn].density";

// Spots, of which no tile is like another.
Map spottedMap() {
    Map map({kHistorySide, kHistorySide, 1, PixelType::U16});
    std::vector<uint16_t> row(kHistorySide);
    for (int y = 0; y < kHistorySide; ++y) {
        for (size_t x = 0; x < row.size(); ++x)
            row[x] =
                static_cast<uint16_t>(30000 + 20000 * std::sin(0.01 * static_cast<double>(x)) * std::cos(0.013 * y));
        map.writeRows(y, 1, row.data());
    }
    return map;
}
uint64_t densityHash(const Document& doc) {
    return mapOf(*findMap(doc.project(), tables().components, kDensity)).map.hash();
}
// Bytes of memory that the process has now.
double residentBytes() {
    long pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void stroke(Document& doc, int i) {
    BrushSettings b;
    b.map = kDensity, b.mode = "subtract", b.radius = 5, b.strength = 0.6f;  // 500 texels
    const double x = 2 + 3.7 * (i % 10), z = 2 + 3.7 * (i / 10);
    CHECK(bool(doc.beginStroke(b, x, z)));
    doc.strokeTo(x + 2, z + 1);
    doc.endStroke();
    doc.pumpStroke(0);
}

SWARD_LIMITS("hundred strokes", [] {
    const test::TempDir dir;
    constexpr size_t kBudget = size_t(512) << 20;
    Document doc(tables(), kBudget);
    CHECK(bool(doc.create(dir / "p")));
    CHECK(bool(doc.setMap(kDensity, spottedMap(), "spots")));
    const uint64_t first = densityHash(doc);
    const double before = residentBytes();
    const double took = seconds([&] {
        for (int i = 0; i < 100; ++i) stroke(doc, i);
    });
    const double grown = residentBytes() - before;
    int undone = 0;
    bool back = densityHash(doc) != first;  // they changed it
    const double undoing = seconds([&] {
        for (; undone < 100 && doc.undo(); ++undone) {
        }
    });
    back = back && undone == 100 && densityHash(doc) == first;
    std::fprintf(stderr, "hundred strokes: %.0f ms each, undo %.1f ms each\n", 10 * took, 10 * undoing);
    reportLimit("100 strokes on 4096^2 that undo does not take back", back ? 0 : 1, 0, "");
    reportLimit("memory of 100 strokes on 4096^2, of the budget", grown / static_cast<double>(kBudget), 1, "x");
});

// ms of each frame until `ended`, at least so many, while the view turns: each draws a picture.
template <class Ended>
std::vector<double> frameMs(EditorApp& app, size_t least, const Ended& ended) {
    std::vector<double> ms;
    while (ms.size() < least || !ended()) {
        app.view.camera.yaw += 0.002;
        ms.push_back(1000 * seconds([&] { runFrame(app); }));
    }
    return ms;
}

// Ten maps of a muted layer each: they are copied, and cost nothing to draw.
void giveMaps(Document& doc) {
    MapLayers layers;
    const Map map = spottedMap();
    for (int i = 0; i < 10; ++i) {
        MapLayer layer;
        layer.name = "map" + std::to_string(i), layer.map = "GrassField.species[lawn].density";
        layer.kind = LayerKind::Painted, layer.muted = true;
        layer.amounts = {"maps/layer" + std::to_string(i) + ".png", map};
        layer.amounts.map.set(i, 0, 0, 0.5f);
        layers.layers.push_back(std::move(layer));
    }
    CHECK(bool(doc.addComponent("lawn", "MapLayers")));
    CHECK(bool(doc.assignComponent("lawn", *findComponent(doc.tables().components, "MapLayers"), &layers)));
    CHECK(bool(doc.save()));
}

// A copy of all ten, and what frames took meanwhile: the slowest, as share of the median.
double slowestWhileCopying(EditorApp& app, Document& doc, double at) {
    stroke(doc, static_cast<int>(at) % 100);
    frameMs(app, 20, [] { return true; });  // it is as coarse as it becomes in motion
    const std::vector<double> still = frameMs(app, 60, [] { return true; });
    const double usual = median(still);
    app.autosave.on = true;
    tickAutosave(app.autosave, doc, false, at);
    tickAutosave(app.autosave, doc, false, at + 100000);
    CHECK(app.autosave.job.active());
    app.autosave.on = false;  // the loop's own clock has no say
    const std::vector<double> ms = frameMs(app, 1, [&] { return app.autosave.job.finished(); });
    app.autosave.on = true;
    tickAutosave(app.autosave, doc, false, at + 100001);
    app.autosave.on = false;
    const double slowest = *std::max_element(ms.begin(), ms.end());
    std::fprintf(stderr,
                 "autosave: %zu frames, median %.2f ms, slowest %.2f ms; without: median %.2f ms, slowest %.2f ms\n",
                 ms.size(), median(ms), slowest, usual, *std::max_element(still.begin(), still.end()));
    return slowest / usual;
}

// The least of some copies, since other work on the machine only adds.
SWARD_LIMITS("autosave frames", [] {
    const test::TempDir dir;
    setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
    Gpu* context = gpu();
    CHECK(context);
    Document doc(tables());
    CHECK(bool(doc.create(dir / "p")));
    giveMaps(doc);
    EditorApp app(doc, *context, ui::makeHeadlessSurface(640, 400), false);
    app.strokeTiming.on = false;
    double least = 1e9;
    for (int i = 0; i < 3; ++i) least = std::min(least, slowestWhileCopying(app, doc, 1e6 * (i + 1)));
    reportLimit("slowest frame while ten maps of 4096^2 are copied, of the median", least, 2, "x");
    unsetenv("XDG_STATE_HOME");
});

}  // namespace
