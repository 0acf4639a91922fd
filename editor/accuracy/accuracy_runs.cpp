// Sweeps and fits as programs beside the editor, on a copy of the project as it is now, and what is done with their
// results.
#include <fmt/format.h>

#include <limits>
#include <sstream>

#include "accuracy/accuracy.h"
#include "app/frame_clock.h"
#include "app/messages.h"
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

// Unsaved work included; image files come from the project's folder.
Status writeCopy(const Document& doc, const fs::path& to) {
    std::error_code fault;
    fs::remove_all(to, fault);
    if (Status s = makeFolderOf(to); !s) return s;
    Project copy = snapshot(doc.project(), doc.tables().components), original;
    original.dir = copy.dir;
    copy.dir = to;
    const auto written = saveProject(copy, doc.tables().components, original.dir.empty() ? nullptr : &original);
    return written ? Status{} : Status{written.error()};
}

std::string lastLine(const fs::path& file) {
    const Result<std::string> text = readFile(file, 1 << 20);
    if (!text) return "";
    std::string line, last;
    for (std::istringstream in(*text); std::getline(in, line);)
        if (!line.empty()) last = line;
    return last;
}

std::string failure(const char* verb, int code, const fs::path& errors) {
    const std::string said = lastLine(errors);
    return said.empty() ? fmt::format("sward {} ended with exit code {}", verb, code) : said;
}

template <class Run>
Status launch(const MeasureParts& p, Run& run, const char* verb, std::vector<std::string> more) {
    if (!p.doc.isOpen()) return failed("no project is open", "open or create one first");
    const std::string camera = accuracyCamera(p.doc, p.camera);
    if (camera.empty()) return unsound("the project has no camera to measure from", "add an entity with a Camera");
    if (run.child.running()) return failed(std::string(verb) + " runs already", "stop it first");
    run.folder = folderFor(p.doc);
    run.copy = run.folder / (std::string("project-") + verb);
    run.started = p.clock.now;
    run.error.clear();
    if (Status s = writeCopy(p.doc, run.copy); !s) return s;
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
    if (const auto code = ended(accuracy.sweep, clock)) finishSweep(accuracy.sweep, messages, *code);
    if (const auto code = ended(accuracy.fit, clock)) finishFit(accuracy.fit, messages, *code);
}

bool measuring(const Accuracy& accuracy) { return accuracy.sweep.child.running() || accuracy.fit.child.running(); }

void stopSweep(Sweep& sweep) { stopRun(sweep); }
void stopFit(Fit& fit) { stopRun(fit); }
void stopRuns(Accuracy& accuracy) { stopSweep(accuracy.sweep), stopFit(accuracy.fit); }

int rowsMeasured(const Sweep& sweep) {
    int rows = 0;
    std::error_code fault;
    for (fs::directory_iterator it(sweep.folder / "work", fault), end; !fault && it != end; it.increment(fault))
        if (it->path().filename().string().starts_with("row-") && it->path().extension() == ".json") ++rows;
    return rows;
}

std::string accuracyCamera(const Document& document, const FlyCamera& view) {
    std::string first;
    const ViewCamera now = viewOf(view);
    for (const auto& [name, e] : document.project().entities) {
        const Camera* c = document.project().registry.get<Camera>(e);
        if (!c) continue;
        if (first.empty()) first = name;
        if (glm::length(c->eye - now.eye) < 1e-4 &&
            glm::length(glm::normalize(c->target - c->eye) - forwardOf(view)) < 1e-5)
            return name;
    }
    return first;
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
