#include "app/hardcase_run.h"

#include <cmath>
#include <utility>

#include "app/frame_clock.h"
#include "formulas/case_source.h"

namespace sward {
namespace {

void begin(HardCaseRun& run) {
    run.cases = hardCases();
    auto values = loadExpectedValues(expectedValuesFile());
    if (values)
        run.values = std::move(*values);
    else
        run.error = values.error().text();
}

// No number is worse than any.
double badness(const CasePoint& p) {
    const double error = p.published.empty() ? p.oursError : p.publishedError;
    return std::isfinite(error) ? error : HUGE_VAL;
}

void sweepShown(HardCaseRun& run) {
    const HardCase& h = run.cases[run.shown];
    run.pointsOf = run.shown;
    run.points = isSwept(h) ? sweepCase(h) : std::vector<CasePoint>{};
    run.here = {};
    for (const CasePoint& p : run.points)
        if (run.here.ours.empty() || badness(p) > badness(run.here)) run.here = p;
    const auto text = caseText(h.curve);
    run.source = text ? *text : text.error().text();
}

}  // namespace

void followHardCases(HardCaseRun& run, Gpu* gpu, FrameClock& clock) {
    if (!std::exchange(run.looked, false)) return;
    if (run.cases.empty()) begin(run);
    if (run.pointsOf != run.shown) sweepShown(run), clock.wanted = 4;
    if (!judging(run)) return;
    run.results.push_back(runHardCase(run.cases[run.results.size()].row, run.values, gpu));
    clock.wanted = 4;
}

void showCase(HardCaseRun& run, size_t index) {
    if (index < run.cases.size()) run.shown = index;
}

void moveCase(HardCaseRun& run, double at) {
    if (run.pointsOf == run.shown && !run.points.empty()) run.here = caseAt(run.cases[run.shown], at);
}

bool judging(const HardCaseRun& run) { return run.error.empty() && run.results.size() < run.cases.size(); }

}  // namespace sward
