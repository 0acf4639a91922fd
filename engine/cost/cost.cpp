// Index: keys · a row's picture and errors · what it will take · timing · the sweep.
#include "cost/cost.h"

#include <sys/stat.h>

#include "core/file.h"
#include "core/hash.h"
#include "core/jobs.h"
#include "core/log.h"
#include "cost/cost_files.h"
#include "cost/cost_machine.h"
#include "cost/cost_times.h"
#include "cost/cost_truth.h"
#include "cost/frame_stats.h"
#include "gpu/timer.h"
#include "maps/map_io.h"
#include "project/project_files.h"
#include "scene/antialias.h"
#include "world/view_camera.h"

namespace sward {
namespace {
namespace fs = std::filesystem;

constexpr double kSure = 4;           // times the limit that a row must be expected to take to be left out unseen
constexpr double kMsPerBlade = 1e-5;  // until a camera is met that has blades near by
constexpr double kLimit = 2, kLeastLimit = 250;  // times what the project's own settings take, and at least so many ms:
                                                 // the limit, where none is given

// --- keys --------------------------------------------------------------------------------------------------------
// This program as it was built: rows drawn by another are drawn again.
std::string buildStamp() {
    struct stat s {};
    if (stat("/proc/self/exe", &s) != 0) return SWARD_VERSION;
    return fmt::format("{} {} {}.{}", SWARD_VERSION, s.st_size, s.st_mtim.tv_sec, s.st_mtim.tv_nsec);
}
std::string sweepHash(const CostRequest& r, const Project& p, const Tables& tables) {
    return hashHex(
        hashText(fmt::format("{} {}x{} {} {} {} {}", hashHex(projectHash(p, tables.components)), r.width, r.height,
                             r.time, r.truth.samples, r.truth.seed, static_cast<int>(r.truth.lighting))));
}

struct Sweep {
    const CostRequest& request;
    const Project& project;
    const Tables& tables;
    Gpu& gpu;
    const CostProgress& progress;
    Renderer renderer{gpu, tables};
    std::string hash = {};
    std::vector<CostTruth> truths = {};  // by camera
    CostRun run = {};
    std::vector<size_t> settings = {};  // of each row, index into request.settings
    std::vector<size_t> slow = {};      // rows that were left out
    double msPerBlade = kMsPerBlade, msOfRest = 0, msLimit = 0;

    std::string keyOf(const CostRow& row) const {
        return hashHex(hashText(hash + "\n" + row.camera + "\n" + row.technique + "\n" + row.settings + "\n" +
                                gpu.renderer + "\n" + shortestText(request.maxMs) + "\n" + buildStamp()));
    }
    fs::path fileOf(const CostRow& row) const { return request.folder / ("row-" + keyOf(row) + ".json"); }
};
Error stopped() { return interruption("interrupted; what is finished is kept", "run the same command again to go on"); }

// --- a row's picture and errors ----------------------------------------------------------------------------------
struct Prepared {
    Project project;
    ViewCamera camera;
    ViewSettings view;
};
Prepared asItIs(const Sweep& s, const std::string& view) {
    const CostView& from = *std::find_if(s.request.views.begin(), s.request.views.end(),
                                         [&](const CostView& v) { return v.name == view; });
    Prepared p{snapshot(s.project, s.tables.components), from.camera, {}};
    p.view.width = s.request.width, p.view.height = s.request.height, p.view.time = s.request.time + from.since;
    return p;
}
Result<Prepared> prepare(const Sweep& s, size_t row) {
    Prepared p = asItIs(s, s.run.rows[row].camera);
    if (Status st = applySetting(p.project, s.tables, s.request.settings[s.settings[row]], p.view); !st)
        return st.error();
    return p;
}
// Frames that add up are judged as a walker sees them: they come up to the camera, a step and a sixtieth of a second
// each, and the last stands where the others' one picture is taken from.
constexpr double kStepSeconds = 1.0 / 60, kStep = 1.4 * kStepSeconds;  // metres: walking pace
// The frame that comes so many steps before the camera.
Status drawBefore(Sweep& s, Prepared& p, int steps) {
    ViewCamera camera = p.camera;
    ViewSettings view = p.view;
    const glm::dvec3 ahead(camera.target.x - camera.eye.x, 0, camera.target.z - camera.eye.z);
    const glm::dvec3 back = -kStep * steps * ahead / std::max(glm::length(ahead), 1e-9);
    camera.eye += back, camera.target += back;
    view.time -= kStepSeconds * steps;
    p.view.begin = false;
    return s.renderer.draw(p.project, camera, view);
}
Status walkUp(Sweep& s, Prepared& p) {
    const Antialias* temporal = temporalOf(p.project);
    p.view.begin = temporal != nullptr;
    for (int steps = temporal ? temporal->frames - 1 : 0; steps > 0; --steps)
        if (Status st = drawBefore(s, p, steps); !st) return st;
    return {};
}
// Milliseconds of one frame with one finish at its end.
Result<double> frameMs(Sweep& s, Prepared& p) {
    const auto start = std::chrono::steady_clock::now();
    if (Status st = s.renderer.draw(p.project, p.camera, p.view); !st) return st.error();
    p.view.begin = false;
    s.renderer.finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}
// The i-th offset in pixels of frames that add up; none of the first. Additive recurrence by the plastic number
// (Roberts 2018).
glm::vec2 offsetOf(int i) {
    const glm::vec2 at = glm::fract(static_cast<float>(i) * glm::vec2(0.7548777f, 0.5698403f) + 0.5f);
    return at - 0.5f;
}
// The mean of the frame that was drawn last and others, whose times are added; of frames that add up, what they come to
// at rest.
Result<Picture> convergedPicture(Sweep& s, Prepared& p, std::vector<double>& ms) {
    if (temporalOf(p.project)) {
        if (Status st = drawSettled(s.renderer, p.project, p.camera, p.view); !st) return st.error();
        return pictureOfLinear(p.view.width, p.view.height, s.renderer.readLinear());
    }
    std::vector<float> sum = s.renderer.readLinear();
    for (int i = 1; i < kConvergedFrames; ++i) {
        if (!s.progress("", -1)) return stopped();
        p.view.jitter = offsetOf(i);
        const auto took = frameMs(s, p);
        if (!took) return took.error();
        ms.push_back(*took);
        const std::vector<float> frame = s.renderer.readLinear();
        for (size_t k = 0; k < sum.size(); ++k) sum[k] += frame[k];
    }
    for (float& v : sum) v /= kConvergedFrames;
    p.view.jitter = {0, 0};
    return pictureOfLinear(p.view.width, p.view.height, sum);
}
// Of the frame that was drawn last.
Status measure(Sweep& s, Prepared& p, CostRow& row, const CostTruth& truth) {
    row.gpuBytes = s.renderer.stats().gpuBytes;
    const std::vector<float> linear = s.renderer.readLinear();
    row.pixels = hashHex(hashText({reinterpret_cast<const char*>(linear.data()), linear.size() * sizeof(float)}));
    row.image = "row-" + s.keyOf(row) + ".png";
    if (Status st = writeImagePng(s.request.folder / row.image, p.view.width, p.view.height, 3, s.renderer.readImage());
        !st)
        return st;
    auto drawn = pairPictures(pictureOfLinear(p.view.width, p.view.height, linear), truth.picture, truth.grass);
    if (!drawn) return drawn.error();
    row.metrics = metricsOf(*drawn);
    auto frames = convergedPicture(s, p, row.ms);
    if (!frames) return frames.error();
    auto converged = pairPictures(std::move(*frames), truth.picture, truth.grass);
    if (!converged) return converged.error();
    row.converged = appearance(*converged);
    return {};
}

// --- what it will take -------------------------------------------------------------------------------------------
// Grass without blades by the technique that asks least of the scene; nothing where there is no grass.
std::optional<CostSetting> plainest(const Sweep& s, const Prepared& p) {
    const auto fields = fieldsOf(p.project);
    if (fields.empty()) return std::nullopt;
    const FieldEntity field = fields.front().second;
    const TechniqueRow* least = nullptr;
    for (const TechniqueRow& row : s.tables.techniques)
        if (row.tiers(field, pixelsPerMetre(p.camera, p.view.height)).blades.max <= 0 &&
            (!least || row.features(field).count() < least->features(field).count()))
            least = &row;
    return least ? std::optional(CostSetting{least->name, {}}) : std::nullopt;
}
// Some blades near the eye, by the first technique that can draw a few.
std::optional<CostSetting> fewBlades(const Sweep& s) {
    for (const TechniqueRow& row : s.tables.techniques)
        if (!row.fewBlades.empty()) return CostSetting{row.name, {row.fewBlades.begin(), row.fewBlades.end()}};
    return std::nullopt;
}
// Milliseconds a blade and of everything else, from two pictures: the field as flat ground, and with blades up to a few
// metres; and the limit, from a third.
Status calibrate(Sweep& s, const std::string& camera) {
    Prepared p = asItIs(s, camera);
    p.view.counted = true;
    double ms[3] = {0, 0, 0};
    uint64_t blades = 0;
    const std::optional<CostSetting> settings[] = {std::nullopt, plainest(s, p), fewBlades(s)};
    for (size_t i = 0; i < 3; ++i) {
        if (settings[i])
            if (Status st = applySetting(p.project, s.tables, *settings[i], p.view); !st) return st;
        for (int frame = 0; frame < 3;
             ++frame) {  // the first makes what it draws with; of the others the quicker, since load only adds
            auto took = frameMs(s, p);
            if (!took) return took.error();
            ms[i] = frame < 2 ? *took : std::min(ms[i], *took);
        }
        blades = s.renderer.stats().bladesGeometry;
    }
    s.msLimit = s.request.maxMs > 0 ? s.request.maxMs : std::max(kLimit * ms[0], kLeastLimit);
    s.msOfRest = ms[1];
    if (blades > 1000)
        s.msPerBlade = std::max(0.0, ms[2] - ms[1]) / static_cast<double>(blades);  // else that of the camera before
    return {};
}
// Why the row is left out unseen; empty: it is drawn once at least. Blades farther away take less than those near by,
// so what is expected is too much rather than too little. What the project ships with, calibrate has drawn.
std::string tooSlow(const Sweep& s, size_t row, const Prepared& p) {
    if (s.run.rows[row].settings == kAsItIs) return "";
    const CostSetting& setting = s.request.settings[s.settings[row]];
    for (const size_t slow : s.slow)
        if (s.run.rows[slow].camera == s.run.rows[row].camera &&
            drawsNoLess(setting, s.request.settings[s.settings[slow]]))
            return fmt::format("draws no less than {}: {}", s.run.rows[slow].settings, s.run.rows[slow].skipped);
    const double blades =
        static_cast<double>(submittedBlades(p.project, s.tables, p.camera, p.view.width, p.view.height)) *
        static_cast<double>(p.view.detail);
    const double expected = s.msOfRest + s.msPerBlade * blades;
    return expected > kSure * s.msLimit ? fmt::format("{:.3g} blades would take about {:.0f} ms, the limit is {:.0f}",
                                                      blades, expected, s.msLimit)
                                        : "";
}
// A frame that makes what the setting draws with, and one that is the row's first time; beyond the limit another, since
// what is left out takes others with it.
Status drawTwice(Sweep& s, Prepared& p, CostRow& row) {
    p.view.begin = true;
    if (auto first = frameMs(s, p); !first) return first.error();
    if (Status st = walkUp(s, p); !st) return st;
    auto ms = frameMs(s, p);
    if (!ms) return ms.error();
    if (*ms > s.msLimit)
        if (auto again = frameMs(s, p); again) ms = std::min(*ms, *again);
    row.ms = {*ms};
    if (*ms > s.msLimit) row.skipped = fmt::format("a frame took {:.0f} ms, the limit is {:.0f}", *ms, s.msLimit);
    return {};
}
Status draw(Sweep& s, size_t i) {
    CostRow& row = s.run.rows[i];
    auto p = prepare(s, i);
    if (!p) return p.error();
    row.skipped = tooSlow(s, i, *p);
    if (row.skipped.empty())
        if (Status st = drawTwice(s, *p, row); !st) return st;
    if (row.skipped.empty()) {
        const auto truth = std::find_if(s.truths.begin(), s.truths.end(),
                                        [&](const CostTruth& t) { return t.floors.camera == row.camera; });
        if (Status st = measure(s, *p, row, *truth); !st) return st;
    }
    return writeFileAtomic(s.fileOf(row), writeJson(costRowJson(row)));
}
// True if the row was drawn before.
bool takeKept(const Sweep& s, CostRow& row) {
    auto kept = readJson(s.fileOf(row));
    if (!kept) return false;
    auto read = costRowFrom(*kept);
    if (!read || (read->skipped.empty() && !fs::exists(s.request.folder / read->image))) return false;
    read->index = row.index;
    row = std::move(*read);
    return true;
}
Status drawAll(Sweep& s) {
    std::string calibrated;
    for (size_t i = 0; i < s.run.rows.size(); ++i) {
        CostRow& row = s.run.rows[i];
        if (!s.progress(row.camera + ": " + row.technique + " " + row.settings,
                        static_cast<double>(i) / static_cast<double>(s.run.rows.size())))
            return stopped();
        if (!takeKept(s, row)) {
            if (calibrated != row.camera)
                if (Status st = calibrate(s, calibrated = row.camera); !st) return st;
            if (Status st = draw(s, i); !st) return st;
        }
        if (!row.skipped.empty()) s.slow.push_back(i);
    }
    return {};
}

// --- timing ------------------------------------------------------------------------------------------------------
fs::path timesFile(const Sweep& s) {
    std::string all;
    for (const CostRow& row : s.run.rows) all += s.keyOf(row);
    return s.request.folder / ("times-" + hashHex(hashText(all)) + ".json");
}
Status timeRow(Sweep& s, size_t i, std::vector<double>& ms) {
    auto p = prepare(s, i);
    if (!p) return p.error();
    p->view.begin = true;
    if (Status st = drawBefore(s, *p, temporalOf(p->project) ? 1 : 0); !st) return st;
    auto took = frameMs(s, *p);
    if (!took) return took.error();
    ms.push_back(*took);
    return {};
}
Status timeAll(Sweep& s) {
    CostTimes t = keptTimes(timesFile(s), s.run.rows.size());
    int round = 1;  // the first were the pictures' frames
    for (const auto& row : t.ms) round = std::max(round, 1 + static_cast<int>(row.size()));
    for (; round < s.request.rounds; ++round) {
        auto next = t.ms;
        for (size_t i = 0; i < s.run.rows.size(); ++i) {
            const CostRow& row = s.run.rows[i];
            if (!row.skipped.empty() || row.ms.empty() || round >= roundsFor(row.ms.front(), s.request.rounds))
                continue;
            const double share =
                (round + static_cast<double>(i) / static_cast<double>(s.run.rows.size())) / s.request.rounds;
            if (!s.progress(fmt::format("times, round {} of {}", round + 1, s.request.rounds), share)) return stopped();
            if (Status st = timeRow(s, i, next[i]); !st) return st;
        }
        t.ms = std::move(next);
        if (Status st = keepTimes(t); !st) return st;
    }
    for (size_t i = 0; i < s.run.rows.size(); ++i) {
        std::vector<double> ms = s.run.rows[i].ms;
        ms.insert(ms.end(), t.ms[i].begin(), t.ms[i].end());
        if (s.run.rows[i].skipped.empty()) takeTimes(s.run.rows[i], std::move(ms));
    }
    return {};
}

// --- the sweep ---------------------------------------------------------------------------------------------------
void listRows(Sweep& s) {
    int index = 0;
    for (const CostView& view : s.request.views)
        for (size_t i = 0; i < s.request.settings.size(); ++i, ++index) {
            if (index % s.request.shards != s.request.shard) continue;
            CostRow row;
            const std::string& technique = s.request.settings[i].technique;
            row.camera = view.name, row.technique = technique.empty() ? ownTechniques(s.project) : technique,
            row.settings = s.request.settings[i].text(), row.index = index;
            s.run.rows.push_back(std::move(row));
            s.settings.push_back(i);
        }
    s.run.total = index;
}
// Of a sweep that is no shard: rows of equal pictures are one, and need no times of their own.
void keepDistinctRows(Sweep& s) {
    const std::vector<size_t> kept = distinctRows(s.run.rows);
    for (size_t i = 0; i < kept.size(); ++i) s.settings[i] = s.settings[kept[i]];
    s.settings.resize(kept.size());
    keepDistinct(s.run);
}
Status traceTruths(Sweep& s) {
    for (const CostView& view : s.request.views) {
        auto truth = costTruth(s.request, s.project, s.tables, view, s.progress);
        if (!truth) return truth.error();
        s.run.floors.push_back(truth->floors);
        s.truths.push_back(std::move(*truth));
    }
    return {};
}

}  // namespace

Result<CostRun> runCost(const CostRequest& request, const Project& project, const Tables& tables, Gpu& gpu,
                        const CostProgress& progress) {
    std::error_code ec;
    fs::create_directories(request.folder, ec);
    if (ec) return failed("cannot make the folder: " + ec.message(), "choose another --out").at(request.folder);
    Sweep s{request, project, tables, gpu, progress};
    s.hash = sweepHash(request, project, tables);
    s.run.project = project.name, s.run.hash = s.hash, s.run.width = request.width, s.run.height = request.height,
    s.run.samples = request.truth.samples;
    s.run.lighting = kReferenceLightings[request.truth.lighting];
    s.run.machines.push_back(thisMachine(gpu.renderer, "wall-finish"));
    listRows(s);
    if (Status st = traceTruths(s); !st) return st.error();
    if (Status st = drawAll(s); !st) return st.error();
    if (request.shards == 1) keepDistinctRows(s);
    if (Status st = timeAll(s); !st) return st.error();
    markFrontier(s.run.rows);
    return std::move(s.run);
}

// --- the frontier ------------------------------------------------------------------------------------------------

}  // namespace sward
