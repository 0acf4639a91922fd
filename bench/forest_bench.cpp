// What a forest's volumes cost against the same trees as meshes, how that follows pixels, and what they take to make
// and to keep. Limits are those that were asked for before there was anything to measure.
#include <algorithm>
#include <ctime>

#include "bench/limits.h"
#include "forest/volume_images.h"
#include "frame/renderer.h"
#include "project/project_files.h"
#include "techniques.h"
#include "tests/forest/flight.h"
#include "tests/grass/comparison.h"
#include "world/forest_stand.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace {
using namespace sward;
using namespace sward::test;

// Of the passes that draw trees, in one frame.
struct TreesCost {
    double ms = 0, fragments = 0, vertices = 0;
    double cpuMs = 0;  // of the whole frame, on all cores together: other programs change it little
};
struct Woods {
    Renderer renderer{*gpu(), tables()};
    Project project;

    explicit Woods(ForestTechnique technique, float detail = 1) {
        auto p = loadProject(SWARD_SOURCE_DIR "/projects/forest", tables().components);
        CHECK(bool(p));
        project = std::move(*p);
        forest().technique = technique;
        forest().meshDetail = detail;
    }
    Forest& forest() { return *project.registry.get<Forest>(findEntity(project, "trees")); }
    TreesCost frame(const std::string& camera, ViewSettings s) {
        s.measure = true;
        TreesCost c;
        const std::clock_t begun = std::clock();
        if (!renderer.draw(project, viewOf(*findCamera(project, camera)), s)) return {NAN, NAN, NAN, NAN};
        renderer.finish();
        c.cpuMs = 1000.0 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
        for (const PassStats& p : renderer.stats().passes)
            if (p.name.starts_with("forest/"))
                c.ms += p.ms, c.fragments += static_cast<double>(p.fragments),
                    c.vertices += static_cast<double>(p.vertices);
        return c;
    }
};

size_t standing(const Woods& w) {
    return standingForest(*w.project.registry.get<Forest>(findEntity(w.project, "trees")), findGround(w.project))
        .trees.size();
}
// Leaves about so many of all trees, chosen by their own hashes, wherever they stand; how many times as many there
// were.
double thin(Woods& w, float share) {
    const size_t all = standing(w);
    if (share < 1) {
        Map& density = w.forest().density.map;
        const MapInfo info = density.info();
        for (int y = 0; y < info.height; ++y)
            for (int x = 0; x < info.width; ++x) density.set(x, y, 0, share * density.at(x, y));
    }
    return static_cast<double>(all) / static_cast<double>(standing(w));
}

// The same trees by both in turn; times are medians. Of meshes that take minutes a share of the trees is drawn, and
// their time taken as many times as there are more: what meshes take follows their vertices.
void race(const char* name, float detail, double times, int frames, float share = 1) {
    const ViewSettings s = sized(480, 320);
    Woods volumes(ForestTechnique::Texcells), meshes(ForestTechnique::Trees, detail);
    const double more = thin(meshes, share);
    for (const char* camera : {"valley", "whole"}) {
        volumes.frame(camera, s), meshes.frame(camera, s);  // compiles, bakes
        std::vector<double> ours, theirs, ourCpu, theirCpu;
        TreesCost last{};
        const auto volumesOnce = [&] {
            const TreesCost c = volumes.frame(camera, s);
            ours.push_back(c.ms), ourCpu.push_back(c.cpuMs);
        };
        for (int i = 0; i < frames; ++i) {
            volumesOnce();
            last = meshes.frame(camera, s);
            theirs.push_back(last.ms), theirCpu.push_back(last.cpuMs);
            volumesOnce();
        }
        std::fprintf(stderr, "%s: volumes %.0f ms; meshes of a tree in %.1f, %.0f ms of %.1f million vertices\n",
                     camera, median(ours), more, median(theirs), last.vertices / 1e6);
        std::fprintf(stderr, "%s: whole frames, CPU time of all cores: %.0f and %.0f ms, a share of %.4f\n", camera,
                     median(ourCpu), median(theirCpu), median(ourCpu) / (more * median(theirCpu)));
        reportLimit(fmt::format("volumes as a share of {}, forest at {}", name, camera).c_str(),
                    median(ours) / (more * median(theirs)), 1 / times, "x");
    }
}

SWARD_LIMITS("forest-levels", [] {
    if (!gpu()) return reportLimit("volumes as a share of meshes of three levels", NAN, 0.2, "x");
    race("meshes of three levels", 1, 5, 3);
});
SWARD_LIMITS("forest-whole-meshes", [] {
    if (!gpu()) return reportLimit("volumes as a share of meshes with all leaves", NAN, 0.02, "x");
    race("meshes with all leaves", 1e6f, 50, 1, 0.1f);
});

// Over a small wood across each transition: what pops, against what other trees of the same forest would.
SWARD_LIMITS("forest-flight", [] {
    if (!gpu()) return reportLimit("popping over a flight as a share of other trees'", NAN, 1.25, "x");
    Renderer renderer(*gpu(), tables());
    const Restless first = flightToVolumes(renderer, 300);
    reportLimit("change at a step as a share of meshes', meshes to volumes", std::max(first.pixels, first.means), 1.25,
                "x");
    reportLimit("how much more or less pictures change than meshes', meshes to volumes",
                std::max(first.pixelsTimes, first.meansTimes), 1.25, "x");
    for (const Flight& f : kFlights) {
        const auto t = flight(renderer, tables(), f, 300);
        if (!t) {
            reportLimit(f.name, NAN, 1.25, "x");
            continue;
        }
        std::fprintf(stderr, "%s: %s; one that stands still %.2f of other trees'\n", f.name,
                     transitionsText(t->seen).c_str(), Flown::popping(t->frozen));
        reportLimit(fmt::format("popping over a flight as a share of other trees', {}", f.name).c_str(),
                    Flown::popping(t->seen), 1.25, "x");
    }
});

// The paper's claim: time follows the pixels.
SWARD_LIMITS("forest-pixels", [] {
    const char* kRow = "volumes' time a pixel: the greatest of three sizes by the least";
    if (!gpu()) return reportLimit(kRow, NAN, 1.15, "x");
    Woods w(ForestTechnique::Texcells);
    std::vector<double> each;
    for (const glm::ivec2 size : {glm::ivec2(240, 160), {480, 320}, {960, 640}}) {
        w.frame("valley", sized(size.x, size.y));
        std::vector<double> ms, cpu;
        for (int i = 0; i < 5; ++i) {
            const TreesCost c = w.frame("valley", sized(size.x, size.y));
            ms.push_back(c.ms), cpu.push_back(c.cpuMs);
        }
        each.push_back(median(ms) / (size.x * size.y));
        std::fprintf(stderr, "%d x %d: %.0f ms, %.2f us a pixel; CPU time of the frame, all cores: %.2f us\n", size.x,
                     size.y, median(ms), 1000 * each.back(), 1000 * median(cpu) / (size.x * size.y));
    }
    reportLimit(kRow, *std::max_element(each.begin(), each.end()) / *std::min_element(each.begin(), each.end()), 1.15,
                "x");
});

// What it costs to slice a cell in the one way and in the other: the paper's silhouette texcells cost four times as
// much. No limit is asked for; said are slices' fragments a pixel.
SWARD_LIMITS("forest-slices", [] {
    if (!gpu()) return;
    Woods w(ForestTechnique::Texcells);
    for (const float deg : {0.0f, 90.0f}) {
        w.forest().silhouetteDeg = deg;
        const ViewSettings s = sized(480, 320);
        w.frame("whole", s);
        const TreesCost c = w.frame("whole", s);
        std::fprintf(stderr, "%s slices at whole: %.0f ms, %.0f vertices, %.1f fragments a pixel\n",
                     deg > 0 ? "silhouette" : "regular", c.ms, c.vertices, c.fragments / (480 * 320));
    }
});

VolumeSpec specOf(const Forest& f, const std::filesystem::path& dir) {
    std::vector<Mesh> meshes;
    for (const TreeSpecies& s : f.species) meshes.push_back(std::move(*treeMesh(dir, s)));
    return {forestTiles(f), std::make_shared<const std::vector<Mesh>>(std::move(meshes)), static_cast<double>(f.voxel),
            f.storage == VolumeStorage::Compressed};
}

SWARD_LIMITS("forest-bake", [] {
    auto p = loadProject(SWARD_SOURCE_DIR "/projects/forest", tables().components);
    CHECK(bool(p));
    Forest f = *p->registry.get<Forest>(findEntity(*p, "trees"));
    const VolumeSpec ships = specOf(f, p->dir);
    JobControl control;
    reportLimit("the bake of projects/forest, on all cores", seconds([&] { CHECK(bool(bakeVolume(ships, control))); }),
                60, "s");
    // The paper's eight tiles in 128 slabs of 256 x 256.
    f.variety = TileVariety::Eight, f.voxel = 0.125f, f.storage = VolumeStorage::Compressed;
    const Result<VolumeImages> paper = bakeVolume(specOf(f, p->dir), control);
    const bool asPublished = paper && paper->side == 256 && paper->layers == 128;
    reportLimit("128 slabs of 256 x 256 with all levels, compressed",
                asPublished ? static_cast<double>(paper->bytes()) / 1e6 : NAN, 24, "MB");
});

}  // namespace
