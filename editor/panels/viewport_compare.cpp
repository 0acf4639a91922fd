#include "panels/viewport_compare.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "metrics/heatmap.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

constexpr float kGrip = 11;  // radius, pixels

float lineX(const Comparison& c, const Rect& r) { return r.x + std::round(r.w * c.split); }
ImVec2 gripAt(const Comparison& c, const Rect& r) {
    return {std::clamp(lineX(c, r), r.x + kGrip, r.x + std::max(r.w - kGrip, kGrip)), r.y + r.h / 2};
}

// On a dark plate, so that it can be read over any picture; `right` of x or left of it.
void plate(const std::string& text, float x, float y, bool right) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float left = right ? x + 8 : x - 8 - size.x;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({left - 5, y}, {left + size.x + 5, y + size.y + 6}, IM_COL32(16, 18, 16, 205), 3);
    list.AddText({left, y + 3}, IM_COL32_WHITE, text.c_str());
}

void scaleBar(const Comparison& c, const Rect& r) {
    constexpr int kParts = 32;
    const float w = 120, h = 10, x = r.x + r.w - w - 44, y = r.y + r.h - 26;
    if (x < lineX(c, r)) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({x - 16, y - 20}, {r.x + r.w - 8, y + h + 8}, IM_COL32(16, 18, 16, 205), 3);
    for (int i = 0; i < kParts; ++i) {
        const glm::vec3 heat = heatColor((i + 0.5) / kParts) * 255.0f;
        const ImU32 color = IM_COL32(static_cast<int>(heat.x), static_cast<int>(heat.y), static_cast<int>(heat.z), 255);
        list.AddRectFilled({x + w * static_cast<float>(i) / kParts, y},
                           {x + w * static_cast<float>(i + 1) / kParts, y + h}, color);
    }
    list.AddText({x, y - 17}, IM_COL32_WHITE, fmt::format("{} error", kErrorMetrics[c.metric]).c_str());
    list.AddText({x - 10, y - 3}, IM_COL32_WHITE, "0");
    list.AddText({x + w + 5, y - 3}, IM_COL32_WHITE, fmt::format("{:g}", heatScale(c.metric)).c_str());
}

void otherSide(const Comparison& c, const Rect& r) {
    const bool heat = c.show == CompareShow::Error && c.heat.id() != 0;
    const Texture& t = heat ? c.heat : c.picture;
    if (t.id() == 0) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect({lineX(c, r), r.y}, {r.x + r.w, r.y + r.h}, true);
    const float top = heat || c.topFirst ? 0 : 1;
    list.AddImage(ui::textureId(t.id()), {r.x, r.y}, {r.x + r.w, r.y + r.h}, {0, top}, {1, 1 - top});
    list.PopClipRect();
    if (heat) scaleBar(c, r);
}

void lineAndGrip(const Comparison& c, const Rect& r, bool held) {
    const float x = lineX(c, r);
    const ImVec2 g = gripAt(c, r);
    const bool hot = c.gripHovered || held;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({x, r.y}, {x, r.y + r.h}, IM_COL32(0, 0, 0, 130), 3);
    list.AddLine({x, r.y}, {x, r.y + r.h}, IM_COL32(255, 255, 255, 220), 1);
    list.AddCircleFilled(g, kGrip, hot ? ui::kAccent : IM_COL32(30, 33, 30, 235));
    list.AddCircle(g, kGrip, IM_COL32_WHITE, 0, 1.5f);
    for (const float side : {-1.0f, 1.0f})
        list.AddTriangleFilled({g.x + side * 7, g.y}, {g.x + side * 3, g.y - 4}, {g.x + side * 3, g.y + 4},
                               IM_COL32_WHITE);
}

}  // namespace

void drawComparison(const Comparison& c, const ViewportHand& hand, const SideNames& names) {
    if (c.against == Against::Off) return;
    const Rect& r = hand.rect;
    otherSide(c, r);
    lineAndGrip(c, r, hand.gesture == Gesture::Split);
    const float y = r.y + names.top;
    const bool error = c.show == CompareShow::Error && c.heat.id() != 0;
    plate(names.own, lineX(c, r), y, false);
    plate((error ? "error against " : "") + names.other, lineX(c, r), y, true);
    const ImVec2 g = gripAt(c, r);
    ui::Widget w;
    w.kind = ui::Kind::Area;
    w.x0 = g.x - kGrip, w.x1 = g.x + kGrip, w.y0 = g.y - kGrip, w.y1 = g.y + kGrip;
    w.value = ui::numberText(static_cast<double>(c.split));
    ui::recordAt("Viewport/Split", w);
}

void hoverSplit(Comparison& c, ViewportHand& hand, const FrameInput& in, bool over) {
    releaseSplit(c, hand);
    const ImVec2 g = gripAt(c, hand.rect);
    const double away = std::hypot(in.x - static_cast<double>(g.x), in.y - static_cast<double>(g.y));
    c.gripHovered = c.against != Against::Off && over && away <= static_cast<double>(kGrip) + 1;
    if (c.gripHovered || hand.gesture == Gesture::Split) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
}

bool grabSplit(const Comparison& c, const FrameInput& in) {
    return c.gripHovered && !in.ctrl() && !in.shift() && !in.alt();
}

void dragSplit(Comparison& c, const Rect& view, double x) {
    c.split = std::clamp((static_cast<float>(x) - view.x) / std::max(view.w, 1.0f), 0.0f, 1.0f);
}

void releaseSplit(const Comparison& c, ViewportHand& hand) {
    if (c.against == Against::Off && hand.gesture == Gesture::Split) hand.gesture = Gesture::None;
}

}  // namespace sward
