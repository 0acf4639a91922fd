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
#include "core/file.h"
#include "core/hash.h"
#include "cost/cost_files.h"
#include "model/antialias_edit.h"
#include "model/document.h"
#include "scene/antialias.h"
#include "scene/forest_technique.h"
#include "tools/camera_control.h"
#include "world/view_camera.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr const char* kSize = "320x240";
constexpr const char* kSamples = "16";

Status launch(SideRun& run, const MeasureParts& p, const char* verb, std::vector<std::string> more) {
    if (!p.doc.isOpen()) return failed("no project is open", "open or create one first");
    more.insert(more.begin(), {"--size", kSize, "--samples", kSamples});
    return launchRun(run, p, verb, accuracyCamera(p.doc, p.camera), more);
}

void finishSweep(Sweep& s, Messages& messages, int code) {
    if (code != 0) {
        s.error = failureOf(s, "cost", code);
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
        text && !text->empty() ? fitFrom(*text) : Result<FitShown>(failed(failureOf(f, "fit", code)));
    if (shown)
        f.result = std::move(*shown),
        say(messages, f.result->fits ? (f.result->cutShort ? "fitted to the budget, as well as the time allowed"
                                                           : "fitted to the budget")
                                     : "nothing fits the budget");
    else
        f.error = shown.error().text();
}

fs::path soFarFile(const Fit& f) { return f.folder / "fit.so-far"; }

void showSoFar(Fit& f) {
    const Result<std::string> text = readFile(soFarFile(f), 1 << 20);
    const Result<FitShown> shown = text ? fitFrom(*text) : Result<FitShown>(text.error());
    if (shown) f.result = *shown;
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

// "search loses to shipped from other cameras"; "" where the fit says nothing of it.
std::string outcomeOf(const Json& fit) {
    const Json* outcome = fit.find("outcome");
    const Json* held = outcome ? outcome->find("held_out") : nullptr;
    if (!held) return "";
    const std::string search = textAt(*held, "search"), against = textAt(*held, "against");
    if (against.empty()) return "";
    const std::string rival = against == "grid" ? "the grid" : "the settings as they are";
    return "from other cameras " + (search == "loses"  ? rival + " come nearer: better not adopted"
                                    : search == "even" ? "as good as " + rival
                                                       : "better than " + rival);
}

bool isViewSetting(const std::string& value) { return value.starts_with("msaa=") || value.starts_with("detail="); }

Status adoptIn(Document& document, const std::string& entity, const CostSetting& setting) {
    const auto [held, technique] = techniqueField(entity, setting.technique);
    if (Status s = document.setField(held, technique); !s) return s;
    for (const std::string& text : setting.values) {
        const auto v = settingValue(text);
        if (v && v->name == "msaa" && temporalOf(document.project()))
            if (Status s = chooseAntialias(document, Antialiasing::Msaa); !s) return s;
        if (!v || isViewSetting(text) || !v->isFor(entity)) continue;
        if (v->name == kAntialiasSetting) {
            const bool temporal = text == kTemporalSetting;
            if (Status s = chooseAntialias(document, temporal ? Antialiasing::Temporal : Antialiasing::Msaa); !s)
                return s;
            continue;
        }
        const std::string path = settingPath(document.tables(), entity, setting.technique, v->name);
        if (Status s = document.setField(path, v->value); !s) return s;
    }
    return {};
}

}  // namespace

void startSweep(Sweep& s, const MeasureParts& parts) {
    s.run.reset();
    s.revision = parts.doc.revision();
    const std::string out = parts.doc.isOpen() ? sideFolder(parts.doc).string() : "";
    accept(parts.messages, launch(s, parts, "cost", {"--rounds", "3", "--out", out}));
}

void startFit(Fit& f, const MeasureParts& parts) {
    f.result.reset();
    const std::string budget = fmt::format("{:g}", f.budget);
    if (parts.doc.isOpen()) f.folder = sideFolder(parts.doc);
    std::error_code ignored;
    fs::remove(soFarFile(f), ignored);
    std::vector<std::string> more{"--budget-ms",  budget,
                                  "--candidates", "40",
                                  "--seconds",    fmt::format("{:g}", 60 * f.minutes),
                                  "--so-far",     soFarFile(f).string(),
                                  "--json"};
    if (f.forests && !growingForests(parts.doc.project()).empty())
        more.insert(more.end(), {"--technique", kEveryForestTechnique});
    accept(parts.messages, launch(f, parts, "fit", more));
}

void followRuns(Accuracy& accuracy, FrameClock& clock, Messages& messages) {
    const bool further = followNews(accuracy.sweep, "cost", clock.now);
    if (further) showRowsSoFar(accuracy.sweep);
    const bool fitted = followNews(accuracy.fit, "fit", clock.now);
    if (fitted) showSoFar(accuracy.fit);
    if (fitted || further) clock.wanted = std::max(clock.wanted, 2);
    if (const auto code = endedRun(accuracy.sweep, clock)) finishSweep(accuracy.sweep, messages, *code);
    if (const auto code = endedRun(accuracy.fit, clock)) finishFit(accuracy.fit, messages, *code);
}

bool measuring(const Accuracy& accuracy) { return accuracy.sweep.running() || accuracy.fit.running(); }

void stopSweep(Sweep& sweep) { stopRun(sweep); }
void stopFit(Fit& fit) {
    if (fit.running()) showSoFar(fit);
    stopRun(fit);
}
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
    const Project& project = document.project();
    for (const std::string& entity : entitiesOf(project, setting.technique)) {
        const auto [held, technique] = techniqueField(entity, setting.technique);
        const auto own = findField(project, document.tables().components, held);
        if (!own || fieldText(*own) != technique) return false;
        for (const std::string& value : setting.values) {
            if (isViewSetting(value) && value != "msaa=4" && value != "detail=1") return false;
            if (value.starts_with("msaa=") && temporalOf(project)) return false;
            const auto v = settingValue(value);
            if (!v || isViewSetting(value) || !v->isFor(entity)) continue;
            if (v->name == kAntialiasSetting) {
                if ((temporalOf(project) != nullptr) != (value == kTemporalSetting)) return false;
                continue;
            }
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
    for (const std::string& entity : entitiesOf(document.project(), setting.technique))
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
    f.outcome = outcomeOf(*j);
    const Json* cut = j->find("cut_short");
    f.cutShort = cut && cut->boolean;
    return f;
}

}  // namespace sward
