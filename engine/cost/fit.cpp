// Index: candidates · measuring one · the search · the grid · cameras that were not seen · all of it.
#include "cost/fit.h"
#include "cost/cost_times.h"

#include <chrono>
#include <map>

#include "core/json.h"
#include "cost/cost_truth.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr int kFrames = 5, kLeastFrames = 3;  // of a timing's median, after one that is not counted
constexpr double kTimedMs = 1500;             // more than the least number only within this time
constexpr double kHopeless =
    1.5;  // times the budget: a candidate slower than that from one camera is not drawn from others
constexpr double kStep = 2, kLeastStep = 1.1892;  // factors: a doubling, and its fourth root

// --- candidates --------------------------------------------------------------------------------------------------
// How far each of the technique's knobs is turned (KnobRow), in the order of its rows.
using Knobs = std::vector<double>;

struct Seen {
    const CostView& view;
    CostTruth truth;
};
struct Search {
    const FitRequest& request;
    const Project& project;
    const Tables& tables;
    Gpu& gpu;
    const CostProgress& progress;
    Renderer renderer{gpu, tables};
    const TechniqueRow* technique = nullptr;
    std::vector<Seen> views = {};
    std::map<std::vector<std::string>, FitCandidate> seen = {};
    int limit = 0;
};
Error stopped() { return interruption("interrupted; nothing was changed"); }

// --- measuring one -----------------------------------------------------------------------------------------------
struct Drawing {
    Project project;
    ViewCamera camera;
    ViewSettings view;
};
Result<Drawing> drawingOf(Search& s, const std::vector<std::string>& values, const CostView& from) {
    if (!s.progress(fmt::format("{} of about {} candidates", s.seen.size(), s.limit),
                    static_cast<double>(s.seen.size()) / std::max(1, s.limit)))
        return stopped();
    Drawing d{snapshot(s.project, s.tables.components), from.camera, {}};
    d.view.width = s.request.cost.width, d.view.height = s.request.cost.height,
    d.view.time = s.request.cost.time + from.since;
    if (Status st = applySetting(d.project, s.tables, {s.technique->name, values}, d.view); !st) return st.error();
    return d;
}
Result<double> frameMs(Search& s, Drawing& d) {
    const auto start = std::chrono::steady_clock::now();
    if (Status st = s.renderer.draw(d.project, d.camera, d.view); !st) return st.error();
    s.renderer.finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}
// The median of some frames; of one alone, if that took longer than `most`.
Result<double> medianMs(Search& s, Drawing& d, double most) {
    if (auto warm = frameMs(s, d); !warm) return warm;
    std::vector<double> ms;
    double sum = 0;
    for (int i = 0; i < kFrames && (i < kLeastFrames || sum < kTimedMs); ++i) {
        auto took = frameMs(s, d);
        if (!took) return took;
        ms.push_back(*took), sum += *took;
        if (i == 0 && *took > most) break;
    }
    return quantileOf(ms, 0.5);
}
Result<Picture> pictureOf(Search& s, const std::vector<std::string>& values, const CostView& view) {
    auto d = drawingOf(s, values, view);
    if (!d) return d.error();
    if (auto ms = frameMs(s, *d); !ms) return ms.error();
    return pictureOfLinear(d->view.width, d->view.height, s.renderer.readLinear());
}
Result<double> errorOf(const Picture& picture, const CostTruth& truth) {
    auto pair = pairPictures(picture, truth.picture, truth.grass);
    if (!pair) return pair.error();
    return appearance(*pair).distance;
}
// Time and error from one camera, added to the candidate's; the error unless it is far too slow.
Status measureFrom(Search& s, const Seen& v, FitCandidate& c, double most) {
    auto d = drawingOf(s, c.values, v.view);
    if (!d) return d.error();
    auto ms = medianMs(s, *d, most);
    if (!ms) return ms.error();
    c.ms = std::max(c.ms, *ms);
    if (*ms > most) return {};
    auto error = errorOf(pictureOfLinear(d->view.width, d->view.height, s.renderer.readLinear()), v.truth);
    if (!error) return error.error();
    c.appearance += *error / static_cast<double>(s.views.size());
    return {};
}
// Each candidate once; asked again it is remembered. One that takes far more than the budget from a camera has no
// error.
Result<FitCandidate> measured(Search& s, const std::vector<std::string>& values, bool whole = false) {
    if (const auto it = s.seen.find(values); it != s.seen.end()) return it->second;
    const double most = whole ? std::numeric_limits<double>::infinity() : kHopeless * s.request.budgetMs;
    FitCandidate c{values, 0, 0};
    for (const Seen& v : s.views) {
        if (Status st = measureFrom(s, v, c, most); !st) return st.error();
        if (c.ms <= most) continue;
        c.appearance = std::numeric_limits<double>::infinity();
        break;
    }
    return s.seen[values] = c;
}

// --- the search --------------------------------------------------------------------------------------------------
bool better(const FitCandidate& a, const FitCandidate& b, double budget) {
    const bool fitsA = a.ms <= budget, fitsB = b.ms <= budget;
    if (fitsA != fitsB) return fitsA;
    return fitsA ? a.appearance < b.appearance : a.ms < b.ms;
}
Knobs asItIs(const TechniqueRow& t) {
    Knobs k;
    for (const KnobRow& row : t.knobs) k.push_back(row.start);
    return k;
}
std::vector<std::string> valuesOf(const Search& s, const Knobs& k) {
    std::vector<std::pair<std::string, SettingValues>> each;
    for (const auto& [name, field] : fieldsOf(s.project)) each.push_back({name, s.technique->turned(field, k)});
    return mergedValues(each);
}
// The neighbours: each knob the step's factor up and down, then those that are added to.
std::vector<Knobs> around(const Search& s, const Knobs& k, double step) {
    std::vector<Knobs> out;
    for (const bool factors : {true, false})
        for (size_t i = 0; i < k.size(); ++i) {
            const KnobRow& row = s.technique->knobs[i];
            if (row.factor != factors) continue;
            const double turned[] = {row.factor ? k[i] * step : k[i] - std::log2(step),
                                     row.factor ? k[i] / step : k[i] + std::log2(step)};
            for (const double value : turned) {
                if (value < row.least || value > row.most) continue;
                out.push_back(k);
                out.back()[i] = value;
            }
        }
    return out;
}
// From a start: to the best neighbour as long as one is better, then with smaller steps.
Status search(Search& s, Knobs at) {
    auto here = measured(s, valuesOf(s, at));
    if (!here) return here.error();
    for (double step = kStep; step >= kLeastStep && static_cast<int>(s.seen.size()) < s.limit;) {
        std::optional<Knobs> next;
        for (const Knobs& k : around(s, at, step)) {
            if (static_cast<int>(s.seen.size()) >= s.limit) break;
            auto there = measured(s, valuesOf(s, k));
            if (!there) return there.error();
            if (better(*there, *here, s.request.budgetMs)) here = there, next = k;
        }
        if (next)
            at = *next;
        else
            step = std::sqrt(step);
    }
    return {};
}

// --- the grid ----------------------------------------------------------------------------------------------------
// All points with each of the knobs that stand in it at three values, the first knob's changing last.
std::vector<Knobs> gridPoints(const TechniqueRow& t) {
    std::vector<Knobs> points{asItIs(t)};
    for (size_t i = 0; i < t.knobs.size(); ++i) {
        if (!t.knobs[i].inGrid) continue;
        std::vector<Knobs> more;
        for (const Knobs& at : points)
            for (const double step : {-1.0, 0.0, 1.0}) {
                more.push_back(at);
                more.back()[i] = t.knobs[i].factor ? at[i] * std::exp2(step) : at[i] + step;
            }
        points = std::move(more);
    }
    return points;
}
Result<FitCandidate> gridBest(Search& s) {
    FitCandidate best;
    for (const Knobs& k : gridPoints(*s.technique)) {
        auto c = measured(s, valuesOf(s, k));
        if (!c) return c;
        if (c->ms <= s.request.budgetMs && better(*c, best, s.request.budgetMs)) best = *c;
    }
    return best;
}

// --- cameras that were not seen ----------------------------------------------------------------------------------
Result<FitHeldOut> heldOut(Search& s, const FitResult& found) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    FitHeldOut out{0, 0, std::isfinite(found.gridBest.appearance) ? 0 : none,
                   std::isfinite(found.gridBest.appearance) ? "" : "no point of the grid fits the budget"};
    int taken = 0;
    for (const CostView& seen : s.request.cost.views) {
        const CostView view{seen.name + ", moved", heldOutCamera(seen.camera), seen.since};
        auto truth = costTruthAlone(s.request.cost, s.project, s.tables, view, s.progress);
        if (!truth && truth.error().code == ExitCode::Interrupted) return truth.error();
        if (!truth) {
            out.note += (out.note.empty() ? "" : "; ") + view.name + " was left out: " + truth.error().message;
            continue;
        }
        ++taken;
        const std::pair<double*, const FitCandidate*> all[] = {
            {&out.shipped, &found.shipped}, {&out.fitted, &found.best}, {&out.grid, &found.gridBest}};
        for (const auto& [sum, candidate] : all) {
            if (candidate->values.empty()) continue;
            auto picture = pictureOf(s, candidate->values, view);
            if (!picture) return picture.error();
            auto error = errorOf(*picture, *truth);
            if (!error) return error.error();
            *sum += *error;
        }
    }
    for (double* sum : {&out.shipped, &out.fitted, &out.grid}) *sum = taken > 0 ? *sum / taken : none;
    return out;
}

// --- all of it ---------------------------------------------------------------------------------------------------
Status traceTruths(Search& s) {
    for (const CostView& view : s.request.cost.views) {
        auto truth = costTruthAlone(s.request.cost, s.project, s.tables, view, s.progress);
        if (!truth) return truth.error();
        s.views.push_back({view, std::move(*truth)});
    }
    return {};
}
// The best of all that were measured, and the cheapest of those that are better still.
void choose(const Search& s, FitResult& r) {
    for (const auto& [values, c] : s.seen)
        if (r.best.values.empty() || better(c, r.best, s.request.budgetMs)) r.best = c;
    r.fits = r.best.ms <= s.request.budgetMs;
    for (const auto& [values, c] : s.seen)
        if (r.fits && c.ms > s.request.budgetMs && c.appearance < r.best.appearance &&
            (r.given.values.empty() || c.ms < r.given.ms))
            r.given = c;
    r.tried = static_cast<int>(s.seen.size());
}

}  // namespace

ViewCamera heldOutCamera(ViewCamera c) {
    const glm::dvec3 ahead = c.target - c.eye;
    const glm::dvec2 flat(ahead.x, ahead.z);
    const double length = std::max(glm::length(flat), 1e-3), angle = glm::radians(20.0);
    c.eye += glm::dvec3(-ahead.z, 0, ahead.x) / length * (0.125 * glm::length(ahead));
    c.target = c.eye + glm::dvec3(ahead.x * std::cos(angle) - ahead.z * std::sin(angle), ahead.y,
                                  ahead.x * std::sin(angle) + ahead.z * std::cos(angle));
    return c;
}

Result<const TechniqueRow*> techniqueToFit(const Project& project, const Tables& tables) {
    const auto fields = fieldsOf(project);
    if (fields.empty()) return unsound("the project has no grass", "add a GrassField").at(project.dir);
    const TechniqueRow* own = findTechnique(tables.techniques, fields.front().second.grows.technique);
    if (own && !own->knobs.empty()) return own;
    for (const TechniqueRow& row : tables.techniques)
        if (!row.knobs.empty()) return &row;
    return failed("no technique has anything to turn");
}

Result<FitResult> runFit(const FitRequest& request, const Project& project, const Tables& tables, Gpu& gpu,
                         const CostProgress& progress) {
    std::error_code ec;
    std::filesystem::create_directories(request.cost.folder, ec);
    if (ec) return failed("cannot make the folder: " + ec.message(), "choose another").at(request.cost.folder);
    Search s{request, project, tables, gpu, progress};
    s.limit = request.candidates;
    auto technique = techniqueToFit(project, tables);
    if (!technique) return technique.error();
    s.technique = *technique;
    if (Status st = traceTruths(s); !st) return st.error();
    FitResult r;
    auto shipped = measured(s, valuesOf(s, asItIs(*s.technique)), true);
    if (!shipped) return shipped.error();
    if (Status st = search(s, asItIs(*s.technique)); !st) return st.error();
    auto grid = gridBest(s);
    if (!grid) return grid.error();
    choose(s, r);
    r.technique = s.technique->name, r.shipped = *shipped, r.gridBest = *grid;
    if (r.fits) {
        auto held = heldOut(s, r);
        if (!held) return held.error();
        r.heldOut = *held;
    }
    return r;
}

}  // namespace sward
