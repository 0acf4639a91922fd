// How often a sweep's rows are timed, what their times are, and where they are kept.
// Rows are timed in rounds, one frame of each in turn. A quick row takes part in all rounds; a slow one in fewer, so that none takes
// more than about kTimedSeconds; how much its median is worth then follows from its own frames (msSigma).
// Does not: draw.
#pragma once
#include <filesystem>
#include <vector>

#include "core/error.h"
#include "measure/cost.h"

namespace sward {

inline constexpr double kTimedSeconds = 2;  // a row, with the frame before each that is not counted
inline constexpr int kLeastRounds = 3;      // of every row, if as many are asked for

// Rounds in which a row takes part whose first frame took `ms`.
int roundsFor(double ms, int rounds);
// Sets msMedian, msP95, msSigma and msFrames from a row's frames.
void takeTimes(CostRow& row, const std::vector<double>& ms);

// One list of milliseconds for each row, written after each whole round.
struct CostTimes {
    std::filesystem::path file;
    std::vector<std::vector<double>> ms;
};
// What the file holds; without one, or one of another number of rows, nothing of each.
CostTimes keptTimes(const std::filesystem::path& file, size_t rows);
Status keepTimes(const CostTimes& times);

}  // namespace sward
