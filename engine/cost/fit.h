// The settings with the least appearance error within a budget of time, over a project's cameras, or moments of a path.
// Search: a pattern search (Hooke and Jeeves 1961) over the knobs of the field's technique, such as where blades end,
// where slices end, how wide the fade between them is, and how sharp slices are. Each step is the double or the half,
// then less; no model of cost is assumed, times are measured. A candidate fits if its slowest camera's median is within
// the budget; of those that fit, the least mean appearance wins. One that takes half as much again from a camera is not
// drawn from the others. Beside it a grid (each of three knobs at three values on a log scale) and the shipped settings
// are measured by the same rule, and all three are drawn from cameras that the search did not see. Does not: save the
// project (the caller does). The order of candidates is the same each time but for what times decide.
#pragma once
#include "cost/cost.h"
#include "world/view_camera.h"

namespace sward {

struct FitCandidate {
    std::vector<std::string> values;                      // as "maxGeom=6": what the technique's knobs stand for
    double ms = std::numeric_limits<double>::infinity();  // of the slowest camera, median
    double appearance =
        std::numeric_limits<double>::infinity();  // mean over cameras; infinite: far too slow, not taken
};
struct FitHeldOut {
    double shipped = 0, fitted = 0, grid = 0;  // mean appearance over the held-out cameras; not-a-number: not taken
    std::string note;                          // why a number is missing
};
struct FitResult {
    std::string technique;  // whose knobs were turned
    bool fits = false;
    FitCandidate best;  // that fits; else the quickest that was seen
    FitCandidate shipped;
    FitCandidate gridBest;  // of the grid's that fit; appearance infinite: none does
    FitCandidate given;     // the next better that does not fit, if one fits; appearance infinite: none was seen
    FitHeldOut heldOut;
    int tried = 0;
};
struct FitRequest {
    double budgetMs = 0;  // above 0
    int candidates = 40;  // that the search may measure
    CostRequest cost;     // views, size, truth, folder for truths; settings and shards are not read
};
// The technique whose knobs a fit turns (TechniqueRow::knobs): that of the project's first field, or, where it has
// none, the first of the table that has some. Unsound: the project has no grass.
Result<const TechniqueRow*> techniqueToFit(const Project& project, const Tables& tables);
// Measures at most `request.candidates` settings of the project's fields and returns the best. Truths are traced first
// and kept in cost.folder. Failed: the folder cannot be made. Unsound: the project has no grass. Interrupted:
// `progress` said so.
Result<FitResult> runFit(const FitRequest& request, const Project& project, const Tables& tables, Gpu& gpu,
                         const CostProgress& progress);

// The camera moved aside by an eighth of its distance to the target and turned by 20 degrees about its eye.
ViewCamera heldOutCamera(ViewCamera camera);

}  // namespace sward
