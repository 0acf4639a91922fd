#include "cost/cost_times.h"

#include <numbers>

#include "core/file.h"
#include "core/json.h"

namespace sward {

int roundsFor(double ms, int rounds) {
    if (!(ms > 0)) return rounds;
    const double fit = 1 + kTimedSeconds * 1000 / (2 * ms);
    return std::min(rounds, std::max(kLeastRounds, static_cast<int>(std::min(fit, 1e6))));
}

double quantileOf(std::vector<double> values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<size_t>(share * static_cast<double>(values.size())))];
}

void takeTimes(CostRow& row, std::vector<double> ms) {
    row.msMedian = quantileOf(ms, 0.5), row.msP95 = quantileOf(ms, 0.95);
    row.msSigma = std::numeric_limits<double>::quiet_NaN();
    row.ms = std::move(ms);
    if (row.ms.size() < 2) return;
    const double n = static_cast<double>(row.ms.size());
    double mean = 0, squares = 0;
    for (const double v : row.ms) mean += v / n;
    for (const double v : row.ms) squares += (v - mean) * (v - mean);
    row.msSigma =
        std::sqrt(std::numbers::pi / 2 * squares / (n - 1) / n);  // pi / 2: a median's variance against a mean's
}

CostTimes keptTimes(const std::filesystem::path& file, size_t rows) {
    CostTimes t{file, std::vector<std::vector<double>>(rows)};
    const auto read = readJson(file);
    if (!read || !read->isArray() || read->array.size() != rows) return t;
    for (size_t i = 0; i < rows; ++i)
        for (const Json& v : read->array[i].array) t.ms[i].push_back(v.number);
    return t;
}

Status keepTimes(const CostTimes& t) {
    Json all = Json::makeArray();
    for (const auto& row : t.ms) {
        Json one = Json::makeArray();
        for (const double v : row) one.push(v);
        all.push(std::move(one));
    }
    return writeFileAtomic(t.file, writeJson(all));
}

}  // namespace sward
