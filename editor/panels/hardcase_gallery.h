// The tab Hard Cases: each numerical hard case as a live graph, the printed form beside ours, and its formula's text.
// Does not: judge or compute (app/hardcase_run.h).
#pragma once
#include "app/edits.h"
#include "app/hardcase_run.h"

namespace sward {

// In what is left of the present window; below 36 letters' width the list of cases is a combo. What is chosen is shown
// from the next frame on.
void drawHardCases(HardCaseRun& run, Edits& edits);

}  // namespace sward
