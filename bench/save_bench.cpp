// Projects on disk: kills while saving, what a stroke rewrites, how long the largest common height map takes to load.
#include "bench/limits.h"
#include "maps/map_io.h"
#include "project/project_files.h"
#include "techniques.h"
#include "tests/project/kill_save.h"
#include "tests/support.h"

using namespace sward;

namespace {

void killWhileSaving() {
    const test::TempDir dir;
    std::string why;
    reportLimit("projects unreadable or mixed after 10,000 kills while saving",
                test::killSaveLoop(10000, dir / "p", &why), 0, "");
    if (!why.empty()) std::fprintf(stderr, "%s\n", why.c_str());
}

void saveAfterAStroke() {
    const test::TempDir dir;
    Project p = test::killState(dir / "p", true);
    const auto rows = tables().components;
    if (!saveProject(p, rows)) return reportLimit("files written by saving after one stroke", std::nan(""), 1, "files");
    const Project before = snapshot(p, rows);
    static_cast<MapField*>(findMap(p, rows, "density")->value)->map.set(20, 20, 0, 0.25f);
    const auto written = saveProject(p, rows, &before);
    reportLimit("files written by saving after one stroke", written ? double(written->size()) : std::nan(""), 1,
                "files");
}

void loadHeights() {
    const test::TempDir dir;
    Map map({4096, 4096, 1, PixelType::F32});
    std::vector<float> row(4096);
    for (int y = 0; y < 4096; ++y) {
        for (int x = 0; x < 4096; ++x) row[size_t(x)] = 20 * std::sin(float(x) * 0.01f) * std::cos(float(y) * 0.013f);
        map.writeRows(y, 1, row.data());
    }
    for (const char* name : {"h.exr", "h.png"}) {
        MapWish wish;
        wish.isHeight = true;
        bool sound = bool(writeMap(dir / name, map, false, {{-20, 20}}));
        const double took = seconds([&] { sound = sound && readMap(dir / name, wish); });
        reportLimit(fmt::format("loading 4096 x 4096 heights, {}", name).c_str(), sound ? took : std::nan(""), 2, "s");
    }
}

SWARD_LIMITS("project files", [] {
    saveAfterAStroke();
    loadHeights();
});
SWARD_LIMITS("killed saves", killWhileSaving);

}  // namespace
