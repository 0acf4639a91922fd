// What a frame of each sample project takes, as it ships, at 1920 x 1080 (in software at 320 x 240): the table of
// docs/performance.md. Two times a row: of single frames, each waited for, so that what the CPU does comes before what
// the GPU does; and of frames one after another, as they are shown, where both work at once. No limits: they are of one
// machine.
#include <cstdio>

#include "bench/limits.h"
#include "frame/renderer.h"
#include "project/project_files.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace {
using namespace sward;

constexpr const char* kProjects[] = {"football", "park",    "meadow", "wheat", "tornado", "lawn",
                                     "prairie",  "rockery", "oasis",  "grove", "forest"};

struct FrameTimes {
    double single = NAN, shown = NAN, passes = NAN;  // ms
    uint64_t draws = 0, gpuBytes = 0;
};

ViewSettings settingsOf(int msaa) {
    ViewSettings s;
    s.width = gpu()->software ? 320 : 1920, s.height = gpu()->software ? 240 : 1080, s.msaa = msaa;
    return s;
}

FrameTimes timesOf(const Project& project, int msaa) {
    Renderer r(*gpu(), tables());
    const int frames = gpu()->software ? 1 : 40;
    const ViewCamera camera = viewOf(*findCamera(project, "human"));
    ViewSettings s = settingsOf(msaa);
    for (int i = 0; i < 3; ++i)  // makes what it draws with
        if (!r.draw(project, camera, s)) return {};
    r.finish();
    const auto draw = [&] { CHECK(bool(r.draw(project, camera, s))); };
    FrameTimes t;
    std::vector<double> ms;
    for (int i = 0; i < frames; ++i) ms.push_back(1000 * seconds([&] { draw(), r.finish(); }));
    t.single = median(ms);
    t.shown = 1000 / frames * seconds([&] {
                  for (int i = 0; i < frames; ++i) draw();
                  r.finish();
              });
    s.measure = true;
    draw(), draw();
    t.passes = 0;
    for (const PassStats& p : r.stats().passes) t.passes += p.ms, t.draws += p.draws;
    t.gpuBytes = r.stats().gpuBytes;
    return t;
}

SWARD_LIMITS("project-frames", [] {
    if (!gpu()) return reportLimit("frames of the sample projects", NAN, 0, "ms");
    std::printf(
        "%s, %d x %d\n\n| project | samples | single, ms | shown, ms | passes, ms | draws | GPU memory, MB |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n",
        gpu()->renderer.c_str(), settingsOf(1).width, settingsOf(1).height);
    for (const char* name : kProjects)
        for (const int msaa : {1, 4}) {
            auto project = loadProject(std::string(SWARD_SOURCE_DIR "/projects/") + name, tables().components);
            if (!project) return reportLimit(name, NAN, 0, "ms");
            const FrameTimes t = timesOf(*project, msaa);
            std::printf("| %s | %d | %.3g | %.3g | %.3g | %lu | %.0f |\n", name, msaa, t.single, t.shown, t.passes,
                        static_cast<unsigned long>(t.draws), static_cast<double>(t.gpuBytes) / 1e6);
            std::fflush(stdout);
        }
});

}  // namespace
