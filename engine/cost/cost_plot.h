// Time against appearance for one camera of a sweep: a colour a technique, bars of a standard error each way, the
// frontier, a ring around the project as it ships, and the floors that scores are held against. Both axes are
// logarithmic. Does not: write files.
#pragma once
#include "cost/cost.h"
#include "cost/plot.h"

namespace sward {

// Empty (width 0) if no row of the camera was drawn and timed.
Plot costPlot(const CostRun& run, const std::string& camera, std::span<const TechniqueRow> techniques, int width = 900,
              int height = 600);

}  // namespace sward
