#include "panels/panels.h"

#include <algorithm>

#include <imgui.h>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

constexpr int kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                       ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                       ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavInputs |
                       ImGuiWindowFlags_NoNavFocus;

const Rect* areaOf(const Areas& areas, Dock dock) {
    switch (dock) {
        case Dock::BrushBar:
            return &areas.brushBar;
        case Dock::Tools:
            return &areas.tools;
        case Dock::Viewport:
            return &areas.viewport;
        case Dock::Outliner:
            return &areas.outliner;
        case Dock::Inspector:
            return &areas.inspector;
        case Dock::Bottom:
            return &areas.bottom;
        case Dock::StatusBar:
            return &areas.status;
        default:
            return nullptr;
    }
}

bool beginArea(const char* name, const Rect& r, int flags) {
    if (r.w < 1 || r.h < 1) return false;
    ImGui::SetNextWindowPos({r.x, r.y});
    ImGui::SetNextWindowSize({r.w, r.h});
    ImGui::Begin(name, nullptr, kFixed | flags);
    return true;
}

void drawRow(EditorApp& app, const PanelRow& row, bool playing) {
    const ui::Disabled waits(row.edits && playing);
    row.draw(app);
}

void drawInArea(EditorApp& app, const PanelRow& row, const Rect& area, bool playing) {
    const bool viewport = row.dock == Dock::Viewport;
    if (viewport) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    const bool shown = beginArea(row.name, area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (viewport) ImGui::PopStyleVar();
    if (!shown) return;
    drawRow(app, row, playing);
    ImGui::End();
}

// The panels docked at the bottom share their place as tabs.
void drawBottom(EditorApp& app, Layout& layout, const Rect& area, bool playing) {
    if (!beginArea("Bottom", area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) return;
    layout.tab = openTab(layout);
    const PanelRow* open = nullptr;
    bool first = true;
    for (const PanelRow& row : panelRows()) {
        if (row.dock != Dock::Bottom || layout.hidden.count(row.name)) continue;
        const float width = ImGui::CalcTextSize(row.name).x + 2 * ImGui::GetStyle().FramePadding.x;
        if (!first && ImGui::GetItemRectMax().x + 4 + width < area.x + area.w) ImGui::SameLine(0, 4);
        first = false;
        const ui::Scope scope("Tabs");
        if (ui::button(row.name, 0, layout.tab == row.name)) layout.tab = row.name;
        if (layout.tab == row.name) open = &row;
    }
    ImGui::Separator();
    if (open) {
        const ui::Scope scope(open->name);
        ImGui::BeginChild("panel");  // what it holds is scrolled, and the tabs stay
        ImGui::PushTextWrapPos(0);   // no sentence ends at the edge
        drawRow(app, *open, playing);
        ImGui::PopTextWrapPos();
        ImGui::EndChild();
    }
    ImGui::End();
}

// A strip between two areas that is dragged; `value` grows with the motion along x or y times `sign`.
void splitter(const char* name, const Rect& r, bool vertical, float sign, float& value) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::SetNextWindowPos({r.x, r.y});
    ImGui::SetNextWindowSize({r.w, r.h});
    const bool shown =
        ImGui::Begin(name, nullptr, (kFixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_NoBackground);
    ImGui::PopStyleVar(2);
    if (shown) {
        ImGui::InvisibleButton("grip", {std::max(r.w, 1.f), std::max(r.h, 1.f)});
        ui::record(name, ui::Kind::Area);
        const bool active = ImGui::IsItemActive();
        if (active && !ImGui::IsItemActivated())  // the way to the strip is none along it
            value += sign * (vertical ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y);
        if (active || ImGui::IsItemHovered()) {
            ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
            ImGui::GetWindowDrawList()->AddRectFilled({r.x, r.y}, {r.x + r.w, r.y + r.h}, ui::kAccent);
        }
    }
    ImGui::End();
}

void drawSplitters(Layout& layout, const Areas& a) {
    const ui::Scope scope("Splitter");
    constexpr float kGrip = 4;
    const float column = std::max(a.outliner.h, a.inspector.h) > 0 ? a.inspector.w + a.outliner.w : 0;
    if (column > 0) splitter("Right", {a.inspector.x - kGrip / 2, a.tools.y, kGrip, a.tools.h}, true, -1, layout.right);
    if (a.bottom.h > 0)
        splitter("Bottom", {a.bottom.x, a.bottom.y - kGrip / 2, a.bottom.w, kGrip}, false, -1, bottomHeight(layout));
    if (a.outliner.h > 0 && a.inspector.h > 0) {
        float height = layout.outliner * a.tools.h;
        splitter("Outliner", {a.inspector.x, a.inspector.y - kGrip / 2, a.inspector.w, kGrip}, false, 1, height);
        layout.outliner = height / std::max(a.tools.h, 1.f);
    }
}

}  // namespace

float brushBarHeight(int rows) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    return static_cast<float>(rows) * (ImGui::GetFrameHeight() + spacing) - spacing +
           2 * ImGui::GetStyle().WindowPadding.y;
}
float statusBarHeight() { return ImGui::GetTextLineHeight() + 10; }
float toolStripWidth() { return ImGui::GetFontSize() * 2.2f + 2 * ImGui::GetStyle().WindowPadding.x; }

void drawPanels(EditorApp& app, Layout& layout, Areas& areas, const glm::vec2& size, int brushBarRows, bool playing) {
    clampLayout(layout, size.x, size.y);
    areas = areasOf(layout, size.x, size.y, ImGui::GetFrameHeight(), brushBarHeight(brushBarRows), statusBarHeight(),
                    toolStripWidth());
    for (const PanelRow& row : panelRows()) {
        if (row.dock == Dock::Bottom) continue;
        const ui::Scope scope(row.name);
        if (const Rect* area = areaOf(areas, row.dock)) {
            if (!layout.hidden.count(row.name)) drawInArea(app, row, *area, playing);
        } else {
            row.draw(app);
        }
    }
    drawBottom(app, layout, areas.bottom, playing);
    drawSplitters(layout, areas);
}

}  // namespace sward
