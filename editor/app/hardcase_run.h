// Hard cases as the editor shows them: each row of the table judged on this machine, one a frame while somebody looks,
// and the one that is shown along its variable. Does not: draw (panels/hardcase_gallery.h).
#pragma once
#include <string>
#include <vector>

#include "formulas/case_curve.h"
#include "formulas/hardcases.h"

namespace sward {

struct FrameClock;
struct HardCaseRun {
    bool looked = false;          // somebody does: the panel sets it each frame
    std::vector<HardCase> cases;  // made once somebody looks
    ExpectedValues values;
    std::vector<HardCaseRow> results;  // of the first cases
    std::string error;                 // why none can be judged
    size_t shown = 0;                  // of the cases
    // Of the case that is shown; empty while it must be made anew, or cannot be swept.
    std::vector<CasePoint> points;
    size_t pointsOf = ~size_t(0);
    CasePoint here;  // where the slider stands
    bool sourceOpen = false;
    std::string source;  // the formula's text
};
// Once a frame, before its widgets: judges the next row, on the GPU too unless it is null, and makes what is shown.
void followHardCases(HardCaseRun& run, Gpu* gpu, FrameClock& clock);
// Another case, from the next frame on; its slider stands where the printed form is worst.
void showCase(HardCaseRun& run, size_t index);
// Moves the slider; within the variable's range.
void moveCase(HardCaseRun& run, double at);
// Rows are still being judged.
bool judging(const HardCaseRun& run);

}  // namespace sward
