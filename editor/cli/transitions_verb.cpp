// `sward transitions`: what pops along a camera's path, step by step.
#include "cli/cli.h"
#include "cli/interrupt.h"
#include "core/file.h"
#include "cost/transition_plot.h"
#include "maps/map_io.h"
#include "techniques.h"

namespace sward {
namespace {

Status drawWalk(TransitionWalk& walk, Gpu& gpu) {
    Renderer renderer(gpu, tables());
    const auto tell = progressLine("drawing");
    while (!isDrawn(walk)) {
        if (!tell(static_cast<double>(walk.drawn.size()) / static_cast<double>(walk.views.size())))
            return interruption("interrupted; nothing was written");
        if (Status drawn = drawNextOf(walk, renderer); !drawn) return drawn;
    }
    tell(1);
    return {};
}

Result<Transitions> measure(const TransitionOptions& o, const TransitionPlan& plan) {
    RenderOptions opened;
    opened.project = o.project, opened.set = o.set, opened.technique = o.technique;
    const auto project = openForRendering(opened);
    if (!project) return project.error();
    auto walk = beginWalk(*project, tables(), plan);
    if (!walk) return walk.error();
    auto gpu = makeHeadlessGpu();
    if (!gpu) return gpu.error();
    const Interruptible here;
    if (Status drawn = drawWalk(**walk, **gpu); !drawn) return drawn.error();
    Job<Transitions> job("tracing", 0, [walk = *walk](JobControl& control) -> Result<Transitions> {
        while (!isTraced(*walk)) {
            if (Status traced = traceNextOf(*walk, tables(), control); !traced) return traced.error();
            control.setProgress(tracedShare(*walk));
        }
        return judgeWalk(*walk);
    });
    return waitFor(job, 0);
}

Status writeGraph(const Transitions& t, const std::filesystem::path& file) {
    const Plot plot = transitionPlot(t);
    if (file.extension() == ".svg") return writeFileAtomic(file, plotSvg(plot));
    return writeImagePng(file, plot.width, plot.height, 3, plotPixels(plot));
}

}  // namespace

int transitionsVerb(const TransitionOptions& o) {
    const std::string ending = std::filesystem::path(o.out).extension().string();
    if (!o.out.empty() && ending != ".png" && ending != ".svg")
        return report(usage("the graph is written as .png or .svg", "name --out so").at(o.out));
    const auto size = parseSize(o.size);
    if (!size) return report(size.error());
    const TransitionPlan plan{o.path, o.pictures, size->first, size->second, o.samples, o.time, o.from, o.to};
    const auto t = measure(o, plan);
    if (!t) return report(t.error());
    if (!o.out.empty())
        if (const Status written = writeGraph(*t, o.out); !written) return report(written.error());
    std::printf("%s", (o.json ? transitionsJson(*t) : transitionsText(*t)).c_str());
    return 0;
}

}  // namespace sward
