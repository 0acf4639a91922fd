// What a sweep's rows are to each other: which draw the same picture, and which nothing beats (cost.h).
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "cost/cost.h"

namespace sward {

bool beats(const CostRow& a, const CostRow& b) {
    const Appearance &ea = a.metrics.appearance, &eb = b.metrics.appearance;
    const auto doubt = [](double sa, double sb) {
        return std::hypot(std::isfinite(sa) ? sa : 0, std::isfinite(sb) ? sb : 0);
    };
    const double time = b.msMedian - a.msMedian, error = eb.distance - ea.distance;
    const double timeDoubt = doubt(a.msSigma, b.msSigma), errorDoubt = doubt(ea.sigma, eb.sigma);
    return time >= -timeDoubt && error >= -errorDoubt && (time > timeDoubt || error > errorDoubt);
}

void markFrontier(std::vector<CostRow>& rows) {
    const auto isDrawn = [](const CostRow& r) { return r.skipped.empty() && std::isfinite(r.msMedian); };
    for (CostRow& row : rows)
        row.onFrontier = isDrawn(row) && std::none_of(rows.begin(), rows.end(), [&](const CostRow& other) {
                             return isDrawn(other) && other.camera == row.camera && other.machine == row.machine &&
                                    beats(other, row);
                         });
}

std::vector<size_t> distinctRows(const std::vector<CostRow>& rows) {
    std::set<std::tuple<std::string, std::string, std::string>> seen;
    std::vector<size_t> kept;
    for (size_t i = 0; i < rows.size(); ++i)
        if (rows[i].pixels.empty() || seen.insert({rows[i].camera, rows[i].technique, rows[i].pixels}).second)
            kept.push_back(i);
    return kept;
}

void keepDistinct(CostRun& run) {
    std::vector<CostRow> kept;
    for (const size_t i : distinctRows(run.rows)) {
        kept.push_back(std::move(run.rows[i]));
        kept.back().index = static_cast<int>(kept.size()) - 1;
    }
    run.rows = std::move(kept);
    run.total = static_cast<int>(run.rows.size());
}

}  // namespace sward
