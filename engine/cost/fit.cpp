// Index: candidates · measuring one · the search · the grid · cameras that were not seen · all of it.
#include "cost/fit.h"
#include "cost/cost_times.h"

#include <chrono>
#include <map>

#include "core/json.h"
#include "cost/cost_truth.h"
#include "cost/fit_technique.h"
#include "cost/frame_stats.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr int kFrames = 5, kLeastFrames = 3;  // of a timing's median, after one that is not counted
constexpr double kTimedMs = 1500;             // more than the least number only within this time
constexpr double kHopeless =
    1.5;                     // times the budget: a candidate slower than that from one camera is not drawn from others
constexpr double kSure = 4;  // times the most that a candidate must be expected to take to be left out unseen
constexpr double kMsPerBlade = 1e-5;                    // where the shipped settings draw few blades
constexpr double kSearchShare = 0.6, kGridShare = 0.8;  // of the seconds: when they begin nothing further
constexpr double kTruthShare = 0.15;                    // for truths; then fewer samples are traced
constexpr int kLeastSamples = 2;                        // of a truth: one alone has no error
constexpr double kStep = 2, kLeastStep = 1.1892;        // factors: a doubling, and its fourth root

// --- candidates --------------------------------------------------------------------------------------------------
// How far each of the technique's knobs is turned (KnobRow), in the order of its rows.
using Knobs = std::vector<double>;

struct Seen {
    const CostView& view;
    CostTruth truth;
};
struct FitSearch {
    const FitRequest& request;
    const Project& project;
    const Tables& tables;
    Gpu& gpu;
    const CostProgress& progress;
    Renderer renderer{gpu, tables};
    std::vector<Seen> views = {};
    std::map<std::pair<std::string, std::vector<std::string>>, FitCandidate> seen = {};
    std::vector<FitCandidate> found = {};  // of those, the search's own
    double msPerBlade = kMsPerBlade;
    std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
    CostRequest cost = request.cost;       // with as many samples of truths as there is time for
    FitCandidate shipped = {}, best = {};  // of those found
    bool cutShort = false;

    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(); }
    // Notes that time was over, too.
    bool inTime(double share) {
        const bool is = seconds() < share * request.seconds;
        cutShort |= !is;
        return is;
    }
    bool mayGoOn() {
        return static_cast<int>(found.size()) < request.candidates && (found.empty() || inTime(kSearchShare));
    }
};
Error fitStopped() { return interruption("interrupted; nothing was changed"); }

// --- measuring one -----------------------------------------------------------------------------------------------
struct Drawing {
    Project project;
    ViewCamera camera;
    ViewSettings view;
};
Result<Drawing> drawingOf(FitSearch& s, const CostSetting& setting, const CostView& from) {
    if (!s.progress(fmt::format("{} of at most {} candidates, {} settings in all", s.found.size(), s.request.candidates,
                                s.seen.size()),
                    std::max(static_cast<double>(s.found.size()) / std::max(1, s.request.candidates),
                             std::min(s.seconds() / s.request.seconds, 1.0))))
        return fitStopped();
    Drawing d{snapshot(s.project, s.tables.components), from.camera, {}};
    d.view.width = s.request.cost.width, d.view.height = s.request.cost.height,
    d.view.time = s.request.cost.time + from.since, d.view.counted = true;
    if (Status st = applySetting(d.project, s.tables, setting, d.view); !st) return st.error();
    return d;
}
Result<double> frameMs(FitSearch& s, Drawing& d) {
    const auto start = std::chrono::steady_clock::now();
    if (Status st = s.renderer.draw(d.project, d.camera, d.view); !st) return st.error();
    s.renderer.finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}
// The median of some frames; of one alone, if that took longer than `most`.
Result<double> medianMs(FitSearch& s, Drawing& d, double most) {
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
Result<Picture> pictureOf(FitSearch& s, const CostSetting& setting, const CostView& view) {
    auto d = drawingOf(s, setting, view);
    if (!d) return d.error();
    if (Status st = drawSettled(s.renderer, d->project, d->camera, d->view); !st) return st.error();
    return pictureOfLinear(d->view.width, d->view.height, s.renderer.readLinear());
}
Result<Appearance> errorOf(const Picture& picture, const CostTruth& truth) {
    auto pair = pairPictures(picture, truth.picture, truth.grass);
    if (!pair) return pair.error();
    return appearance(*pair);
}
// Sums over cameras that become a mean and its standard error.
struct Scores {
    double sum = 0, variance = 0;
    int taken = 0;
    void add(const Appearance& a) {
        sum += a.distance, variance += std::isfinite(a.sigma) ? a.sigma * a.sigma : 0;
        ++taken;
    }
    FitScore mean() const { return taken > 0 ? FitScore{sum / taken, std::sqrt(variance) / taken} : FitScore{}; }
};
// Milliseconds that its blades alone would take.
double expectedMs(const FitSearch& s, const Drawing& d) {
    return s.msPerBlade * static_cast<double>(d.view.detail) *
           static_cast<double>(submittedBlades(d.project, s.tables, d.camera, d.view.width, d.view.height));
}
// Time and error from one camera, added to the candidate's; the error unless it is far too slow.
Status measureFrom(FitSearch& s, const Seen& v, FitCandidate& c, Scores& scores, double most) {
    auto d = drawingOf(s, c.setting, v.view);
    if (!d) return d.error();
    if (const double expected = expectedMs(s, *d); expected > kSure * most) {
        c.ms = std::max(c.ms, expected);
        return {};
    }
    auto ms = medianMs(s, *d, most);
    if (!ms) return ms.error();
    c.ms = std::max(c.ms, *ms);
    if (*ms > most) return {};
    auto error = errorOf(pictureOfLinear(d->view.width, d->view.height, s.renderer.readLinear()), v.truth);
    if (!error) return error.error();
    scores.add(*error);
    return {};
}
// Each setting once; asked again it is remembered. One that takes far more than the budget from a camera has no error.
Result<FitCandidate> measured(FitSearch& s, const CostSetting& setting, bool whole = false) {
    const auto key = std::pair(setting.technique, setting.values);
    if (const auto it = s.seen.find(key); it != s.seen.end()) return it->second;
    const double most = whole ? std::numeric_limits<double>::infinity() : kHopeless * s.request.budgetMs;
    FitCandidate c{setting, 0};
    Scores scores;
    for (const Seen& v : s.views) {
        if (Status st = measureFrom(s, v, c, scores, most); !st) return st.error();
        if (c.ms > most) break;
    }
    if (c.ms <= most) c.appearance = scores.mean().appearance, c.sigma = scores.mean().sigma;
    return s.seen[key] = c;
}

// --- the search --------------------------------------------------------------------------------------------------
bool better(const FitCandidate& a, const FitCandidate& b, double budget) {
    const bool fitsA = a.ms <= budget, fitsB = b.ms <= budget;
    if (fitsA != fitsB) return fitsA;
    return fitsA ? a.appearance < b.appearance : a.ms < b.ms;
}
// As the field has it; or with the factors that may be halved.
Knobs knobsOf(const FitTechnique& t, bool halved) {
    Knobs k;
    for (const KnobRow& row : t.knobs())
        k.push_back(halved && row.factor ? std::max(row.start / kStep, row.least) : row.start);
    return k;
}
FitResult soFar(const FitSearch& s) {
    FitResult r;
    r.fits = s.best.ms <= s.request.budgetMs;
    r.fitted = s.best, r.shipped = s.shipped;
    r.tried = static_cast<int>(s.seen.size());
    r.cutShort = true;
    return r;
}
// Measured as one of the search's own.
Result<FitCandidate> searched(FitSearch& s, const FitTechnique& t, const Knobs& k) {
    const CostSetting setting = turnedSetting(s.project, t, k);
    const bool isNew = std::none_of(s.found.begin(), s.found.end(), [&](const FitCandidate& c) {
        return c.setting.technique == setting.technique && c.setting.values == setting.values;
    });
    auto c = measured(s, setting);
    if (!c || !isNew) return c;
    s.found.push_back(*c);
    if (s.best.known() && !better(*c, s.best, s.request.budgetMs)) return c;
    s.best = *c;
    if (s.request.betterFound && c->ms <= s.request.budgetMs) s.request.betterFound(soFar(s));
    return c;
}
// The neighbours: each knob the step's factor up and down, then those that are added to.
std::vector<Knobs> around(const FitTechnique& t, const Knobs& k, double step) {
    std::vector<Knobs> out;
    for (const bool factors : {true, false})
        for (size_t i = 0; i < k.size(); ++i) {
            const KnobRow& row = t.knobs()[i];
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
Status searchFrom(FitSearch& s, const FitTechnique& t, Knobs at, FitCandidate here) {
    for (double step = kStep; step >= kLeastStep && s.mayGoOn();) {
        std::optional<Knobs> next;
        for (const Knobs& k : around(t, at, step)) {
            if (!s.mayGoOn()) break;
            auto there = searched(s, t, k);
            if (!there) return there.error();
            if (better(*there, here, s.request.budgetMs)) here = *there, next = k;
        }
        if (next)
            at = *next;
        else
            step = std::sqrt(step);
    }
    return {};
}
// Every technique once, the field's own first; then from the best of them, from the next best and so on.
Status search(FitSearch& s, const std::vector<FitTechnique>& techniques) {
    struct Start {
        const FitTechnique* technique;
        FitCandidate candidate;
    };
    std::vector<Start> starts;
    for (const FitTechnique& t : techniques) {
        if (!s.mayGoOn()) break;
        auto c = searched(s, t, knobsOf(t, true));
        if (!c) return c.error();
        starts.push_back({&t, *c});
    }
    std::stable_sort(starts.begin(), starts.end(), [&](const Start& a, const Start& b) {
        return better(a.candidate, b.candidate, s.request.budgetMs);
    });
    for (const Start& start : starts)
        if (s.mayGoOn())
            if (Status st = searchFrom(s, *start.technique, knobsOf(*start.technique, true), start.candidate); !st)
                return st;
    return {};
}

// --- the grid ----------------------------------------------------------------------------------------------------
// All points with each of the knobs that stand in it at three values, the first knob's changing last.
std::vector<Knobs> gridPoints(const FitTechnique& t) {
    std::vector<Knobs> points{knobsOf(t, false)};
    for (size_t i = 0; i < t.knobs().size(); ++i) {
        if (!t.knobs()[i].inGrid) continue;
        std::vector<Knobs> more;
        for (const Knobs& at : points)
            for (const double step : {-1.0, 0.0, 1.0}) {
                more.push_back(at);
                more.back()[i] = t.knobs()[i].factor ? at[i] * std::exp2(step) : at[i] + step;
            }
        points = std::move(more);
    }
    return points;
}
Result<FitCandidate> gridBest(FitSearch& s, const FitTechnique& own) {
    FitCandidate best;
    for (const Knobs& k : gridPoints(own)) {
        if (!s.inTime(kGridShare)) break;
        auto c = measured(s, turnedSetting(s.project, own, k));
        if (!c) return c;
        if (c->ms <= s.request.budgetMs && better(*c, best, s.request.budgetMs)) best = *c;
    }
    return best;
}

// --- truths
// Of all samples asked for; where that takes longer than its share of the time, begun anew with as many as it allows.
Result<CostTruth> truthInTime(FitSearch& s, const CostView& view) {
    const double begun = s.seconds(),
                 limit = kTruthShare * s.request.seconds / static_cast<double>(s.cost.views.size());
    double share = 0;
    bool late = false;
    const auto watched = [&](const std::string& what, double done) {
        share = done;
        late = s.cost.truth.samples > kLeastSamples && s.seconds() - begun > limit;
        return s.progress(what, done) && !late;
    };
    auto truth = costTruthAlone(s.cost, s.project, s.tables, view, watched);
    if (truth || !late) return truth;
    s.cutShort = true;
    s.cost.truth.samples = std::max(kLeastSamples, static_cast<int>(0.8 * share * s.cost.truth.samples));
    return costTruthAlone(s.cost, s.project, s.tables, view, s.progress);
}
Status traceTruths(FitSearch& s) {
    for (const CostView& view : s.request.cost.views) {
        auto truth = truthInTime(s, view);
        if (!truth) return truth.error();
        s.views.push_back({view, std::move(*truth)});
    }
    return {};
}

// --- cameras that were not seen ----------------------------------------------------------------------------------
Result<FitHeldOut> heldOut(FitSearch& s, const FitResult& found) {
    FitHeldOut out;
    if (!found.gridBest.known()) out.note = "no point of the grid fits the budget";
    Scores scores[3];
    const FitCandidate* candidates[] = {&found.shipped, &found.fitted, &found.gridBest};
    for (const CostView& seen : s.request.cost.views) {
        const CostView view{seen.name + ", moved", heldOutCamera(seen.camera), seen.since};
        if (!s.inTime(1)) {
            out.note += (out.note.empty() ? "" : "; ") + std::string("no time was left for ") + view.name;
            continue;
        }
        auto truth = truthInTime(s, view);
        if (!truth && truth.error().code == ExitCode::Interrupted) return truth.error();
        if (!truth) {
            out.note += (out.note.empty() ? "" : "; ") + view.name + " was left out: " + truth.error().message;
            continue;
        }
        for (size_t i = 0; i < 3; ++i) {
            if (!candidates[i]->known()) continue;
            auto picture = pictureOf(s, candidates[i]->setting, view);
            if (!picture) return picture.error();
            auto error = errorOf(*picture, *truth);
            if (!error) return error.error();
            scores[i].add(*error);
        }
    }
    out.shipped = scores[0].mean(), out.fitted = scores[1].mean(), out.grid = scores[2].mean();
    return out;
}

// --- all of it ---------------------------------------------------------------------------------------------------
// The best that the search found, and the cheapest of all measured that are better still.
void choose(const FitSearch& s, FitResult& r) {
    r.fitted = s.best;
    r.fits = r.fitted.ms <= s.request.budgetMs;
    for (const auto& [key, c] : s.seen)
        if (r.fits && c.ms > s.request.budgetMs && c.appearance < r.fitted.appearance &&
            (!r.given.known() || c.ms < r.given.ms))
            r.given = c;
    r.tried = static_cast<int>(s.seen.size());
}
// By what the cameras of the search say, and by the others.
void judge(const FitSearch& s, FitResult& r) {
    const auto scoreOf = [](const FitCandidate& c, bool takesPart) {
        return takesPart && std::isfinite(c.appearance) ? FitScore{c.appearance, c.sigma} : FitScore{};
    };
    const bool shippedFits = r.shipped.ms <= s.request.budgetMs;
    r.seen = verdictOf(scoreOf(r.fitted, true), scoreOf(r.shipped, shippedFits), scoreOf(r.gridBest, true));
    r.unseen = verdictOf(r.heldOut.fitted, shippedFits ? r.heldOut.shipped : FitScore{}, r.heldOut.grid);
}

}  // namespace

FitVerdict verdictOf(const FitScore& fitted, const FitScore& shipped, const FitScore& grid) {
    FitVerdict v;
    FitScore rival;
    for (const auto& [name, score] : {std::pair{"shipped", &shipped}, std::pair{"grid", &grid}})
        if (std::isfinite(score->appearance) && !(rival.appearance <= score->appearance))
            rival = *score, v.rival = name;
    if (v.rival.empty() || !std::isfinite(fitted.appearance)) return v;
    const double behind = fitted.appearance - rival.appearance, doubt = std::hypot(fitted.sigma, rival.sigma);
    v.outcome = std::abs(behind) <= doubt ? FitOutcome::Even : behind < 0 ? FitOutcome::Wins : FitOutcome::Loses;
    return v;
}

const FitCandidate& chosen(const FitResult& r) {
    if (r.unseen.outcome != FitOutcome::Loses) return r.fitted;
    return r.unseen.rival == "grid" ? r.gridBest : r.shipped;
}

ViewCamera heldOutCamera(ViewCamera c) {
    const glm::dvec3 ahead = c.target - c.eye;
    const glm::dvec2 flat(ahead.x, ahead.z);
    const double length = std::max(glm::length(flat), 1e-3), angle = glm::radians(20.0);
    c.eye += glm::dvec3(-ahead.z, 0, ahead.x) / length * (0.125 * glm::length(ahead));
    c.target = c.eye + glm::dvec3(ahead.x * std::cos(angle) - ahead.z * std::sin(angle), ahead.y,
                                  ahead.x * std::sin(angle) + ahead.z * std::cos(angle));
    return c;
}

Result<FitResult> runFit(const FitRequest& request, const Project& project, const Tables& tables, Gpu& gpu,
                         const CostProgress& progress) {
    std::error_code ec;
    std::filesystem::create_directories(request.cost.folder, ec);
    if (ec) return failed("cannot make the folder: " + ec.message(), "choose another").at(request.cost.folder);
    FitSearch s{.request = request, .project = project, .tables = tables, .gpu = gpu, .progress = progress};
    const auto techniques = techniquesToFit(project, tables, request.technique);
    if (!techniques) return techniques.error();
    if (Status st = traceTruths(s); !st) return st.error();
    FitResult r;
    auto shipped = measured(s, {}, true);
    if (!shipped) return shipped.error();
    // What forests cost does not go by blades.
    if (techniques->front().forest) s.msPerBlade = 0;
    if (const uint64_t blades = s.renderer.stats().bladesGeometry; s.msPerBlade > 0 && blades > 1000)
        s.msPerBlade = shipped->ms / static_cast<double>(blades);
    s.shipped = *shipped;
    if (Status st = search(s, *techniques); !st) return st.error();
    auto grid = gridBest(s, techniques->front());
    if (!grid) return grid.error();
    choose(s, r);
    r.shipped = *shipped, r.gridBest = *grid;
    r.cutShort = s.cutShort, r.truthSamples = s.cost.truth.samples;
    if (!r.fits) return r;
    auto held = heldOut(s, r);
    if (!held) return held.error();
    r.heldOut = *held;
    judge(s, r);
    return r;
}

}  // namespace sward
