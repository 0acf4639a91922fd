#include "formulas/case_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

namespace sward {
namespace {

constexpr double kSmall = 11;     // of the labels, pixels
constexpr double kLetter = 6.2;   // about the width of one
constexpr double kExact = 1e-12;  // an error below is none: far less than float has

// From a value to pixels from below.
struct Height {
    double low = 0, high = 1;
    bool log = false;
    const PlotBox* box = nullptr;
    double at(double v) const {
        const double from = log ? std::log10(low) : low, to = log ? std::log10(high) : high;
        const double share = ((log ? std::log10(std::max(v, low)) : v) - from) / (to - from);
        return box->bottom + (box->top - box->bottom) * std::clamp(share, 0.0, 1.0);
    }
};

double across(const HardCase& h, const PlotBox& b, double at) {
    return b.left + (b.right - b.left) * shareOn(h.curve, at);
}

double shown(const HardCase& h, const std::vector<double>& outputs) {
    return outputs.empty() ? std::nan("") : outputs[static_cast<size_t>(h.curve.output)];
}

// Decades from the smallest to the largest error; both ends hold them all.
Height errorHeight(std::span<const CasePoint> points, const PlotBox& box, double tolerance) {
    Height y{1e300, 0, true, &box};
    const auto take = [&](double v) {
        if (std::isfinite(v) && v > kExact) y.low = std::min(y.low, v), y.high = std::max(y.high, v);
    };
    for (const CasePoint& p : points) {
        take(p.oursError);
        if (!p.published.empty()) take(p.publishedError);
    }
    take(tolerance);
    if (y.high <= 0) y.low = 1e-8, y.high = 1;
    y.low = std::pow(10, std::floor(std::log10(y.low) - 0.3));
    y.high = std::max(std::pow(10, std::ceil(std::log10(y.high))), 10 * y.low);
    return y;
}

// All of what is wanted, and as much of the printed form as that again on each side.
Height valueHeight(const HardCase& h, std::span<const CasePoint> points, const PlotBox& box) {
    double low = 1e300, high = -1e300;
    const auto take = [&](double v, double least, double most) {
        if (!std::isfinite(v)) return;
        low = std::min(low, std::max(v, least)), high = std::max(high, std::min(v, most));
    };
    for (const CasePoint& p : points)
        for (const double v : {shown(h, p.truth), shown(h, p.ours)}) take(v, -1e300, 1e300);
    if (low > high) low = 0, high = 1;
    const double room = std::max(high - low, std::max(std::abs(high), 1e-12) * (high > low ? 0 : 1));
    const double least = low - room, most = high + room;
    for (const CasePoint& p : points) take(shown(h, p.published), least, most);
    const double edge = 0.06 * std::max(high - low, 1e-12 + 1e-6 * std::abs(high));
    return {low - edge, high + edge, false, &box};
}

// Whole decades, so many apart that about `wanted` remain.
std::vector<double> logTicks(double low, double high, int wanted) {
    std::vector<double> out;
    const int from = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
    const int to = static_cast<int>(std::floor(std::log10(high) + 1e-9));
    const int step = std::max(1, (to - from + wanted) / wanted);
    for (int e = from; e <= to; e += step) out.push_back(std::pow(10, e));
    return out;
}

void axes(Plot& plot, const HardCase& h, const Height& y, const PlotBox& b, const CaseColors& c) {
    const int columns = std::max(2, static_cast<int>((b.right - b.left) / 70));
    const int rows = std::max(2, static_cast<int>((b.bottom - b.top) / 28));
    std::vector<double> ticks = h.curve.scale == CaseScale::Log ? logTicks(h.curve.low, h.curve.high, columns)
                                                                : evenTicks(h.curve.low, h.curve.high, columns);
    if (h.curve.zero) ticks.insert(ticks.begin(), 0);
    double taken = -1e9;  // how far to the right labels reach
    for (const double v : ticks) {
        const double x = across(h, b, v), half = 0.5 * kLetter * static_cast<double>(caseNumber(v).size());
        plot.lines.push_back({{{x, b.top}, {x, b.bottom}}, c.faint});
        if (x - half < taken) continue;
        taken = x + half + kLetter;
        plot.texts.push_back({{x, b.bottom + kSmall + 3}, caseNumber(v), c.dim, kSmall, PlotAnchor::Middle});
    }
    for (const double v : y.log ? logTicks(y.low, y.high, rows) : evenTicks(y.low, y.high, rows)) {
        plot.lines.push_back({{{b.left, y.at(v)}, {b.right, y.at(v)}}, c.faint});
        plot.texts.push_back({{b.left - 5, y.at(v) + 4}, caseNumber(v), c.dim, kSmall, PlotAnchor::End});
    }
    plot.lines.push_back({{{b.left, b.top}, {b.left, b.bottom}, {b.right, b.bottom}}, c.dim});
    const std::string unit = h.curve.unit.empty() ? "" : ", " + h.curve.unit;
    plot.texts.push_back({{(b.left + b.right) / 2, b.bottom + 2 * kSmall + 8},
                          h.curve.variable + unit,
                          c.ink,
                          kSmall + 1,
                          PlotAnchor::Middle});
}

// The line of one form; where it is no number the line breaks and the upper edge is marked.
void form(Plot& plot, const HardCase& h, std::span<const CasePoint> points, const Height& y, const PlotBox& b,
          const std::string& color, double width, const std::function<double(const CasePoint&)>& value) {
    PlotLine line{{}, color, width};
    const auto end = [&] {
        if (line.points.size() > 1) plot.lines.push_back(line);
        if (line.points.size() == 1) plot.dots.push_back({line.points[0], width, color, true, ""});
        line.points.clear();
    };
    for (const CasePoint& p : points) {
        const double v = value(p), x = across(h, b, p.at);
        if (std::isfinite(v)) {
            line.points.push_back({x, y.at(v)});
            if (h.curve.zero && p.at == 0) end();  // it stands apart from the axis
            continue;
        }
        end();
        plot.dots.push_back({{x, b.top + 3}, 2.5, color, true, fmt::format("{}: no number", caseNumber(p.at))});
    }
    end();
}

void legend(Plot& plot, const HardCase& h, CaseGraph graph, const PlotBox& b, const CaseColors& c) {
    const std::string what = graph == CaseGraph::Values ? h.curve.value : "error";
    plot.texts.push_back({{b.left, b.top - 6}, what, c.ink, kSmall + 1});
    std::vector<std::pair<std::string, std::string>> names;
    if (graph == CaseGraph::Values) names.emplace_back("wanted", c.truth);
    if (h.row.published) names.emplace_back("as printed", c.published);
    names.emplace_back("ours", c.ours);
    double width = 0;
    for (const auto& [text, color] : names) width += 10 + kLetter * static_cast<double>(text.size());
    double x = b.right - width;
    if (x < b.left + 1.2 * kLetter * static_cast<double>(what.size())) return;  // the other graph has it
    for (const auto& [text, color] : names) {
        plot.texts.push_back({{x, b.top - 6}, text, color, kSmall});
        x += 10 + kLetter * static_cast<double>(text.size());
    }
}

// Words in lines of at most so many letters.
std::vector<std::string> wrapped(const std::string& text, size_t letters) {
    std::vector<std::string> lines{""};
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (lines.back().size() + word.size() + 1 > letters) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    return lines;
}

// For machines: all digits that count, and one name for what is no number.
std::string field(double v, int digits) {
    if (std::isnan(v)) return "nan";
    return fmt::format("{:.{}g}", v, digits);
}

}  // namespace

std::string caseNumber(double v) {
    if (std::isnan(v)) return "NaN";
    if (std::isinf(v)) return v > 0 ? "inf" : "-inf";
    return fmt::format("{:.4g}", std::abs(v) < 1e-300 ? 0.0 : v);
}

void addCaseGraph(Plot& plot, const HardCase& h, std::span<const CasePoint> points, CaseGraph graph, const PlotBox& b,
                  const CaseColors& c, double marked) {
    const bool values = graph == CaseGraph::Values;
    const Height y = values ? valueHeight(h, points, b) : errorHeight(points, b, h.row.tolerance);
    axes(plot, h, y, b, c);
    legend(plot, h, graph, b, c);
    if (!values && h.row.tolerance > 0)
        plot.lines.push_back({{{b.left, y.at(h.row.tolerance)}, {b.right, y.at(h.row.tolerance)}}, c.dim, 1, 5});
    if (values) form(plot, h, points, y, b, c.truth, 4, [&](const CasePoint& p) { return shown(h, p.truth); });
    if (h.row.published)
        form(plot, h, points, y, b, c.published, 1.5,
             [&](const CasePoint& p) { return values ? shown(h, p.published) : p.publishedError; });
    form(plot, h, points, y, b, c.ours, 1.5,
         [&](const CasePoint& p) { return values ? shown(h, p.ours) : p.oursError; });
    if (std::isnan(marked)) return;
    const double x = across(h, b, marked);
    plot.lines.push_back({{{x, b.top}, {x, b.bottom}}, c.ink, 1, 3});
}

Plot casePlot(const HardCase& h, int width, int height) {
    const CaseColors colors;
    Plot plot;
    plot.width = width, plot.height = height;
    plot.background = colors.back;
    plot.texts.push_back({{16, 24}, h.key + "  " + h.row.name, colors.ink, 15});
    plot.texts.push_back({{16, 44}, "shaders/numerics/" + h.curve.source + ", " + h.curve.function, colors.dim, 11});
    double top = 62;
    for (const std::string& line : wrapped(h.curve.picture, static_cast<size_t>(width / 6.4))) {
        plot.texts.push_back({{16, top}, line, colors.ink, 11});
        top += 15;
    }
    const std::vector<CasePoint> points = sweepCase(h);
    const double middle = top + (height - top) / 2.0, right = width - 20.0;
    addCaseGraph(plot, h, points, CaseGraph::Values, {72, top + 18, right, middle - 44}, colors, std::nan(""));
    addCaseGraph(plot, h, points, CaseGraph::Errors, {72, middle + 20, right, height - 44.0}, colors, std::nan(""));
    return plot;
}

std::string caseCsv(const HardCase& h, std::span<const CasePoint> points) {
    std::string out = "at,published,ours,wanted,published_error,ours_error\n";
    for (const CasePoint& p : points) {
        const bool has = !p.published.empty();
        out += fmt::format("{},{},{},{},{},{}\n", field(p.at, 9), has ? field(shown(h, p.published), 9) : "",
                           field(shown(h, p.ours), 9), field(shown(h, p.truth), 17),
                           has ? field(p.publishedError, 4) : "", field(p.oursError, 4));
    }
    return out;
}

}  // namespace sward
