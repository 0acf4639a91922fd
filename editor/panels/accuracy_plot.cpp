#include "panels/accuracy_plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "accuracy/accuracy.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

ImU32 opaque(uint32_t rgb) { return IM_COL32(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255, 255); }
// A technique's colour; white for rows of one that the table lacks.
ImU32 colorOf(std::span<const TechniqueRow> techniques, const std::string& name) {
    const std::optional<uint32_t> rgb = techniqueRgb(techniques, name);
    return rgb ? opaque(*rgb) : ui::kStrongLine;
}

// A logarithmic axis: values to pixels.
struct Axis {
    double low = 1, high = 10;  // decades' logarithms, base 10
    float from = 0, to = 1;
    void take(double v) {
        if (!(v > 0) || !std::isfinite(v)) return;
        low = std::min(low, std::log10(v)), high = std::max(high, std::log10(v));
    }
    float at(double v) const {
        return from + (to - from) * static_cast<float>((std::log10(std::max(v, 1e-9)) - low) / (high - low));
    }
};
Axis emptyAxis() { return {1e9, -1e9}; }
void pad(Axis& a) {
    if (a.high < a.low) a.low = 0, a.high = 1;
    const double more = 0.06 * (a.high - a.low) + 0.03;
    a.low -= more, a.high += more;
}

struct PlotLayout {
    Axis x = emptyAxis(), y = emptyAxis();
    ImVec2 low, high;  // of its inside, window coordinates
};

bool isDrawn(const CostRow& r) { return r.skipped.empty() && r.msMedian > 0 && r.metrics.appearance.distance > 0; }

constexpr const char* kTitle = "appearance error";
constexpr float kLegendGap = 12;

// Lines of names above the plot, right-aligned, each as full as it may be.
std::vector<std::vector<const TechniqueRow*>> legendLines(std::span<const TechniqueRow> techniques, float room) {
    std::vector<std::vector<const TechniqueRow*>> lines{{}};
    float taken = 0;
    for (const TechniqueRow& row : techniques) {
        const float width = ImGui::CalcTextSize(row.name).x + kLegendGap;
        if (taken > 0 && taken + width > room) lines.emplace_back(), taken = 0;
        lines.back().push_back(&row);
        taken += width;
    }
    return lines;
}

PlotLayout layOut(const CostRun& run, const CostFloors& f, std::span<const TechniqueRow> techniques, ImVec2 at,
                  ImVec2 size) {
    PlotLayout p;
    for (const CostRow& r : run.rows)
        if (isDrawn(r)) p.x.take(r.msMedian), p.y.take(r.metrics.appearance.distance);
    for (const double v : {f.seed.distance, f.sampling.distance, f.flat.distance}) p.y.take(v);
    pad(p.x), pad(p.y);
    const float em = ImGui::GetFontSize();
    const float room = size.x - em * 3.6f - ImGui::CalcTextSize(kTitle).x;
    const float lines = static_cast<float>(legendLines(techniques, room).size());
    p.low = {at.x + em * 3.2f, at.y + em * 1.3f * lines},
    p.high = {at.x + size.x - em * 0.4f, at.y + size.y - em * 1.4f};
    p.x.from = p.low.x, p.x.to = p.high.x, p.y.from = p.high.y, p.y.to = p.low.y;
    return p;
}

// 1, 2 and 5 of each decade.
template <class Draw>
void ticks(const Axis& a, const Draw& draw) {
    for (int decade = static_cast<int>(std::floor(a.low)); decade <= a.high; ++decade)
        for (const double m : {1.0, 2.0, 5.0})
            if (const double v = m * std::pow(10, decade); std::log10(v) >= a.low && std::log10(v) <= a.high) draw(v);
}

void axes(const PlotLayout& p) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 line = ui::kFaintLine;
    const float em = ImGui::GetFontSize();
    float right = -1e9f;  // of the last label, so that none covers another
    ticks(p.x, [&](double v) {
        const std::string text = fmt::format("{:g}", v);
        const float x = p.x.at(v), half = ImGui::CalcTextSize(text.c_str()).x / 2;
        list.AddLine({x, p.low.y}, {x, p.high.y}, line);
        if (x - half < right + 6 || x + half > p.high.x - em * 2) return;
        list.AddText({x - half, p.high.y + 1}, ui::kDimText, text.c_str());
        right = x + half;
    });
    list.AddText({p.high.x - em * 1.6f, p.high.y + 1}, ui::kDimText, "ms");
    float above = 1e9f;
    ticks(p.y, [&](double v) {
        const std::string text = fmt::format("{:g}", v);
        const float y = p.y.at(v);
        list.AddLine({p.low.x, y}, {p.high.x, y}, line);
        if (y + em / 2 > above) return;
        list.AddText({p.low.x - 5 - ImGui::CalcTextSize(text.c_str()).x, y - em / 2}, ui::kDimText, text.c_str());
        above = y - em / 2;
    });
    list.AddText({p.low.x - em * 3.1f, p.low.y - em * 1.3f}, ui::kDimText, kTitle);
    list.AddRect(p.low, p.high, ui::kLine);
}

void level(const PlotLayout& p, double v, const char* label, float& taken) {
    if (!(v > 0)) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = p.y.at(v);
    for (float x = p.low.x; x < p.high.x; x += 8) list.AddLine({x, y}, {std::min(x + 4, p.high.x), y}, ui::kLine);
    const ImVec2 size = ImGui::CalcTextSize(label);
    const float at = p.high.x - size.x - 6 - taken;
    if (at > p.low.x) list.AddText({at, y - size.y - 1 < p.low.y ? y + 1 : y - size.y - 1}, ui::kDimText, label);
    taken += size.x + 14;  // side by side: lines may lie close
}

void frontier(const PlotLayout& p, const CostRun& run) {
    std::vector<const CostRow*> rows;
    for (const CostRow& r : run.rows)
        if (isDrawn(r) && r.onFrontier) rows.push_back(&r);
    std::sort(rows.begin(), rows.end(), [](const CostRow* a, const CostRow* b) { return a->msMedian < b->msMedian; });
    for (size_t i = 1; i < rows.size(); ++i)
        ImGui::GetWindowDrawList()->AddLine(
            {p.x.at(rows[i - 1]->msMedian), p.y.at(rows[i - 1]->metrics.appearance.distance)},
            {p.x.at(rows[i]->msMedian), p.y.at(rows[i]->metrics.appearance.distance)}, ui::kLine, 1.5f);
}

void legend(const PlotLayout& p, std::span<const TechniqueRow> techniques) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize(), room = p.high.x - p.low.x - ImGui::CalcTextSize(kTitle).x;
    const auto lines = legendLines(techniques, room);
    float y = p.low.y - em * 1.3f * static_cast<float>(lines.size());
    for (const auto& line : lines) {
        float x = p.high.x;
        for (const TechniqueRow* row : line) {
            x -= ImGui::CalcTextSize(row->name).x;
            list.AddText({x, y}, opaque(row->color), row->name);
            x -= kLegendGap;
        }
        y += em * 1.3f;
    }
}

// Beside a point, within the plot.
void mark(const PlotLayout& p, const ImVec2& at, const char* text) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircle(at, 8, ui::kStrongLine, 0, 2);
    const float width = ImGui::CalcTextSize(text).x;
    const float x = at.x + 10 + width > p.high.x ? at.x - 10 - width : at.x + 10;
    list.AddText({x, at.y - ImGui::GetFontSize() / 2}, ui::kStrongLine, text);
}

ImVec2 pointAt(const PlotLayout& p, const CostRow& r) {
    return {p.x.at(r.msMedian), p.y.at(r.metrics.appearance.distance)};
}

// The row nearest the pointer, if it is on one.
const CostRow* rowUnder(const PlotLayout& p, const CostRun& run) {
    const CostRow* best = nullptr;
    float nearest = 8;
    const ImVec2 m = ImGui::GetIO().MousePos;
    for (const CostRow& r : run.rows) {
        if (!isDrawn(r)) continue;
        const ImVec2 at = pointAt(p, r);
        if (const float d = std::hypot(at.x - m.x, at.y - m.y); d < nearest) nearest = d, best = &r;
    }
    return best;
}

void recordPoint(const ImVec2& at, const CostRow& r) {
    const std::string name = fmt::format("Accuracy/Point {} {}", r.technique, r.settings);
    if (ui::takeReveal(name)) ImGui::SetScrollHereY(1);
    ui::Widget w;
    w.visible = ImGui::IsRectVisible({at.x - 1, at.y - 1}, {at.x + 1, at.y + 1});
    w.kind = ui::Kind::Area;
    w.x0 = at.x - 3, w.x1 = at.x + 3, w.y0 = at.y - 3, w.y1 = at.y + 3;
    w.value = fmt::format("{:.4f}", r.metrics.appearance.distance);
    ui::recordAt(name, w);
}

// One standard error each way, of the appearance and of the median time.
void bars(const PlotLayout& p, const CostRow& r, ImU32 color) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = pointAt(p, r);
    const double error = r.metrics.appearance.distance, sigma = r.metrics.appearance.sigma;
    const auto y = [&](double v) { return std::clamp(p.y.at(v), p.low.y, p.high.y); };
    const auto x = [&](double v) { return std::clamp(p.x.at(v), p.low.x, p.high.x); };
    if (sigma > 0) list.AddLine({at.x, y(error + sigma)}, {at.x, y(std::max(error - sigma, error / 100))}, color);
    if (r.msSigma > 0)
        list.AddLine({x(r.msMedian - std::min(r.msSigma, 0.99 * r.msMedian)), at.y}, {x(r.msMedian + r.msSigma), at.y},
                     color);
}

void points(const PlotLayout& p, const CostRun& run, const CostRow* hovered, const Document& doc, bool isMeasured,
            const std::optional<ViewportPoint>& viewport) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    bool marked = false;
    for (const CostRow& r : run.rows) {
        if (!isDrawn(r)) continue;
        const ImVec2 at = pointAt(p, r);
        bars(p, r, colorOf(doc.tables().techniques, r.technique));
        list.AddCircleFilled(at,
                             &r == hovered  ? 5.5f
                             : r.onFrontier ? 4.0f
                                            : 3.0f,
                             colorOf(doc.tables().techniques, r.technique));
        recordPoint(at, r);
        const bool present = r.settings == kAsItIs ? isMeasured : isPresent(doc, settingOf(r.technique, r.settings));
        if (marked || !present) continue;
        marked = true;
        mark(p, at, "now");
    }
    if (marked || !viewport) return;
    const ImVec2 at{std::clamp(p.x.at(viewport->ms), p.low.x, p.high.x),
                    std::clamp(p.y.at(viewport->error), p.low.y, p.high.y)};
    mark(p, at, "viewport");
}

void emptyPlot(const ImVec2& at, const ImVec2& size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRect(at, {at.x + size.x, at.y + size.y}, ui::kFaintLine);
    const char* text = "time and error of every technique, once measured";
    const ImVec2 t = ImGui::CalcTextSize(text);
    if (t.x < size.x) list.AddText({at.x + (size.x - t.x) / 2, at.y + (size.y - t.y) / 2}, ui::kDimText, text);
}

}  // namespace

std::optional<CostSetting> drawCostPlot(const std::optional<CostRun>& measured, const Document& document,
                                        bool isMeasured, const std::optional<ViewportPoint>& viewport) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const float left =
        ImGui::GetWindowHeight() - ImGui::GetCursorPosY() - 4;  // whatever part of the panel is scrolled to
    const ImVec2 size{std::max(room.x, 80.0f), std::max(left, ImGui::GetFontSize() * 10)};
    const bool pressed = ImGui::InvisibleButton("plot", size);
    ui::record("Plot", ui::Kind::Area);
    const bool over = ImGui::IsItemHovered();
    if (!measured || measured->floors.empty()) return emptyPlot(at, size), std::nullopt;
    const CostRun& run = *measured;
    const CostFloors& floors = run.floors.front();
    const PlotLayout p = layOut(run, floors, document.tables().techniques, at, size);
    axes(p);
    float taken = 0;
    level(p, floors.flat.distance, "flat colour", taken);
    level(p, floors.sampling.distance, "sampling noise", taken);
    level(p, floors.seed.distance, "other blades", taken);
    frontier(p, run);
    legend(p, document.tables().techniques);
    const CostRow* hovered = over ? rowUnder(p, run) : nullptr;
    points(p, run, hovered, document, isMeasured, viewport);
    if (!hovered) {
        if (over)
            ui::tooltip(fmt::format(
                "Seen from {} at {}x{}: time across, appearance error upwards; low and left is good. The "
                "line: nothing is surely quicker or truer without being worse in the other; bars are standard errors.\n"
                "flat colour: worse is worthless.  sampling noise: what few samples alone make.  other "
                "blades: as good as true.",
                floors.camera, run.width, run.height));
        return {};
    }
    ImGui::SetTooltip(
        "%s", fmt::format("{}\n{}\n{:.3g} ms, appearance error {:.4f} \xC2\xB1 {:.4f}{}{}", hovered->technique,
                          hovered->settings, hovered->msMedian, hovered->metrics.appearance.distance,
                          hovered->metrics.appearance.sigma, hovered->onFrontier ? "\nNothing surely beats it." : "",
                          hovered->settings == kAsItIs ? "" : "\nClick to adopt.")
                  .c_str());
    return pressed && hovered->settings != kAsItIs ? std::optional(settingOf(hovered->technique, hovered->settings))
                                                   : std::nullopt;
}

}  // namespace sward
