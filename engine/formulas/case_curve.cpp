#include "formulas/case_curve.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "formulas/case_rows.h"

namespace sward {

std::vector<CaseCurve> caseCurves() {
    std::vector<CaseCurve> curves;
    addWeightCurves(curves);
    addFieldCurves(curves);
    addShapeCurves(curves);
    addForestCurves(curves);
    addRayCurves(curves);
    addBladeCurves(curves);
    addSceneCurves(curves);
    return curves;
}

namespace {

CaseCurve curveFor(const std::vector<CaseCurve>& curves, const FormulaRow& row) {
    const CaseCurve* found = nullptr;
    for (const CaseCurve& c : curves)
        if (c.id == row.id && (c.name == row.name || (c.name.empty() && !found))) found = &c;
    if (found) return *found;
    CaseCurve none;
    none.id = row.id;
    return none;
}

double unitOf(const CaseCurve& c, double want) {
    if (!c.relative) return c.measured;
    return want == 0 ? c.measured : std::abs(want) * c.measured;
}

double worstError(const HardCase& h, const std::vector<double>& got, const std::vector<double>& want) {
    FormulaSamples one;
    one.count = 1;
    one.want = want;
    for (const double w : want) one.scale.push_back(unitOf(h.curve, w));
    return largestError(h.row, one, got);
}

double settled(const CaseCurve& c, double at) {
    if (c.zero && at < c.low) return at < 0.5 * c.low ? 0 : c.low;
    const double inside = std::clamp(at, c.low, c.high);
    return c.whole ? std::round(inside) : inside;
}

}  // namespace

std::vector<HardCase> hardCases() {
    const std::vector<CaseCurve> curves = caseCurves();
    std::vector<HardCase> out;
    std::map<std::string, int> seen;
    for (FormulaRow& row : formulaRows()) {
        if (row.id.empty()) continue;
        const int nth = ++seen[row.id];
        const std::string key = nth == 1 ? row.id : row.id + "." + std::to_string(nth);
        CaseCurve curve = curveFor(curves, row);
        out.push_back({key, std::move(row), std::move(curve)});
    }
    return out;
}

bool isSwept(const HardCase& h) { return h.curve.inputs != nullptr; }

CasePoint caseAt(const HardCase& h, double at) {
    CasePoint p;
    p.at = settled(h.curve, at);
    FormulaSamples one;
    one.add(h.curve.inputs(p.at), {});
    p.ours = runSingle(h.row, h.row.ours, one);
    p.truth = h.curve.truth ? h.curve.truth(p.at) : runDouble(h.row, h.row.ours, one);
    p.oursError = worstError(h, p.ours, p.truth);
    if (!h.row.published) return p;
    p.published = runSingle(h.row, h.row.published, one);
    p.publishedError = worstError(h, p.published, p.truth);
    return p;
}

std::vector<CasePoint> sweepCase(const HardCase& h, int steps) {
    std::vector<double> at = h.curve.hard;
    if (h.curve.zero) at.push_back(0);
    const double from = h.curve.zero ? kZeroShare : 0;
    for (int i = 0; i < steps; ++i) at.push_back(valueAt(h.curve, from + (1 - from) * i / std::max(1, steps - 1)));
    for (double& v : at) v = settled(h.curve, v);
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    std::vector<CasePoint> points;
    for (const double v : at) points.push_back(caseAt(h, v));
    return points;
}

double shareOn(const CaseCurve& c, double at) {
    if (c.scale == CaseScale::Even) return std::clamp((at - c.low) / (c.high - c.low), 0.0, 1.0);
    const double from = c.zero ? kZeroShare : 0;
    if (c.zero && at < 0.5 * c.low) return 0;
    const double share = std::log(std::max(at, c.low) / c.low) / std::log(c.high / c.low);
    return std::min(from + (1 - from) * share, 1.0);
}

double valueAt(const CaseCurve& c, double share) {
    if (c.scale == CaseScale::Even) return c.low + (c.high - c.low) * std::clamp(share, 0.0, 1.0);
    const double from = c.zero ? kZeroShare : 0;
    if (c.zero && share < 0.5 * from) return 0;
    const double along = std::clamp((share - from) / (1 - from), 0.0, 1.0);
    return along >= 1 ? c.high : c.low * std::pow(c.high / c.low, along);
}

}  // namespace sward
