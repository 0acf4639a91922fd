// What the verbs cost and fit share: their options as a request to measure, and their line of progress.
#pragma once
#include "cli/cli.h"
#include "cost/cost.h"

namespace sward {

// Without settings and folder. Usage error: sizes, samples, rounds, limits or shards out of range, no such camera or
// path; Unsound: no camera.
Result<CostRequest> costRequest(const CostOptions& options, const Project& project);
// A line on standard error that is written over, where a person looks. Stops once Ctrl+C was pressed.
CostProgress costProgress();

}  // namespace sward
