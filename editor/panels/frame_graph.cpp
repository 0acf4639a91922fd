#include "panels/frame_graph.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

struct Graph {
    ImVec2 low, high;
    float top;  // ms at its upper edge
    float y(float ms) const { return high.y - (high.y - low.y) * std::min(ms / top, 1.0f); }
    float ms(float at) const { return top * (high.y - at) / (high.y - low.y); }
};

// So high that the budget and nearly all frames are below; a rare long one is cut.
float topOf(const FrameTimes& times, const FrameSummary& s) {
    return std::max(times.budgetMs * 2, std::min(s.slowest * 1.1f, s.median * 4));
}

void numbers(FrameTimes& times, const FrameSummary& s) {
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "Budget");
    ImGui::SameLine(0, 5);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 6);
    const ui::NumberSpec spec{.softMin = kLeastBudgetMs,
                              .softMax = 100,
                              .hardMin = static_cast<double>(kLeastBudgetMs),
                              .hardMax = static_cast<double>(kMostBudgetMs),
                              .unit = "ms"};
    ui::slider("Budget", times.budgetMs, spec);
    const std::string* error = ui::errorAt("Budget");
    ui::tooltip(error ? *error : "What a frame may take: the line of the graph. Drag it here or there, or type it.");
    const size_t kept = keptFrames(times);
    const auto line = [](const char* label, const std::string& text) {
        ImGui::SameLine(0, 14);
        if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(text.c_str()).x) ImGui::NewLine();
        ui::coloredText(ui::kDimText, text.c_str());
        ui::record(label, ui::Kind::Label, text);
    };
    line("Frames", fmt::format("{} frames, {} over budget", kept, s.over));
    line("Times", fmt::format("median {:.1f} ms, slowest {:.1f} ms, panels {:.2f} ms", s.median, s.slowest, s.panels));
}

void bars(const Graph& g, const FrameTimes& times) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const size_t kept = keptFrames(times);
    const float step = (g.high.x - g.low.x) / static_cast<float>(kFramesKept);
    for (size_t i = 0; i < kept; ++i) {
        const FrameTime f = frameAt(times, i);
        const float x = g.high.x - step * static_cast<float>(kept - i), right = x + std::max(step - 0.5f, 0.5f);
        const ImU32 color = f.all > times.budgetMs ? ui::kWarningText : ui::kFillHeld;
        list.AddRectFilled({x, g.y(f.all)}, {right, g.high.y}, color);
        list.AddRectFilled({x, g.y(f.panels)}, {right, g.high.y}, ui::kLine);
    }
}

// The line, and the hand on it.
void budget(const Graph& g, FrameTimes& times) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float y = g.y(times.budgetMs);
    const bool near = ImGui::IsItemHovered() && std::abs(mouse.y - y) < 5;
    if (ImGui::IsItemActivated()) times.dragging = std::abs(mouse.y - y) < 5;
    if (!ImGui::IsItemActive()) times.dragging = false;
    if (times.dragging && ImGui::IsMouseDragging(0, 1))
        times.budgetMs = std::clamp(std::round(g.ms(mouse.y) * 10) / 10, kLeastBudgetMs, kMostBudgetMs);
    if (near || times.dragging) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({g.low.x, y}, {g.high.x, y}, near || times.dragging ? ui::kStrongLine : ui::kErrorText, 1.5f);
    const std::string text = fmt::format("{:.3g} ms", times.budgetMs);
    list.AddText({g.low.x + 4, y - ImGui::GetFontSize() - 1}, ui::kDimText, text.c_str());
    ui::Widget w;
    w.kind = ui::Kind::Area;
    w.x0 = g.low.x, w.x1 = g.high.x, w.y0 = y - 3, w.y1 = y + 3, w.value = text;
    ui::recordAt("Profiler/Budget line", w);
}

}  // namespace

void drawFrameGraph(FrameTimes& times, float height) {
    const FrameSummary s = summaryOf(times);
    numbers(times, s);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = std::max(ImGui::GetContentRegionAvail().x, 40.0f);
    ImGui::InvisibleButton("graph", {width, height});
    ui::record("Graph", ui::Kind::Area, fmt::format("{}", keptFrames(times)));
    const Graph g{at, {at.x + width, at.y + height}, topOf(times, s)};
    ImGui::GetWindowDrawList()->AddRectFilled(g.low, g.high, ImGui::GetColorU32(ImGuiCol_FrameBg), 3);
    bars(g, times);
    budget(g, times);
}

}  // namespace sward
