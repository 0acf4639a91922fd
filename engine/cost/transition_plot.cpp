#include "cost/transition_plot.h"

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

constexpr double kSmall = 11;  // of the labels, pixels

double across(const Transitions& t, const PlotBox& b, double seconds) {
    return b.left + (b.right - b.left) * (seconds - t.seconds.front()) / (t.seconds.back() - t.seconds.front());
}

double topOf(const Transitions& t) {
    const double most = std::max(t.drawn.worst, t.floor.worst);
    return most > 0 ? 1.08 * most : 1;
}

double heightOf(double v, double top, const PlotBox& b) { return b.bottom + (b.top - b.bottom) * v / top; }

void axes(Plot& plot, const Transitions& t, const PlotBox& b, const TransitionColors& c) {
    const double top = topOf(t);
    const int columns = std::max(2, static_cast<int>((b.right - b.left) / 60));
    const int rows = std::max(2, static_cast<int>((b.bottom - b.top) / 28));
    for (const double v : evenTicks(0, top, rows)) {
        const double y = heightOf(v, top, b);
        plot.lines.push_back({{{b.left, y}, {b.right, y}}, c.faint});
        plot.texts.push_back({{b.left - 5, y + 4}, fmt::format("{:.3g}", v), c.dim, kSmall, PlotAnchor::End});
    }
    for (const double v : evenTicks(t.seconds.front(), t.seconds.back(), columns))
        plot.texts.push_back(
            {{across(t, b, v), b.bottom + kSmall + 3}, fmt::format("{:.4g}", v), c.dim, kSmall, PlotAnchor::Middle});
    plot.lines.push_back({{{b.left, b.top}, {b.left, b.bottom}, {b.right, b.bottom}}, c.dim});
    plot.texts.push_back({{(b.left + b.right) / 2, b.bottom + 2 * kSmall + 8},
                          "seconds along " + t.plan.path,
                          c.ink,
                          kSmall + 1,
                          PlotAnchor::Middle});
}

void bar(Plot& plot, const Transitions& t, size_t i, const PlotBox& b, const TransitionColors& c, bool marked) {
    const double left = across(t, b, t.seconds[i]), right = across(t, b, t.seconds[i + 1]);
    const double y = heightOf(t.drawn.steps[i], topOf(t), b), gap = right - left > 4 ? 0.5 : 0;
    const bool above = t.drawn.steps[i] > t.floor.steps[i];
    plot.bars.push_back({{left + gap, y}, {right - gap, b.bottom}, above ? c.above : c.below});
    if (marked)
        plot.lines.push_back(
            {{{left, b.bottom}, {left, b.top}, {right, b.top}, {right, b.bottom}, {left, b.bottom}}, c.ink, 1});
}

void floorLine(Plot& plot, const Transitions& t, const PlotBox& b, const TransitionColors& c) {
    PlotLine line{{}, c.floor, 1.5};
    for (size_t i = 0; i < t.floor.steps.size(); ++i)
        for (const double at : {t.seconds[i], t.seconds[i + 1]})
            line.points.push_back({across(t, b, at), heightOf(t.floor.steps[i], topOf(t), b)});
    plot.lines.push_back(std::move(line));
}

}  // namespace

void addTransitionGraph(Plot& plot, const Transitions& t, const PlotBox& b, const TransitionColors& c, int marked) {
    axes(plot, t, b, c);
    for (size_t i = 0; i < t.drawn.steps.size(); ++i) bar(plot, t, i, b, c, static_cast<int>(i) == marked);
    floorLine(plot, t, b, c);
}

int stepAt(const Transitions& t, const PlotBox& b, double x) {
    if (t.seconds.size() < 2 || !(x >= b.left && x <= b.right)) return -1;
    for (size_t i = 0; i + 1 < t.seconds.size(); ++i)
        if (x < across(t, b, t.seconds[i + 1])) return static_cast<int>(i);
    return static_cast<int>(t.seconds.size()) - 2;
}

Plot transitionPlot(const Transitions& t, int width, int height) {
    const TransitionColors colors;
    Plot plot;
    plot.width = width, plot.height = height;
    plot.background = colors.back;
    plot.texts.push_back({{16, 24}, "Popping along " + t.plan.path, colors.ink, 15});
    plot.texts.push_back(
        {{16, 42}, "line: other blades of the field; red: what pops more than they do", colors.dim, 11});
    addTransitionGraph(plot, t, {64, 56, width - 20.0, height - 44.0}, colors, -1);
    return plot;
}

}  // namespace sward
