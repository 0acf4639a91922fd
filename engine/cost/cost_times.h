// How often a sweep's rows are timed, what their times are, and where they are kept.
// The frames that a row's pictures are made of are its first round; then one frame of each row in turn. A quick row
// takes part in all rounds; a slow one in fewer, so that more than the least number take no more than about
// kTimedSeconds; what its median is worth then follows from its own frames (msSigma). Does not: draw.
#pragma once
#include <filesystem>
#include <vector>

#include "core/error.h"
#include "cost/cost.h"

namespace sward {

inline constexpr double kTimedSeconds = 2;  // a row, with the frame before each that is not counted
inline constexpr int kLeastRounds = 2;      // of every row, if as many are asked for

// The value below which a share of the values lies (nearest rank); not-a-number of none.
double quantileOf(std::vector<double> values, double share);
// Rounds in which a row takes part whose first frame took `ms`.
int roundsFor(double ms, int rounds);
// Sets ms, and msMedian, msP95 and msSigma from it.
void takeTimes(CostRow& row, std::vector<double> ms);

// One list of milliseconds for each row, one number for each round after the first in which it took part; written after
// each round.
struct CostTimes {
    std::filesystem::path file;
    std::vector<std::vector<double>> ms;
};
// What the file holds; without one, or one of another number of rows, nothing of each.
CostTimes keptTimes(const std::filesystem::path& file, size_t rows);
Status keepTimes(const CostTimes& times);

}  // namespace sward
