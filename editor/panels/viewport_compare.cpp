#include "panels/viewport_compare.h"

#include <fmt/format.h>
#include <imgui.h>

#include "metrics/heatmap.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"

namespace sward {
namespace {

constexpr float kGrip = 11;  // radius, pixels

float lineX(const EditorApp& app) {
    const Rect& r = app.viewport.rect;
    return r.x + std::round(r.w * app.accuracy.comparison.split);
}
ImVec2 gripAt(const EditorApp& app) {
    const Rect& r = app.viewport.rect;
    return {std::clamp(lineX(app), r.x + kGrip, r.x + std::max(r.w - kGrip, kGrip)), r.y + r.h / 2};
}

// On a dark plate, so that it can be read over any picture; `right` of x or left of it.
void plate(const std::string& text, float x, float y, bool right) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float left = right ? x + 8 : x - 8 - size.x;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({left - 5, y}, {left + size.x + 5, y + size.y + 6}, IM_COL32(16, 18, 16, 205), 3);
    list.AddText({left, y + 3}, IM_COL32_WHITE, text.c_str());
}

void scaleBar(const EditorApp& app) {
    const Rect& r = app.viewport.rect;
    constexpr int kParts = 32;
    const float w = 120, h = 10, x = r.x + r.w - w - 44, y = r.y + r.h - 26;
    if (x < lineX(app)) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({x - 16, y - 20}, {r.x + r.w - 8, y + h + 8}, IM_COL32(16, 18, 16, 205), 3);
    for (int i = 0; i < kParts; ++i) {
        const glm::vec3 c = heatColor((i + 0.5) / kParts) * 255.0f;
        const ImU32 color = IM_COL32(static_cast<int>(c.x), static_cast<int>(c.y), static_cast<int>(c.z), 255);
        list.AddRectFilled({x + w * static_cast<float>(i) / kParts, y},
                           {x + w * static_cast<float>(i + 1) / kParts, y + h}, color);
    }
    const ErrorMetric metric = app.accuracy.comparison.metric;
    list.AddText({x, y - 17}, IM_COL32_WHITE,
                 fmt::format("{} error", kErrorMetrics[metric]).c_str());
    list.AddText({x - 10, y - 3}, IM_COL32_WHITE, "0");
    list.AddText({x + w + 5, y - 3}, IM_COL32_WHITE, fmt::format("{:g}", heatScale(metric)).c_str());
}

void otherSide(const EditorApp& app) {
    const Comparison& c = app.accuracy.comparison;
    const Rect& r = app.viewport.rect;
    const bool heat = c.show == CompareShow::Error && c.heat.id() != 0;
    const Texture& t = heat ? c.heat : c.picture;
    if (t.id() == 0) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect({lineX(app), r.y}, {r.x + r.w, r.y + r.h}, true);
    const float top = heat || c.topFirst ? 0 : 1;
    list.AddImage(ui::textureId(t.id()), {r.x, r.y}, {r.x + r.w, r.y + r.h}, {0, top}, {1, 1 - top});
    list.PopClipRect();
    if (heat) scaleBar(app);
}

void lineAndGrip(const EditorApp& app) {
    const Rect& r = app.viewport.rect;
    const float x = lineX(app);
    const ImVec2 g = gripAt(app);
    const bool hot = app.accuracy.comparison.gripHovered || app.viewport.gesture == Gesture::Split;
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

void drawComparison(EditorApp& app) {
    const Comparison& c = app.accuracy.comparison;
    if (c.against == Against::Off) return;
    otherSide(app);
    lineAndGrip(app);
    const Rect& r = app.viewport.rect;
    const float y = r.y + (app.notice.empty() ? 6 : 60);
    const bool error = c.show == CompareShow::Error && c.heat.id() != 0;
    plate(techniqueShown(app.doc), lineX(app), y, false);
    plate((error ? "error against " : "") + comparisonLabel(app), lineX(app), y, true);
    const ImVec2 g = gripAt(app);
    ui::Widget& w = app.book.next["Viewport/Split"];
    w = {};
    w.kind = ui::Kind::Area;
    w.x0 = g.x - kGrip, w.x1 = g.x + kGrip, w.y0 = g.y - kGrip, w.y1 = g.y + kGrip;
    w.value = ui::numberText(static_cast<double>(c.split));
}

void hoverSplit(EditorApp& app, bool over) {
    Comparison& c = app.accuracy.comparison;
    const ImVec2 g = gripAt(app);
    const double away = std::hypot(app.in.x - static_cast<double>(g.x), app.in.y - static_cast<double>(g.y));
    c.gripHovered = c.against != Against::Off && over && away <= static_cast<double>(kGrip) + 1;
    if (c.gripHovered || app.viewport.gesture == Gesture::Split) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
}

bool grabSplit(const EditorApp& app) {
    return app.accuracy.comparison.gripHovered && !app.in.ctrl() && !app.in.shift() && !app.in.alt();
}

void dragSplit(EditorApp& app, double x) {
    const Rect& r = app.viewport.rect;
    app.accuracy.comparison.split = std::clamp((static_cast<float>(x) - r.x) / std::max(r.w, 1.0f), 0.0f, 1.0f);
}

}  // namespace sward
