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

std::string described(const FitCandidate& c) {
    const std::string technique = c.setting.technique.empty() ? "" : c.setting.technique + " ";
    return fmt::format(
        "{:.1f} ms, appearance {}: {}{}", c.ms,
        std::isfinite(c.appearance) ? fmt::format("{:.5f} +- {:.5f}", c.appearance, c.sigma) : "not taken", technique,
        c.setting.text());
}

Json numberJson(double v) { return std::isfinite(v) ? Json(v) : Json(); }
Json candidateJson(const FitCandidate& c) {
    if (!c.known()) return {};
    Json j;
    j["ms"] = c.ms, j["appearance"] = numberJson(c.appearance), j["appearance_sigma"] = numberJson(c.sigma);
    j["technique"] = c.setting.technique, j["settings"] = c.setting.text();
    return j;
}
Json verdictJson(const FitVerdict& v) {
    Json j;
    j["search"] = kFitOutcomes[v.outcome], j["against"] = v.rival;
    return j;
}
Json fitJson(const FitResult& r, double budgetMs) {
    Json j;
    j["technique"] = r.fitted.setting.technique;
    j["budget_ms"] = budgetMs, j["fits"] = r.fits, j["tried"] = r.tried;
    j["cut_short"] = r.cutShort, j["truth_samples"] = r.truthSamples;
    j["best"] = candidateJson(r.fitted), j["shipped"] = candidateJson(r.shipped), j["grid"] = candidateJson(r.gridBest),
    j["next_better"] = candidateJson(r.given);
    Json& held = j["held_out"];
    held["shipped"] = numberJson(r.heldOut.shipped.appearance),
    held["fitted"] = numberJson(r.heldOut.fitted.appearance), held["grid"] = numberJson(r.heldOut.grid.appearance),
    held["note"] = r.heldOut.note;
    held["shipped_sigma"] = numberJson(r.heldOut.shipped.sigma),
    held["fitted_sigma"] = numberJson(r.heldOut.fitted.sigma), held["grid_sigma"] = numberJson(r.heldOut.grid.sigma);
    if (r.fits) j["outcome"]["seen"] = verdictJson(r.seen), j["outcome"]["held_out"] = verdictJson(r.unseen);
    return j;
}

std::string number(const FitScore& s) {
    return std::isfinite(s.appearance) ? fmt::format("{:.5f} +- {:.5f}", s.appearance, s.sigma) : "none";
}
std::string said(const FitVerdict& v) {
    if (v.rival.empty()) return "the search stands alone: nothing else fits";
    const std::string rival = v.rival == "grid" ? "the grid" : "the shipped settings";
    return v.outcome == FitOutcome::Wins    ? "the search wins against " + rival
           : v.outcome == FitOutcome::Loses ? "the search loses to " + rival
                                            : "the search and " + rival + " differ by less than the standard error";
}
void printFit(const FitResult& r) {
    std::printf("fitted    %s\nshipped   %s\n", described(r.fitted).c_str(), described(r.shipped).c_str());
    std::printf("grid      %s\n", r.gridBest.known() ? described(r.gridBest).c_str() : "no point of the grid fits");
    std::printf("given up  %s\n", r.given.known() ? described(r.given).c_str() : "nothing: no better one was seen");
    std::printf("held out  appearance %s, shipped %s, grid %s%s%s\n", number(r.heldOut.fitted).c_str(),
                number(r.heldOut.shipped).c_str(), number(r.heldOut.grid).c_str(), r.heldOut.note.empty() ? "" : "; ",
                r.heldOut.note.c_str());
    if (r.cutShort)
        std::printf("cut short by --seconds after %d settings, held against truths of %d samples\n", r.tried,
                    r.truthSamples);
    std::printf("outcome   %s; held out, %s\n", said(r.seen).c_str(), said(r.unseen).c_str());
}

// Truths are kept beside other caches, under their hash.
std::filesystem::path truthFolder() { return cacheDir() / "truths"; }

// The file as it is, without --set, gets the settings.
Status save(const FitOptions& o, const FitResult& found) {
    auto project = loadProject(o.project, tables().components);
    if (!project) return project.error();
    ViewSettings view;
    if (Status s = applySetting(*project, tables(), chosen(found).setting, view); !s) return s;
    auto written = saveProject(*project, tables().components);
    return written ? Status() : Status(written.error());
}

}  // namespace

int fitVerb(const FitOptions& o) {
    if (!(o.budgetMs > 0)) return report(usage("--budget-ms takes a number above 0"));
    if (!(o.seconds > 0)) return report(usage("--seconds takes a number above 0"));
    if (o.candidates < 1 || o.candidates > 10000) return report(usage("--candidates takes 1 to 10000"));
    RenderOptions asItIs = o;  // --technique says what to turn, not how the project is drawn
    asItIs.technique.clear();
    auto project = openForRendering(asItIs);
    if (!project) return report(project.error());
    auto cost = costRequest(o, *project);
    if (!cost) return report(cost.error());
    cost->folder = truthFolder();
    auto gpu = makeHeadlessGpu();
    if (!gpu) return report(gpu.error());
    const Interruptible here;
    FitRequest request{o.budgetMs, o.candidates, o.seconds, o.technique, {}, std::move(*cost)};
    if (!o.soFar.empty())
        request.betterFound = [&](const FitResult& best) {
            if (Status s = writeFileAtomic(o.soFar, writeJson(fitJson(best, o.budgetMs))); !s) report(s.error());
        };
    const auto r = runFit(request, *project, tables(), **gpu, costProgress());
    if (!r) return report(r.error());
    if (o.json) std::printf("%s", writeJson(fitJson(*r, o.budgetMs)).c_str());
    if (!r->fits)
        return report(failed(fmt::format("nothing fits {} ms; the nearest of {} tried takes {}", o.budgetMs, r->tried,
                                         described(r->fitted)),
                             "raise --budget-ms, or lower --size"));
    if (!o.json) printFit(*r);
    if (!o.write) return 0;
    if (chosen(*r).setting.values.empty()) {
        if (!o.json) std::printf("nothing is saved: the shipped settings are better\n");
        return 0;
    }
    if (Status s = save(o, *r); !s) return report(s.error());
    if (!o.json) std::printf("saved in %s: %s\n", o.project.c_str(), described(chosen(*r)).c_str());
    for (const std::string& value : chosen(*r).setting.values)
        if (!o.json && value.starts_with("msaa="))
            std::printf("samples are the view's: draw with --msaa %s\n", value.substr(5).c_str());
    return 0;
}

}  // namespace sward
