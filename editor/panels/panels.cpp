#include "panels/panels.h"

#include <imgui.h>

#include "ui/theme.h"

namespace sward {
namespace {

constexpr PanelRow kPanels[] = {
    {"Menu", Dock::Menu, drawMenuBar, false},
    {"Play", Dock::Menu, drawPlayBar, false},
    {"Brush", Dock::BrushBar, drawBrushBar, false, nullptr, true},
    {"Tools", Dock::Tools, drawToolStrip, false, nullptr, true},
    {"Viewport", Dock::Viewport, drawViewport, false},
    {"Outliner", Dock::Outliner, drawOutliner, true, nullptr, true},
    {"Inspector", Dock::Inspector, drawInspector, true, nullptr, true},
    {"Console", Dock::Bottom, drawConsole, true},
    {"Profiler", Dock::Bottom, drawProfiler, true},
    {"Tiers", Dock::Bottom, drawTiers, true, "Tiers Panel", true},
    {"Accuracy", Dock::Bottom, drawAccuracy, true, nullptr, true},
    {"Status", Dock::StatusBar, drawStatusBar, false},
    {"Files", Dock::Dialog, drawFileDialog, false},
    {"Unsaved", Dock::Dialog, drawUnsavedDialog, false},
    {"Recovery", Dock::Dialog, drawRecoveryDialog, false},
};

constexpr int kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                       ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                       ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavInputs |
                       ImGuiWindowFlags_NoNavFocus;

const Rect* areaOf(const EditorApp& app, Dock dock) {
    switch (dock) {
        case Dock::BrushBar:
            return &app.areas.brushBar;
        case Dock::Tools:
            return &app.areas.tools;
        case Dock::Viewport:
            return &app.areas.viewport;
        case Dock::Outliner:
            return &app.areas.outliner;
        case Dock::Inspector:
            return &app.areas.inspector;
        case Dock::Bottom:
            return &app.areas.bottom;
        case Dock::StatusBar:
            return &app.areas.status;
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

void drawRow(EditorApp& app, const PanelRow& row) {
    const ui::Disabled waits(row.edits && playing(app));
    row.draw(app);
}

void drawInArea(EditorApp& app, const PanelRow& row, const Rect& area) {
    const bool viewport = row.dock == Dock::Viewport;
    if (viewport) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    const bool shown = beginArea(row.name, area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (viewport) ImGui::PopStyleVar();
    if (!shown) return;
    drawRow(app, row);
    ImGui::End();
}

// The panels docked at the bottom share their place as tabs.
void drawBottom(EditorApp& app) {
    if (!beginArea("Bottom", app.areas.bottom, ImGuiWindowFlags_NoScrollbar)) return;
    app.layout.tab = openTab(app.layout);
    const PanelRow* open = nullptr;
    bool first = true;
    for (const PanelRow& row : panelRows()) {
        if (row.dock != Dock::Bottom || app.layout.hidden.count(row.name)) continue;
        if (!first) ImGui::SameLine(0, 4);
        first = false;
        const ui::Scope scope("Tabs");
        if (ui::button(row.name, 0, app.layout.tab == row.name)) app.layout.tab = row.name;
        if (app.layout.tab == row.name) open = &row;
    }
    ImGui::Separator();
    if (open) {
        const ui::Scope scope(open->name);
        drawRow(app, *open);
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

void drawSplitters(EditorApp& app) {
    const ui::Scope scope("Splitter");
    const Areas& a = app.areas;
    constexpr float kGrip = 4;
    const float column = std::max(a.outliner.h, a.inspector.h) > 0 ? a.inspector.w + a.outliner.w : 0;
    if (column > 0)
        splitter("Right", {a.inspector.x - kGrip / 2, a.tools.y, kGrip, a.tools.h}, true, -1, app.layout.right);
    if (a.bottom.h > 0)
        splitter("Bottom", {a.bottom.x, a.bottom.y - kGrip / 2, a.bottom.w, kGrip}, false, -1,
                 bottomHeight(app.layout));
    if (a.outliner.h > 0 && a.inspector.h > 0) {
        float height = app.layout.outliner * a.tools.h;
        splitter("Outliner", {a.inspector.x, a.inspector.y - kGrip / 2, a.inspector.w, kGrip}, false, 1, height);
        app.layout.outliner = height / std::max(a.tools.h, 1.f);
    }
}

}  // namespace

std::span<const PanelRow> panelRows() { return kPanels; }

float brushBarHeight(int rows) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    return static_cast<float>(rows) * (ImGui::GetFrameHeight() + spacing) - spacing +
           2 * ImGui::GetStyle().WindowPadding.y;
}
float statusBarHeight() { return ImGui::GetTextLineHeight() + 10; }
float toolStripWidth() { return ImGui::GetFontSize() * 2.2f + 2 * ImGui::GetStyle().WindowPadding.x; }

void drawPanels(EditorApp& app) {
    const float width = static_cast<float>(app.surface->width()), height = static_cast<float>(app.surface->height());
    clampLayout(app.layout, width, height);
    app.areas = areasOf(app.layout, width, height, ImGui::GetFrameHeight(), brushBarHeight(app.brushBarRows),
                        statusBarHeight(), toolStripWidth());
    for (const PanelRow& row : kPanels) {
        if (row.dock == Dock::Bottom) continue;
        const ui::Scope scope(row.name);
        if (const Rect* area = areaOf(app, row.dock)) {
            if (!app.layout.hidden.count(row.name)) drawInArea(app, row, *area);
        } else {
            row.draw(app);
        }
    }
    drawBottom(app);
    drawSplitters(app);
}

}  // namespace sward
