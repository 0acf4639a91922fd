#include "ui/plot_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sward::ui {
namespace {

ImVec2 placed(const glm::dvec2& p, ImVec2 at) {
    return {at.x + static_cast<float>(p.x), at.y + static_cast<float>(p.y)};
}

void drawLine(ImDrawList& list, const PlotLine& l, ImVec2 at) {
    const ImU32 color = colorOf(l.color);
    const auto width = static_cast<float>(l.width);
    for (size_t i = 0; i + 1 < l.points.size(); ++i) {
        const glm::dvec2 a = l.points[i], b = l.points[i + 1];
        const double length = glm::distance(a, b), piece = l.dash > 0 ? l.dash : std::max(length, 1.0);
        for (double from = 0; from < length; from += 2 * piece)
            list.AddLine(placed(glm::mix(a, b, from / length), at),
                         placed(glm::mix(a, b, std::min(1.0, (from + piece) / length)), at), color, width);
    }
}

void drawText(ImDrawList& list, const PlotText& t, ImVec2 at) {
    ImFont* font = ImGui::GetFont();
    const auto size = static_cast<float>(t.size);
    const float width = font->CalcTextSizeA(size, 1e9f, 0, t.text.c_str()).x;
    ImVec2 from = placed(t.at, at);
    from.x -= t.anchor == PlotAnchor::Middle ? width / 2 : t.anchor == PlotAnchor::End ? width : 0;
    list.AddText(font, size, {std::round(from.x), std::round(from.y - 0.8f * size)}, colorOf(t.color), t.text.c_str());
}

}  // namespace

void drawPlot(const Plot& plot, ImVec2 at) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const PlotBar& b : plot.bars) list.AddRectFilled(placed(b.low, at), placed(b.high, at), colorOf(b.color));
    for (const PlotLine& l : plot.lines) drawLine(list, l, at);
    for (const PlotDot& d : plot.dots) {
        const auto radius = static_cast<float>(d.radius);
        if (d.filled)
            list.AddCircleFilled(placed(d.at, at), radius, colorOf(d.color));
        else
            list.AddCircle(placed(d.at, at), radius, colorOf(d.color), 0, 1.5f);
    }
    for (const PlotText& t : plot.texts) drawText(list, t, at);
}

std::string hexOf(ImU32 color) {
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(color), back = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
    const auto part = [&](float top, float below) {
        return static_cast<int>(std::lround(255 * std::clamp(below + (top - below) * c.w, 0.f, 1.f)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", part(c.x, back.x), part(c.y, back.y), part(c.z, back.z));
}

ImU32 colorOf(const std::string& hex) {
    unsigned v = 0;
    if (std::sscanf(hex.c_str(), "#%6x", &v) != 1) v = 0;
    return IM_COL32(v >> 16 & 255, v >> 8 & 255, v & 255, 255);
}

}  // namespace sward::ui
