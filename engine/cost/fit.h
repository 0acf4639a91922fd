// The settings with the least appearance error within a budget of time, over a project's cameras, or moments of a path.
// Search: every technique that has knobs (fit_technique.h), of grass or of forests, is drawn once with each factor at
// half of the field's own, so that the settings that ship are no head start; then a pattern search (Hooke and Jeeves
// 1961) over the knobs of the best of them, such as where blades and slices end, how sharp slices are, how they are
// filtered, and samples a pixel; where it finds nothing better and may go on, from the next best. Each step is the
// double or the half, then less; no model of cost is assumed, times are measured. A candidate fits if its slowest
// camera's median is within the budget; of those that fit, the least mean appearance wins. One that takes half as much
// again from a camera, or surely would by the number of its blades, is not drawn from the others. Beside it stand the
// settings that ship and a grid (each of three knobs of the field's technique at three values on a log scale), measured
// by the same rule; they are none of the search's, which may lose against either. All three are drawn from cameras that
// none of them was chosen by, and what differs there by less than its standard error is even. Does not: save the
// project (the caller does). The order of candidates is the same each time but for what times decide.
#pragma once
#include <functional>
#include <limits>

#include "cost/cost.h"
#include "world/view_camera.h"

namespace sward {

struct FitCandidate {
    CostSetting setting;                                  // without values: as the project ships
    double ms = std::numeric_limits<double>::infinity();  // of the slowest camera, median
    double appearance =
        std::numeric_limits<double>::infinity();  // mean over cameras; infinite: far too slow, not taken
    double sigma = 0;                             // standard error of the appearance
    bool known() const { return std::isfinite(ms); }
};
// A mean appearance over cameras; not-a-number: not taken.
struct FitScore {
    double appearance = std::numeric_limits<double>::quiet_NaN(), sigma = 0;
};
// What became of the search against the better of its rivals: the grid, and the shipped settings if they fit.
enum class FitOutcome { Wins, Even, Loses };
inline constexpr auto kFitOutcomes = enumNames<FitOutcome>("wins", "even", "loses");
struct FitVerdict {
    FitOutcome outcome = FitOutcome::Wins;
    std::string rival;  // "shipped" or "grid"; empty: nothing else fits
};
struct FitHeldOut {
    FitScore shipped, fitted, grid;
    std::string note;  // why a number is missing
};
struct FitResult {
    bool fits = false;
    FitCandidate fitted;  // the best of the search that fits; else the quickest that it saw
    FitCandidate shipped;
    FitCandidate gridBest;  // of the grid's that fit; ms infinite: none does
    FitCandidate given;     // the next better than `fitted` that does not fit, if that does; ms infinite: none was seen
    FitHeldOut heldOut;
    FitVerdict seen, unseen;  // on the cameras of the search, and on the held-out ones (of those if any was taken)
    int tried = 0;            // settings measured in all
    bool cutShort = false;    // the time was over before the search or the grid was, or truths have fewer samples
    int truthSamples = 0;     // a pixel, of the truths that it was measured by
};
// The settings to be had from it: the search's, unless it loses on cameras that were not seen.
const FitCandidate& chosen(const FitResult& result);
// The score of the search against what else fits; rivals that are not-a-number do not take part.
FitVerdict verdictOf(const FitScore& fitted, const FitScore& shipped, const FitScore& grid);

struct FitRequest {
    double budgetMs = 0;  // above 0
    int candidates = 40;  // that the search may measure, at least one
    // Seconds for all of it, truths that are not kept yet included: a truth that takes longer than its part of 0.15 of
    // them is begun anew with fewer samples, two at least; the search begins no further candidate after 0.6 of
    // them, the grid none after 0.8, and after all of them no further held-out camera is traced. What was begun is
    // ended, and the first candidate and the shipped settings are always measured.
    double seconds = std::numeric_limits<double>::infinity();
    // One technique alone, or kEveryForestTechnique for those of forests; empty: of the project's grass, or of its
    // forests if it has none. What is not turned is drawn as it is.
    std::string technique = {};
    std::function<void(const FitResult&)> betterFound = {};  // each time that one fits and is better than all before
    CostRequest cost;  // views, size, truth, folder for truths; settings and shards are not read
};
// Searches among at most `request.candidates` settings of the project's fields, or of its forests. Truths are traced
// first and kept in cost.folder. Failed: the folder cannot be made. Errors as techniquesToFit. Interrupted: `progress`
// said so.
Result<FitResult> runFit(const FitRequest& request, const Project& project, const Tables& tables, Gpu& gpu,
                         const CostProgress& progress);

// The camera moved aside by an eighth of its distance to the target and turned by 20 degrees about its eye.
ViewCamera heldOutCamera(ViewCamera camera);

}  // namespace sward
