#include "cli/cli.h"
#include "cli/cost_request.h"
#include "cli/interrupt.h"
#include "core/file.h"
#include "core/json.h"
#include "cost/fit.h"
#include "project/project_files.h"
#include "techniques.h"

namespace sward {
namespace {

std::string textOf(const FitCandidate& c) { return CostSetting{"hybrid", c.values}.text(); }
std::string described(const FitCandidate& c) {
    return fmt::format("{:.1f} ms, appearance {}: {}", c.ms,
                       std::isfinite(c.appearance) ? fmt::format("{:.5f}", c.appearance) : "not taken", textOf(c));
}
bool known(const FitCandidate& c) { return !c.values.empty(); }

Json numberJson(double v) { return std::isfinite(v) ? Json(v) : Json(); }
Json candidateJson(const FitCandidate& c) {
    if (!known(c)) return {};
    Json j;
    j["ms"] = c.ms, j["appearance"] = numberJson(c.appearance), j["settings"] = textOf(c);
    return j;
}
Json fitJson(const FitResult& r, double budgetMs) {
    Json j;
    j["technique"] = r.technique;
    j["budget_ms"] = budgetMs, j["fits"] = r.fits, j["tried"] = r.tried;
    j["best"] = candidateJson(r.best), j["shipped"] = candidateJson(r.shipped), j["grid"] = candidateJson(r.gridBest),
    j["next_better"] = candidateJson(r.given);
    Json& held = j["held_out"];
    held["shipped"] = numberJson(r.heldOut.shipped), held["fitted"] = numberJson(r.heldOut.fitted),
    held["grid"] = numberJson(r.heldOut.grid), held["note"] = r.heldOut.note;
    return j;
}

std::string number(double v) { return std::isfinite(v) ? fmt::format("{:.5f}", v) : "none"; }
void printFit(const FitResult& r) {
    std::printf("fits      %s\nshipped   %s\n", described(r.best).c_str(), described(r.shipped).c_str());
    std::printf("grid      %s\n", known(r.gridBest) ? described(r.gridBest).c_str() : "no point of the grid fits");
    std::printf("given up  %s\n", known(r.given) ? described(r.given).c_str() : "nothing: no better one was seen");
    std::printf("held out  appearance %s, shipped %s, grid %s%s%s\n", number(r.heldOut.fitted).c_str(),
                number(r.heldOut.shipped).c_str(), number(r.heldOut.grid).c_str(), r.heldOut.note.empty() ? "" : "; ",
                r.heldOut.note.c_str());
}

// Truths are kept beside other caches, under their hash.
std::filesystem::path truthFolder() { return cacheDir() / "truths"; }

// The file as it is, without --set, gets the settings.
Status save(const FitOptions& o, const FitResult& found) {
    auto project = loadProject(o.project, tables().components);
    if (!project) return project.error();
    ViewSettings view;
    if (Status s = applySetting(*project, tables(), {found.technique, found.best.values}, view); !s) return s;
    auto written = saveProject(*project, tables().components);
    return written ? Status() : Status(written.error());
}

}  // namespace

int fitVerb(const FitOptions& o) {
    if (!(o.budgetMs > 0)) return report(usage("--budget-ms takes a number above 0"));
    if (o.candidates < 1 || o.candidates > 10000) return report(usage("--candidates takes 1 to 10000"));
    auto project = openForRendering(o);
    if (!project) return report(project.error());
    auto cost = costRequest(o, *project);
    if (!cost) return report(cost.error());
    cost->folder = truthFolder();
    auto gpu = makeHeadlessGpu();
    if (!gpu) return report(gpu.error());
    const Interruptible here;
    const auto r = runFit({o.budgetMs, o.candidates, std::move(*cost)}, *project, tables(), **gpu, costProgress());
    if (!r) return report(r.error());
    if (o.json) std::printf("%s", writeJson(fitJson(*r, o.budgetMs)).c_str());
    if (!r->fits)
        return report(failed(fmt::format("nothing fits {} ms; the nearest of {} tried takes {}", o.budgetMs, r->tried,
                                         described(r->best)),
                             "raise --budget-ms, or lower --size"));
    if (!o.json) printFit(*r);
    if (!o.write) return 0;
    if (Status s = save(o, *r); !s) return report(s.error());
    if (!o.json) std::printf("saved in %s\n", o.project.c_str());
    return 0;
}

}  // namespace sward
