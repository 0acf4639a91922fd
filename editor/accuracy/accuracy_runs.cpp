// Sweeps and fits as programs beside the editor, on a copy of the project as it is now, and what is done with their
// results.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "accuracy/accuracy.h"
#include "app/frame_clock.h"
#include "app/messages.h"
#include "app/time_left.h"
#include "core/file.h"
#include "core/hash.h"
#include "cost/cost_files.h"
#include "model/document.h"
#include "project/project_files.h"
#include "tools/camera_control.h"
#include "world/view_camera.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr const char* kSize = "320x240";
constexpr const char* kSamples = "16";

fs::path folderFor(const Document& doc) {
    return stateDir() / "cost" / hashHex(projectHash(doc.project(), doc.tables().components));
}

// Unsaved work included, and the view as a camera of that name; image files come from the project's folder.
Status writeCopy(const Document& doc, const fs::path& to, const std::string& camera, const FlyCamera& from) {
    std::error_code fault;
    fs::remove_all(to, fault);
    if (Status s = makeFolderOf(to); !s) return s;
    Project copy = snapshot(doc.project(), doc.tables().components), original;
    original.dir = copy.dir;
    copy.dir = to;
    if (findEntity(copy, camera) == kNoEntity) {
        const Result<Entity> added = addEntity(copy, camera);
        if (!added) return added.error();
        const ViewCamera view = viewOf(from);
        Camera c;
        c.eye = view.eye, c.target = view.target, c.fovDeg = view.fovDeg, c.exposure = view.exposure;
        copy.registry.add<Camera>(*added, c);
    }
    const auto written = saveProject(copy, doc.tables().components, original.dir.empty() ? nullptr : &original);
    return written ? Status{} : Status{written.error()};
}

bool isNews(const std::string& line) { return line.find(" %  ") < 4; }

// But for progress.
std::string lastLine(const fs::path& file) {
    const Result<std::string> text = readFile(file, 1 << 20);
    if (!text) return "";
    std::string line, last;
    for (std::istringstream in(*text); std::getline(in, line);)
        if (!line.empty() && !isNews(line)) last = line;
    return last;
}

std::string failure(const char* verb, int code, const fs::path& errors) {
    const std::string said = lastLine(errors);
    return said.empty() ? fmt::format("sward {} ended with exit code {}", verb, code) : said;
}

template <class Run>
Status launch(const MeasureParts& p, Run& run, const char* verb, std::vector<std::string> more) {
    if (!p.doc.isOpen()) return failed("no project is open", "open or create one first");
    const std::string camera = run.camera = accuracyCamera(p.doc, p.camera);
    if (run.child.running()) return failed(std::string(verb) + " runs already", "stop it first");
    run.folder = folderFor(p.doc);
    run.copy = run.folder / (std::string("project-") + verb);
    run.started = p.clock.now;
    run.news = {.since = p.clock.now};
    run.error.clear();
    if (Status s = writeCopy(p.doc, run.copy, camera, p.camera); !s) return s;
    std::vector<std::string> args{p.program, verb,  run.copy.string(), "--camera", camera,
                                  "--size",  kSize, "--samples",       kSamples};
    args.insert(args.end(), more.begin(), more.end());
    Result<ChildProcess> child =
        ChildProcess::start(args, run.folder / (std::string(verb) + ".out"), run.folder / (std::string(verb) + ".err"));
    if (!child) return child.error();
    run.child = std::move(*child);
    return {};
}

template <class Run>
void dropCopy(Run& run) {
    std::error_code ignored;
    if (!run.copy.empty()) fs::remove_all(run.copy, ignored);
    run.copy.clear();
}

template <class Run>
void stopRun(Run& run) {
    run.child.stop();
    dropCopy(run);
}

// The end of a run: its exit code, once.
template <class Run>
std::optional<int> ended(Run& run, FrameClock& clock) {
    const std::optional<int> code = run.child.poll();
    if (!code) return {};
    dropCopy(run);
    clock.wanted = 4;
    return code;
}

void finishSweep(Sweep& s, Messages& messages, int code) {
    if (code != 0) {
        s.error = failure("cost", code, s.folder / "cost.err");
        return;
    }
    Result<CostRun> run = readCost(s.folder / "cost.json");
    if (run)
        s.run = std::move(*run), say(messages, fmt::format("measured: {} settings", s.run->rows.size()));
    else
        s.error = run.error().text();
}

// It prints its result, also that nothing fits.
void finishFit(Fit& f, Messages& messages, int code) {
    const Result<std::string> text = readFile(f.folder / "fit.out", 1 << 20);
    Result<FitShown> shown =
        text && !text->empty() ? fitFrom(*text) : Result<FitShown>(failed(failure("fit", code, f.folder / "fit.err")));
    if (shown)
        f.result = std::move(*shown),
        say(messages, f.result->fits ? "fitted to the budget" : "nothing fits the budget");
    else
        f.error = shown.error().text();
}

constexpr double kLookSeconds = 0.5;

// Looks now and then at what the program printed. True if it is further.
template <class Run>
bool followNews(Run& run, const char* verb, double now) {
    if (!run.child.running() || now - run.news.read < kLookSeconds) return false;
    run.news.read = now;
    const Result<std::string> text = readFile(run.folder / (std::string(verb) + ".err"), 1 << 20);
    std::optional<RunNews> told = text ? newsFrom(*text) : std::nullopt;
    if (!told || (told->what == run.news.what && told->share == run.news.share)) return false;
    if (told->share >= run.news.share && !run.news.what.empty())
        told->since = run.news.since;
    else
        told->since = now;  // another part
    told->read = now;
    run.news = std::move(*told);
    return true;
}

// What is drawn so far, as a plot without floors.
void showRowsSoFar(Sweep& s) {
    CostRun run;
    run.rows = rowsSoFar(s.folder / "work", s.camera);
    if (run.rows.empty()) return;
    run.floors.push_back({.camera = s.camera});
    std::sscanf(kSize, "%dx%d", &run.width, &run.height);
    markFrontier(run.rows);
    s.run = std::move(run);
}

double numberAt(const Json& j, const char* key) {
    const Json* v = j.find(key);
    return v && v->type == Json::Type::Number ? v->number : std::numeric_limits<double>::quiet_NaN();
}
std::string textAt(const Json& j, const char* key) {
    const Json* v = j.find(key);
    return v && v->type == Json::Type::String ? v->text : "";
}

bool isViewSetting(const std::string& value) { return value.starts_with("msaa=") || value.starts_with("detail="); }

std::vector<std::string> grassEntities(const Document& document) {
    std::vector<std::string> names;
    for (const auto& [name, e] : document.project().entities)
        if (document.project().registry.get<GrassField>(e)) names.push_back(name);
    return names;
}

Status adoptIn(Document& document, const std::string& entity, const CostSetting& setting) {
    if (Status s = document.setField(entity + ".GrassField.technique", setting.technique); !s) return s;
    for (const std::string& text : setting.values) {
        const auto v = settingValue(text);
        if (!v || isViewSetting(text) || !v->isFor(entity)) continue;
        const std::string path = settingPath(document.tables(), entity, setting.technique, v->name);
        if (Status s = document.setField(path, v->value); !s) return s;
    }
    return {};
}

}  // namespace

void startSweep(Sweep& s, const MeasureParts& parts) {
    s.run.reset();
    const Status started = launch(parts, s, "cost", {"--rounds", "3", "--out", folderFor(parts.doc).string()});
    if (!accept(parts.messages, started)) dropCopy(s);
}

void startFit(Fit& f, const MeasureParts& parts) {
    f.result.reset();
    const Status started =
        launch(parts, f, "fit", {"--budget-ms", fmt::format("{:g}", f.budget), "--candidates", "20", "--json"});
    if (!accept(parts.messages, started)) dropCopy(f);
}

void followRuns(Accuracy& accuracy, FrameClock& clock, Messages& messages) {
    const bool further = followNews(accuracy.sweep, "cost", clock.now);
    if (further) showRowsSoFar(accuracy.sweep);
    if (followNews(accuracy.fit, "fit", clock.now) || further) clock.wanted = std::max(clock.wanted, 2);
    if (const auto code = ended(accuracy.sweep, clock)) finishSweep(accuracy.sweep, messages, *code);
    if (const auto code = ended(accuracy.fit, clock)) finishFit(accuracy.fit, messages, *code);
}

bool measuring(const Accuracy& accuracy) { return accuracy.sweep.child.running() || accuracy.fit.child.running(); }

void stopSweep(Sweep& sweep) { stopRun(sweep); }
void stopFit(Fit& fit) { stopRun(fit); }
void stopRuns(Accuracy& accuracy) { stopSweep(accuracy.sweep), stopFit(accuracy.fit); }

std::vector<CostRow> rowsSoFar(const fs::path& work, const std::string& camera) {
    std::vector<fs::path> files;
    std::error_code fault;
    for (fs::directory_iterator it(work, fault), end; !fault && it != end; it.increment(fault))
        if (it->path().filename().string().starts_with("row-") && it->path().extension() == ".json")
            files.push_back(it->path());
    std::sort(files.begin(), files.end());
    std::vector<CostRow> rows;
    for (const fs::path& file : files) {
        const auto json = readJson(file);
        auto row = json ? costRowFrom(*json) : Result<CostRow>(failed("none"));
        if (!row || row->camera != camera || !row->skipped.empty() || row->ms.empty()) continue;
        std::sort(row->ms.begin(), row->ms.end());
        row->msMedian = row->ms[row->ms.size() / 2];
        rows.push_back(std::move(*row));
    }
    return rows;
}

std::optional<RunNews> newsFrom(const std::string& text) {
    std::optional<RunNews> news;
    std::string line;
    for (std::istringstream in(text); std::getline(in, line);)
        if (isNews(line))
            news =
                RunNews{.what = line.substr(line.find(" %  ") + 4), .share = std::strtod(line.c_str(), nullptr) / 100};
    return news;
}

std::string newsText(const RunNews& news, double now) {
    if (news.what.empty()) return fmt::format("starts, {:.0f} s", std::max(now - news.since, 0.0));
    const std::string left = timeLeft(news.share, now - news.since);
    return fmt::format("{:.0f} %{}{}: {}", 100 * news.share, left.empty() ? "" : ", ", left, news.what);
}

std::string adoptedText(const CostSetting& setting, std::span<const std::string> left) {
    std::string text = "adopted: " + setting.technique, stays;
    for (std::string value : setting.values) {
        if (isViewSetting(value)) continue;
        if (const size_t at = value.find('='); at != std::string::npos) value[at] = ' ';
        text += ", " + value;
    }
    for (const std::string& value : left)
        stays += (stays.empty() ? "" : " and ") + std::string(value.starts_with("msaa=") ? "4 samples" : "all blades");
    return stays.empty() ? text : text + "; " + stays + " stay as they are";
}

std::string accuracyCamera(const Document& document, const FlyCamera& view) {
    const ViewCamera now = viewOf(view);
    for (const auto& [name, e] : document.project().entities) {
        const Camera* c = document.project().registry.get<Camera>(e);
        if (c && glm::length(c->eye - now.eye) < 1e-4 &&
            glm::length(glm::normalize(c->target - c->eye) - forwardOf(view)) < 1e-5)
            return name;
    }
    Hasher h;
    for (const double v :
         {now.eye.x, now.eye.y, now.eye.z, now.target.x, now.target.y, now.target.z, static_cast<double>(now.fovDeg)})
        h.add(&v, sizeof v);
    return "view-" + hashHex(h.value()).substr(0, 8);
}

CostSetting settingOf(const std::string& technique, const std::string& text) {
    CostSetting s{technique, {}};
    std::istringstream in(text);
    for (std::string word; in >> word;)
        if (word.find('=') != std::string::npos) s.values.push_back(word);
    return s;
}

bool isPresent(const Document& document, const CostSetting& setting) {
    for (const std::string& entity : grassEntities(document)) {
        const Project& project = document.project();
        if (project.registry.get<GrassField>(findEntity(project, entity))->technique != setting.technique) return false;
        for (const std::string& value : setting.values) {
            if (isViewSetting(value) && value != "msaa=4" && value != "detail=1") return false;
            const auto v = settingValue(value);
            if (!v || isViewSetting(value) || !v->isFor(entity)) continue;
            const auto field = findField(project, document.tables().components,
                                         settingPath(document.tables(), entity, setting.technique, v->name));
            if (!field || fieldText(*field) != v->value) return false;
        }
    }
    return true;
}

Result<std::vector<std::string>> adoptSettings(Document& document, const CostSetting& setting) {
    Status done;
    document.beginGroup("adopt settings");
    for (const std::string& entity : grassEntities(document))
        if (done) done = adoptIn(document, entity, setting);
    done ? document.endGroup() : document.cancelGroup();
    if (!done) return done.error();
    std::vector<std::string> left;
    for (const std::string& value : setting.values)
        if (isViewSetting(value)) left.push_back(value);
    return left;
}

Result<FitShown> fitFrom(const std::string& text) {
    const Result<Json> j = parseJson(text, "fit.out");
    if (!j) return j.error();
    const Json *best = j->find("best"), *shipped = j->find("shipped"), *better = j->find("next_better"),
               *fits = j->find("fits");
    if (!best || !shipped || !fits || best->type != Json::Type::Object)
        return unsound("sward fit gave no result", "measure again");
    FitShown f;
    f.fits = fits->boolean;
    f.technique = textAt(*j, "technique");
    f.budget = numberAt(*j, "budget_ms");
    f.ms = numberAt(*best, "ms"), f.appearance = numberAt(*best, "appearance"), f.settings = textAt(*best, "settings");
    if (shipped->type == Json::Type::Object)
        f.shippedMs = numberAt(*shipped, "ms"), f.shippedAppearance = numberAt(*shipped, "appearance");
    if (better && better->type == Json::Type::Object)
        f.better = fmt::format("{:.3g} ms for {:.4f}: {}", numberAt(*better, "ms"), numberAt(*better, "appearance"),
                               textAt(*better, "settings"));
    return f;
}

}  // namespace sward
