// What the editor's widgets take a frame, of the processor: with each tab at the bottom open in turn, beside a path of
// a thousand points in the inspector and forty layers with two masks each.
#include <algorithm>

#include "app/app.h"
#include "bench/limits.h"
#include "model/layer_edits.h"
#include "panels/panels.h"
#include "scene/ground_path.h"
#include "techniques.h"
#include "ui/surface.h"

namespace {
using namespace sward;

constexpr int kPoints = 1000, kLayers = 40, kFrames = 31;

GroundPath winding() {
    GroundPath path;
    for (int i = 0; i < kPoints; ++i) {
        const double t = static_cast<double>(i) / kPoints;
        path.points.push_back({fmt::format("{}", i), {2 + 36 * t, 20 + 15 * std::sin(40 * t)}});
    }
    return path;
}
MapLayers manyLayers() {
    MapLayers layers;
    for (int i = 0; i < kLayers; ++i) {
        MapLayer layer;
        layer.name = fmt::format("layer {}", i);
        layer.map = "GrassField.species[lawn].density";
        layer.muted = true;  // rows cost what they cost; no map is made
        layer.masks.resize(2);
        layer.masks[1].name = "other";
        layers.layers.push_back(layer);
    }
    return layers;
}

SWARD_LIMITS("widgets", [] {
    CHECK(gpu());
    const std::filesystem::path dir = std::filesystem::path(SWARD_BINARY_DIR) / "bench-widgets";
    std::filesystem::remove_all(dir);
    Document doc(tables());
    CHECK(bool(doc.create(dir)));
    const GroundPath path = winding();
    const MapLayers layers = manyLayers();
    CHECK(bool(doc.addEntity("path")));
    CHECK(bool(doc.assignComponent("path", *findComponent(doc.tables().components, "GroundPath"), &path)));
    CHECK(bool(doc.assignComponent("lawn", *findComponent(doc.tables().components, "MapLayers"), &layers)));
    EditorApp app(doc, *gpu(), ui::makeHeadlessSurface(1440, 900), false);
    choose(app.selection, "path");
    std::string dearest;
    double most = 0;
    for (const PanelRow& row : panelRows()) {
        if (row.dock != Dock::Bottom) continue;
        app.layout.tab = row.name;
        std::vector<double> ms;
        for (int i = 0; i < kFrames + 4; ++i) {
            runFrame(app);
            if (i >= 4) ms.push_back(frameAt(app.frameTimes, keptFrames(app.frameTimes) - 1).panels);
        }
        std::fprintf(stderr, "widgets: %s %.2f ms\n", row.name, median(ms));
        if (median(ms) <= most) continue;
        most = median(ms), dearest = row.name;
    }
    std::fprintf(stderr, "widgets: the dearest tab is %s\n", dearest.c_str());
    reportLimit("the widgets of a frame, a path of 1000 points chosen", most, 2, "ms");
});

}  // namespace
