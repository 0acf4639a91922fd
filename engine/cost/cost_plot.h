// Time against appearance for one camera of a sweep: a colour a technique, the frontier, and the floors that scores are
// held against. Both axes are logarithmic. Does not: write files.
#pragma once
#include "cost/cost.h"
#include "cost/plot.h"

namespace sward {

// Empty (width 0) if no row of the camera was drawn and timed.
Plot costPlot(const CostRun& run, const std::string& camera, int width = 900, int height = 600);
// The technique's colour, "#rrggbb": told apart by people who do not see red and green alike (Okabe and Ito 2008).
std::string techniqueColor(const std::string& technique);

}  // namespace sward
