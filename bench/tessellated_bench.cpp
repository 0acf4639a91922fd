// What tessellated blades cost: a frame by the blade, the GPU's stages against strips, the CPU's part, and what a frame
// hands over.
#include <ctime>

#include "bench/limits.h"
#include "frame/renderer.h"
#include "techniques.h"
#include "tests/fields.h"
#include "tests/gl_calls.h"
#include "tests/grass/comparison.h"
#include "world/view_camera.h"

namespace {
using namespace sward;
using namespace sward::test;

// 645 x 645 blades on 32.25 m, without shadows among themselves; seen as a whole from its edge.
constexpr Design kPlain{"416,025 plain blades", 400, 0.3f, 0.012f, 32.25, 0, 0, 0, 0};
Project plain() {
    Project p = designed(kPlain, kPlain.side);
    FlatField f = grassIn(p);
    f.technique = nameOf(Technique::Tessellated);
    f.beyond = Beyond::Nothing;
    f.cellSize = 0.75f;
    f.shadowMask = 0;
    f.groundShadows = false;
    f.species[0].clumpSize = 0;
    f.maxDistance = 60;
    f.thinning = 0;
    f.lowerFrom = 1;
    return p;
}
ViewCamera overPlain() { return {{16, 1.7, -14}, {16, 0, 16}, 55, 0}; }

double frameMs(Renderer& r, Project& p, const ViewCamera& c, const ViewSettings& s) {
    bool drawn = false;
    const double took = 1000 * seconds([&] {
                            drawn = bool(r.draw(p, c, s));
                            r.finish();
                        });
    return drawn ? took : NAN;
}
void printPass(Renderer& r, Project& p, const ViewCamera& c, ViewSettings s) {
    const std::clock_t before = std::clock();
    frameMs(r, p, c, s);
    std::fprintf(stderr, "  %.0f ms of all cores together\n",
                 1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    s.measure = true;
    frameMs(r, p, c, s);
    for (const PassStats& pass : r.stats().passes)
        std::fprintf(stderr, "  %-20s %7.1f ms %9lu vertices %9lu fragments\n", pass.name.c_str(), pass.ms,
                     static_cast<unsigned long>(pass.vertices), static_cast<unsigned long>(pass.fragments));
    std::fprintf(stderr, "  %lu blades, %.2f ms of the CPU's\n", static_cast<unsigned long>(r.stats().bladesGeometry),
                 r.stats().cpuCullMs);
}

// Blades of 12 to 2 and of 1 triangles, by their length on screen; with and without wind in turn.
SWARD_LIMITS("tessellated-plain", [] {
    if (!gpu()) return reportLimit("frame time a plain blade", NAN, 0.25, "us");
    std::array<std::vector<double>, 2> ms;
    Renderer renderers[2] = {Renderer(*gpu(), tables()), Renderer(*gpu(), tables())};
    Project projects[2] = {plain(), plain()};
    for (Project& p : projects) {
        FlatField f = grassIn(p);
        f.levelBy = LevelBy::Pixels;
        f.pixelsPerQuad = 8;
        f.species[0].smoothness = 6;
    }
    give(projects[1], "wind", Wind{});
    ViewSettings s = sized(640, 480, 1);
    for (int i = 0; i < 12; ++i)
        for (size_t wind = 0; wind < 2; ++wind) {
            s.time = 0.1 * i;
            const double took = frameMs(renderers[wind], projects[wind], overPlain(), s);
            if (i > 1) ms[wind].push_back(took);
        }
    for (size_t wind = 0; wind < 2; ++wind) {
        printPass(renderers[wind], projects[wind], overPlain(), s);
        const double blades = static_cast<double>(renderers[wind].stats().bladesGeometry);
        std::fprintf(stderr, "  fastest frame: %.3f us a blade\n",
                     1000 * *std::min_element(ms[wind].begin(), ms[wind].end()) / blades);
        reportLimit(wind ? "frame time a plain blade in wind" : "frame time a plain blade",
                    1000 * median(ms[wind]) / blades, 0.25, "us");
    }
});

// All blades at one level; both ways in turn.
void raceAt(int level) {
    const ViewSettings s = sized(320, 240, 1);
    std::array<std::vector<double>, 2> ms;
    Renderer renderers[2] = {Renderer(*gpu(), tables()), Renderer(*gpu(), tables())};
    Project p = plain();
    FlatField f = grassIn(p);
    f.species[0].smoothness = level;
    f.species[0].bladesPerM2 = 100;
    f.maxDistance = 1e5f;  // so that nothing is far
    for (int i = 0; i < 7; ++i)
        for (size_t way = 0; way < 2; ++way) {
            f.tessellation = way == 0 ? Tessellation::Stages : Tessellation::Strips;
            const double took = frameMs(renderers[way], p, overPlain(), s);
            if (i > 0) ms[way].push_back(took);
        }
    std::fprintf(stderr, "level %d: stages %.1f ms, strips %.1f ms\n", level, median(ms[0]), median(ms[1]));
    reportLimit(("strips as a share of stages, level " + std::to_string(level)).c_str(), median(ms[1]) / median(ms[0]),
                1, "x");
}
SWARD_LIMITS("tessellated-ways", [] {
    if (!gpu()) return reportLimit("strips as a share of stages", NAN, 1, "x");
    if (gpu()->software)
        for (const int level : {1, 3, 5}) raceAt(level);
});

Project million() {
    Project p = plain();
    grassIn(p).species[0].bladesPerM2 = 1100;
    give(p, "wind", Wind{});
    give(p, "roller", ForceSource{});
    p.registry.add<Transform>(findEntity(p, "roller"), Transform{{16, 0, 10}});
    return p;
}

// What the CPU does of a frame of a million blades in wind, and what it hands over: without labels for debuggers.
void measureCpu(Culling culling) {
    Renderer renderer(*gpu(), tables());
    Project p = million();
    grassIn(p).culling = culling;
    std::vector<double> ms;
    GlCalls calls;
    for (int i = 0; i < 6; ++i) {
        if (i < 5)
            frameMs(renderer, p, overPlain(), sized(64, 48, 1));
        else {
            const CountGlCalls count;
            frameMs(renderer, p, overPlain(), sized(64, 48, 1));
            calls = glCalls;
        }
        if (i > 0) ms.push_back(renderer.stats().cpuCullMs);
    }
    const uint64_t labels = calls.byName["glPushDebugGroup"] + calls.byName["glPopDebugGroup"];
    const std::string what =
        std::string("a million tessellated blades, cells chosen by ") + kCullings[static_cast<size_t>(culling)];
    reportLimit((what + ": CPU").c_str(), median(ms), 0.5, "ms");
    reportLimit((what + ": GL calls").c_str(), static_cast<double>(calls.calls - labels), 100, "calls");
    reportLimit((what + ": upload").c_str(), static_cast<double>(calls.bytes) / 1024, 64, "KB");
}
SWARD_LIMITS("tessellated-cpu", [] {
    if (!gpu()) return reportLimit("the CPU's part of a million tessellated blades", NAN, 0.5, "ms");
    for (const Culling culling : {Culling::Gpu, Culling::Cpu}) measureCpu(culling);
});

}  // namespace
