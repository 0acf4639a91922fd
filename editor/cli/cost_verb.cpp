#include <unistd.h>

#include <chrono>
#include <sstream>

#include "cli/cli.h"
#include "cli/cost_request.h"
#include "cli/interrupt.h"
#include "core/file.h"
#include "core/log.h"
#include "cost/cost_files.h"
#include "cost/cost_machine.h"
#include "cost/cost_report.h"
#include "cost/cost_shipped.h"
#include "formulas/kernels.h"
#include "techniques.h"
#include "world/camera_path.h"

namespace sward {
namespace fs = std::filesystem;

namespace {

constexpr int kMoments = 5, kMostMoments = 1000;  // of a path; the first, where no number is given

// Cameras as they stand, or moments of a path: evenly over all of it, or --fps of them a second from its beginning.
Result<std::vector<CostView>> viewsOf(RenderOptions o, const Project& p) {
    const bool evenly = o.fps <= 0;
    const int moments = o.frames > 0 ? o.frames : kMoments;
    const auto names = shotNames(o, p);
    if (!names) return names.error();
    std::vector<CostView> views;
    for (const std::string& name : *names)
        if (o.path.empty()) views.push_back({name, shotAt(o, p, name, 0)});
    for (int i = 0; !o.path.empty() && i < moments; ++i) {
        const double length = secondsOf(*p.registry.get<CameraPath>(findEntity(p, o.path)));
        const double since = evenly ? length * i / std::max(1, moments - 1) : i / o.fps;
        views.push_back({fmt::format("{} at {:.3f} s", o.path, since), shotAt(o, p, o.path, since), since});
    }
    return views;
}

}  // namespace

Result<CostRequest> costRequest(const CostOptions& o, const Project& project) {
    CostRequest r;
    const auto size = parseSize(o.size);
    if (!size) return size.error();
    const auto shard = parseShard(o.shard);
    if (!shard) return shard.error();
    if (o.frames > kMostMoments) return usage(fmt::format("--frames takes at most {} moments of a path", kMostMoments));
    auto views = viewsOf(o, project);
    if (!views) return views.error();
    std::tie(r.width, r.height) = *size;
    std::tie(r.shard, r.shards) = *shard;
    r.views = std::move(*views), r.time = o.time, r.rounds = o.rounds, r.maxMs = o.maxMs;
    if (o.samples < 2 || o.samples > kMaxReferenceSamples)
        return usage(fmt::format("{} samples a pixel make no truth", o.samples),
                     fmt::format("--samples takes 2 to {}", kMaxReferenceSamples));
    if (o.rounds < 1 || o.rounds > 1000) return usage("--rounds takes 1 to 1000");
    if (!(o.maxMs >= 0)) return usage("--max-ms takes a number from 0");
    if (o.lighting != "full" && o.lighting != "direct")
        return usage("there is no lighting \"" + o.lighting + "\"", "full or direct");
    r.truth.samples = o.samples, r.truth.seed = o.seed;
    r.truth.lighting = o.lighting == "direct" ? ReferenceLighting::Direct : ReferenceLighting::Full;
    return r;
}

// On a terminal one line that is rewritten; else a line every half second, for who reads along.
CostProgress costProgress() {
    using Clock = std::chrono::steady_clock;
    return [last = std::string(), told = Clock::time_point()](const std::string& what, double share) mutable {
        const std::string line = share < 0 ? last : fmt::format("{:3.0f} %  {}", 100 * share, what);
        const bool terminal = isatty(STDERR_FILENO), due = Clock::now() - told > std::chrono::milliseconds(500);
        if (line != last && (terminal || due)) {
            std::fprintf(stderr, terminal ? "\r\033[K%s" : "%s\n", line.c_str());
            told = Clock::now();
        }
        last = line;
        return !interrupted();
    };
}

namespace {

void printRow(const CostRow& r) {
    std::printf("  %8.1f ms  %.5f +- %.5f  %s %s\n", r.msMedian, r.metrics.appearance.distance,
                r.metrics.appearance.sigma, r.technique.c_str(), r.settings.c_str());
}

void printRun(const CostRun& run, const fs::path& folder) {
    if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r\033[K");
    const std::vector<ShippedStanding> standings = shippedStandings(run);
    for (const CostFloors& f : run.floors) {
        std::printf("%s, %dx%d: other blades %.5f, few samples %.5f, flat rows %.5f\n", f.camera.c_str(), run.width,
                    run.height, f.seed.distance, f.sampling.distance, f.flat.distance);
        std::vector<const CostRow*> frontier;
        for (const CostRow& r : run.rows)
            if (r.camera == f.camera && r.onFrontier) frontier.push_back(&r);
        std::sort(frontier.begin(), frontier.end(),
                  [](const CostRow* a, const CostRow* b) { return a->msMedian < b->msMedian; });
        for (const CostRow* r : frontier) printRow(*r);
        for (const ShippedStanding& s : standings)
            if (s.row->camera == f.camera) {
                std::printf("  as it is: %s\n", standingText(s).c_str());
                if (!s.beatenBy.empty()) printRow(*s.row);
            }
    }
    for (const CostRow& r : run.rows)
        if (!r.skipped.empty())
            std::printf("left out: %s %s %s: %s\n", r.camera.c_str(), r.technique.c_str(), r.settings.c_str(),
                        r.skipped.c_str());
    std::printf("%s\n", (folder / "report.html").string().c_str());
}

// One sweep a size of "WxH,WxH", and the folder of its files: --out, or of several sizes a folder in it each.
Result<std::vector<std::pair<CostRequest, fs::path>>> sweepsOf(const CostOptions& o, const Project& project,
                                                               const std::vector<CostSetting>& settings) {
    std::vector<std::pair<CostRequest, fs::path>> sweeps;
    const bool several = o.size.find(',') != std::string::npos;
    std::istringstream sizes(o.size);
    for (std::string size; std::getline(sizes, size, ',');) {
        CostOptions one = o;
        one.size = size;
        auto request = costRequest(one, project);
        if (!request) return request.error();
        request->settings = settings;
        request->folder = fs::path(o.out) / "work";
        const std::string name = fmt::format("{}x{}", request->width, request->height);
        sweeps.push_back({std::move(*request), several ? fs::path(o.out) / name : fs::path(o.out)});
    }
    if (sweeps.empty()) return usage("--size names no size", "write WxH, or WxH,WxH");
    return sweeps;
}

Status writeKernelFiles(const KernelRun& run, const fs::path& folder) {
    if (Status s = makeFolderOf(folder / "numerics.csv"); !s) return s;
    if (Status s = writeFileAtomic(folder / "numerics.csv", kernelCsv(run)); !s) return s;
    return writeFileAtomic(folder / "numerics.json", writeJson(kernelJson(run)));
}

int numericsVerb(const CostOptions& o) {
    if (o.rounds < 1 || o.rounds > 1000) return report(usage("--rounds takes 1 to 1000"));
    auto gpu = makeHeadlessGpu();
    if (!gpu) logWarning(gpu.error().text() + "; the shaders' column stays empty");
    const Interruptible here;
    const auto run = measureKernels({o.rounds, ""}, gpu ? gpu->get() : nullptr, costProgress());
    if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r\033[K");
    if (!run) return report(run.error());
    if (!o.out.empty())
        if (Status s = writeKernelFiles(*run, o.out); !s) return report(s.error());
    std::printf("%s", (o.json ? writeJson(kernelJson(*run)) : kernelText(*run)).c_str());
    return 0;
}

// Times of several machines make no one table: one each, NAME.HOST.csv.
int writeTables(const CostRun& run, const fs::path& out) {
    const auto tables = runsByMachine(run);
    for (const auto& [machine, own] : tables) {
        const fs::path file = tables.size() == 1 ? out : fs::path(out).replace_extension("." + machine + ".csv");
        if (Status s = writeFileAtomic(file, costCsv(own)); !s) return report(s.error());
        std::printf("%s\n", file.c_str());
    }
    return 0;
}

}  // namespace

int costVerb(const CostOptions& o) {
    if (o.numerics) return numericsVerb(o);
    if (o.project.empty()) return report(usage("project is required", "name its folder, or ask for --numerics"));
    if (o.out.empty()) return report(usage("--out is required", "name a folder for table, plots and report"));
    RenderOptions asItIs = o;  // --technique says what to sweep, not how the project is drawn
    asItIs.technique.clear();
    auto project = openForRendering(asItIs);
    if (!project) return report(project.error());
    const auto settings = costSettings(*project, tables(), o.technique);
    if (!settings) return report(settings.error());
    const auto sweeps = sweepsOf(o, *project, *settings);
    if (!sweeps) return report(sweeps.error());
    auto gpu = makeHeadlessGpu();
    if (!gpu) return report(gpu.error());
    const Interruptible here;
    for (const auto& [request, folder] : *sweeps) {
        const auto run = runCost(request, *project, tables(), **gpu, costProgress());
        if (!run) return report(run.error());
        if (Status s = writeCostFiles(*run, folder, request.folder, tables().techniques); !s) return report(s.error());
        printRun(*run, folder);
    }
    return 0;
}

bool isCostPart(const fs::path& file) {
    std::error_code ec;
    return file.extension() == ".json" || fs::exists(file / "cost.json", ec);
}

int mergeCostVerb(const MergeCommand& o) {
    std::vector<CostRun> parts;
    for (const std::string& file : o.parts) {
        auto part = readCost(file);
        if (!part) return report(part.error());
        parts.push_back(std::move(*part));
    }
    const auto whole = mergeCosts(parts);
    if (!whole) return report(whole.error());
    const fs::path out = o.out;
    if (out.extension() != ".json" && out.extension() != ".csv")
        return report(usage("a joined sweep is written as .json or .csv", "name --out so").at(o.out));
    if (Status s = makeFolderOf(out); !s) return report(s.error());
    if (out.extension() == ".csv") return writeTables(*whole, out);
    if (Status s = writeFileAtomic(out, writeJson(costJson(*whole))); !s) return report(s.error());
    std::printf("%s\n", o.out.c_str());
    return 0;
}

}  // namespace sward
