#include "cost/cost_plot.h"

#include "core/json.h"

namespace sward {
namespace {

const std::string kInk = "#333333", kFaint = "#e4e4e4", kFloor = "#8a8a8a";
constexpr double kLeft = 76, kTop = 44, kRight = 20, kBottom = 56;

struct Axis {
    double low = 0, high = 0;  // values at its ends
    double from = 0, to = 0;   // pixels
    double at(double v) const {
        return from + (to - from) * (std::log(v) - std::log(low)) / (std::log(high) - std::log(low));
    }
};
Axis axisOf(std::vector<double> values, double from, double to) {
    std::erase_if(values, [](double v) { return !(v > 0) || !std::isfinite(v); });
    if (values.empty()) return {0.1, 1, from, to};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double room = std::max(1.15, std::pow(*high / *low, 0.06));
    return {*low / room, *high * room, from, to};
}
// 1, 1.5, 2, 3, 5, 7, 10 and so on within the axis; of a long one 1, 2, 5.
std::vector<double> ticks(const Axis& a) {
    std::vector<double> out;
    for (double decade = std::pow(10, std::floor(std::log10(a.low))); decade <= a.high; decade *= 10)
        for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0})
            if ((a.high < 30 * a.low || step == 1 || step == 2 || step == 5) && step * decade >= a.low &&
                step * decade <= a.high)
                out.push_back(step * decade);
    return out;
}

void drawAxes(Plot& p, const Axis& x, const Axis& y) {
    for (const double v : ticks(x)) {
        p.lines.push_back({{{x.at(v), y.from}, {x.at(v), y.to}}, kFaint});
        p.texts.push_back({{x.at(v), y.from + 18}, fmt::format("{:.4g}", v), kInk, 12, PlotAnchor::Middle});
    }
    for (const double v : ticks(y)) {
        p.lines.push_back({{{x.from, y.at(v)}, {x.to, y.at(v)}}, kFaint});
        p.texts.push_back({{x.from - 8, y.at(v) + 4}, fmt::format("{:.4g}", v), kInk, 12, PlotAnchor::End});
    }
    p.lines.push_back({{{x.from, y.to}, {x.from, y.from}, {x.to, y.from}}, kInk});
    p.texts.push_back(
        {{(x.from + x.to) / 2, y.from + 42}, "milliseconds a frame (median)", kInk, 13, PlotAnchor::Middle});
    p.texts.push_back(
        {{18, (y.from + y.to) / 2}, "appearance: distance from the truth", kInk, 13, PlotAnchor::Middle, true});
}

void drawFloors(Plot& p, const CostFloors& f, const Axis& x, const Axis& y) {
    const std::pair<double, const char*> lines[] = {{f.seed.distance, "other blades of the field"},
                                                    {f.sampling.distance, "the truth at 4 samples a pixel"},
                                                    {f.flat.distance, "flat rows"}};
    std::vector<double> taken;  // heights that have a label; one that lies close goes left of it
    for (const auto& [value, label] : lines) {
        if (!(value > 0)) continue;
        const auto close =
            std::count_if(taken.begin(), taken.end(), [&](double other) { return std::abs(other - y.at(value)) < 13; });
        taken.push_back(y.at(value));
        p.lines.push_back({{{x.from, y.at(value)}, {x.to, y.at(value)}}, kFloor, 1.2, 6});
        p.texts.push_back(
            {{x.to - 4 - 180 * static_cast<double>(close), y.at(value) - 5}, label, kFloor, 11, PlotAnchor::End});
    }
}

// One standard error each way, of the appearance and of the median time, with a short stroke at each end.
void drawBars(Plot& p, const CostRow& r, const Axis& x, const Axis& y, const std::string& color) {
    constexpr double kStroke = 3;
    const double error = r.metrics.appearance.distance, sigma = r.metrics.appearance.sigma;
    const glm::dvec2 at(x.at(r.msMedian), y.at(error));
    const auto bar = [&](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& across) {
        for (const auto& [from, to] :
             {std::pair(a, b), std::pair(a - across, a + across), std::pair(b - across, b + across)})
            p.lines.push_back({{from, to}, color, 0.8});
    };
    if (sigma > 0) bar({at.x, y.at(error + sigma)}, {at.x, y.at(std::max(error - sigma, y.low))}, {kStroke, 0});
    if (r.msSigma > 0)
        bar({x.at(r.msMedian + r.msSigma), at.y}, {x.at(std::max(r.msMedian - r.msSigma, x.low)), at.y}, {0, kStroke});
}

void drawRows(Plot& p, const std::vector<const CostRow*>& rows, const Axis& x, const Axis& y,
              std::span<const TechniqueRow> techniques) {
    std::vector<glm::dvec2> frontier;
    for (const CostRow* r : rows) {
        const Appearance& a = r->metrics.appearance;
        const glm::dvec2 at(x.at(r->msMedian), y.at(a.distance));
        const std::string color = techniqueColor(techniques, r->technique);
        drawBars(p, *r, x, y, color);
        p.dots.push_back({at, r->onFrontier ? 5.0 : 3.5, color, r->onFrontier,
                          fmt::format("{} {}: {:.1f} ms, {:.5f} +- {:.5f}", r->technique, r->settings, r->msMedian,
                                      a.distance, a.sigma)});
        if (r->onFrontier) frontier.push_back(at);
        if (r->settings != kAsItIs) continue;
        p.dots.push_back({at, 9, kInk, false, "as the project ships"});
        const bool left = at.x > (x.from + x.to) / 2;
        p.texts.push_back(
            {at + glm::dvec2(left ? -13 : 13, 4), kAsItIs, kInk, 12, left ? PlotAnchor::End : PlotAnchor::Start});
    }
    std::sort(frontier.begin(), frontier.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x; });
    p.lines.push_back({frontier, kInk, 1.6});
}

void drawLegend(Plot& p, const std::vector<const CostRow*>& rows, std::span<const TechniqueRow> techniques) {
    std::vector<std::string> names;
    for (const CostRow* r : rows)
        if (std::find(names.begin(), names.end(), r->technique) == names.end()) names.push_back(r->technique);
    double x = kLeft + 4;
    for (const std::string& n : names) {
        p.dots.push_back({{x, kTop - 12}, 5, techniqueColor(techniques, n), true, n});
        p.texts.push_back({{x + 10, kTop - 8}, n, kInk, 12});
        x += 36 + 8 * static_cast<double>(n.size());
    }
    p.texts.push_back({{p.width - kRight, kTop - 8},
                       "bars: standard errors; filled, joined: the frontier",
                       kInk,
                       12,
                       PlotAnchor::End});
}

}  // namespace

Plot costPlot(const CostRun& run, const std::string& camera, std::span<const TechniqueRow> techniques, int width,
              int height) {
    std::vector<const CostRow*> rows;
    std::vector<double> ms, errors;
    for (const CostRow& r : run.rows) {
        if (r.camera != camera || !r.skipped.empty() || !(r.msMedian > 0) || !(r.metrics.appearance.distance > 0))
            continue;
        rows.push_back(&r);
        ms.push_back(r.msMedian), errors.push_back(r.metrics.appearance.distance);
    }
    if (rows.empty()) return {};
    Plot p;
    p.width = width, p.height = height;
    const auto floors =
        std::find_if(run.floors.begin(), run.floors.end(), [&](const CostFloors& f) { return f.camera == camera; });
    if (floors != run.floors.end())
        errors.insert(errors.end(), {floors->seed.distance, floors->sampling.distance, floors->flat.distance});
    const Axis x = axisOf(ms, kLeft, width - kRight), y = axisOf(errors, height - kBottom, kTop);
    drawAxes(p, x, y);
    if (floors != run.floors.end()) drawFloors(p, *floors, x, y);
    drawRows(p, rows, x, y, techniques);
    drawLegend(p, rows, techniques);
    p.texts.push_back(
        {{kLeft - 60, 18}, fmt::format("{}, camera {}, {}x{}", run.project, camera, run.width, run.height), kInk, 14});
    return p;
}

}  // namespace sward
