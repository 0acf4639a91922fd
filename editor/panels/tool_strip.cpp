// The tools: choosing and moving objects, drawing paths, then one a brush. Icons are drawn, so that no font must have
// them.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/panels.h"
#include "tools/brush_target.h"
#include "tools/gizmo.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

using Draw = ImDrawList&;

void plus(Draw d, ImVec2 c, float r, ImU32 color, bool upright) {
    d.AddLine({c.x - r, c.y}, {c.x + r, c.y}, color, 2);
    if (upright) d.AddLine({c.x, c.y - r}, {c.x, c.y + r}, color, 2);
}

// The pointer's arrow.
void pointer(Draw d, ImVec2 c, float r, ImU32 color) {
    const ImVec2 tip{c.x - r * 0.55f, c.y - r * 1.05f};
    d.AddTriangleFilled(tip, {tip.x, tip.y + r * 1.9f}, {tip.x + r * 1.35f, tip.y + r * 1.35f}, color);
    d.AddLine({c.x - r * 0.1f, c.y + r * 0.2f}, {c.x + r * 0.35f, c.y + r * 1.1f}, color, 2.4f);
}

// Arrows four ways.
void cross(Draw d, ImVec2 c, float r, ImU32 color) {
    plus(d, c, r, color, true);
    for (const ImVec2 way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)})
        d.AddTriangleFilled({c.x + way.x * r * 1.35f, c.y + way.y * r * 1.35f},
                            {c.x + way.x * r * 0.8f - way.y * r * 0.4f, c.y + way.y * r * 0.8f + way.x * r * 0.4f},
                            {c.x + way.x * r * 0.8f + way.y * r * 0.4f, c.y + way.y * r * 0.8f - way.x * r * 0.4f},
                            color);
}

// Most of a circle, with an arrow's head.
void turn(Draw d, ImVec2 c, float r, ImU32 color) {
    d.PathArcTo(c, r, -0.6f, 4.2f);
    d.PathStroke(color, 0, 2);
    d.AddTriangleFilled({c.x + r * 0.35f, c.y - r * 0.9f}, {c.x + r * 1.3f, c.y - r * 0.85f},
                        {c.x + r * 0.95f, c.y + r * 0.05f}, color);
}

// A winding line between two points.
void winding(Draw d, ImVec2 c, float r, ImU32 color) {
    const ImVec2 from{c.x - r, c.y + r * 0.8f}, to{c.x + r, c.y - r * 0.8f};
    d.AddBezierCubic(from, {c.x + r * 1.4f, c.y + r * 0.9f}, {c.x - r * 1.4f, c.y - r * 0.9f}, to, color, 2.2f);
    for (const ImVec2& end : {from, to}) d.AddCircleFilled(end, r * 0.3f, color);
}

// A small square that grows into a large one.
void grow(Draw d, ImVec2 c, float r, ImU32 color) {
    d.AddRectFilled({c.x - r, c.y + r * 0.1f}, {c.x - r * 0.1f, c.y + r}, color);
    d.AddRect({c.x - r, c.y - r}, {c.x + r, c.y + r}, color, 0, 0, 1.4f);
    d.AddLine({c.x, c.y}, {c.x + r * 0.6f, c.y - r * 0.6f}, color, 1.8f);
}

void level(Draw d, ImVec2 c, float r, ImU32 color) {
    d.AddLine({c.x - r, c.y - r * 0.45f}, {c.x + r, c.y - r * 0.45f}, color, 2);
    d.AddLine({c.x - r, c.y + r * 0.45f}, {c.x + r, c.y + r * 0.45f}, color, 2);
}

void wave(Draw d, ImVec2 c, float r, ImU32 color) {
    for (const float y : {-0.4f, 0.4f})
        d.AddBezierCubic({c.x - r, c.y + y * r}, {c.x - r * 0.3f, c.y + (y - 0.9f) * r},
                         {c.x + r * 0.3f, c.y + (y + 0.9f) * r}, {c.x + r, c.y + y * r}, color, 1.8f);
}

void specks(Draw d, ImVec2 c, float r, ImU32 color) {
    constexpr float kSpecks[][2] = {{-0.8f, -0.6f}, {0.1f, -0.9f}, {0.8f, -0.3f}, {-0.3f, 0.0f},
                                    {0.5f, 0.5f},   {-0.8f, 0.7f}, {0.0f, 0.9f}};
    for (const auto& s : kSpecks) d.AddCircleFilled({c.x + s[0] * r, c.y + s[1] * r}, r * 0.18f, color);
}

// Three blades laid the same way.
void comb(Draw d, ImVec2 c, float r, ImU32 color) {
    for (const float x : {-0.9f, -0.2f, 0.5f})
        d.AddBezierQuadratic({c.x + x * r, c.y + r}, {c.x + x * r, c.y - r * 0.4f},
                             {c.x + (x + 0.8f) * r, c.y - r * 0.8f}, color, 1.8f);
}

// A roller over a flat line.
void roller(Draw d, ImVec2 c, float r, ImU32 color) {
    d.AddCircle({c.x, c.y - r * 0.25f}, r * 0.75f, color, 0, 1.8f);
    d.AddLine({c.x - r * 1.2f, c.y + r * 0.8f}, {c.x + r * 1.2f, c.y + r * 0.8f}, color, 2);
    d.AddLine({c.x, c.y - r * 0.25f}, {c.x + r * 1.1f, c.y - r * 1.1f}, color, 1.8f);
}

void compass(Draw d, ImVec2 c, float r, ImU32 color) {
    d.AddCircle(c, r * 1.15f, color, 0, 1.4f);
    d.AddTriangleFilled({c.x + r * 0.62f, c.y - r * 0.62f}, {c.x - r * 0.6f, c.y - r * 0.05f},
                        {c.x + r * 0.05f, c.y + r * 0.6f}, color);
}

// A hill over a line, or a hollow under it.
void mound(Draw d, ImVec2 c, float r, ImU32 color, float up) {
    d.AddLine({c.x - r * 1.2f, c.y + up * r * 0.7f}, {c.x + r * 1.2f, c.y + up * r * 0.7f}, color, 1.4f);
    d.AddBezierCubic({c.x - r * 1.1f, c.y + up * r * 0.5f}, {c.x - r * 0.3f, c.y + up * r * 0.4f},
                     {c.x - r * 0.5f, c.y - up * r}, {c.x, c.y - up * r}, color, 2);
    d.AddBezierCubic({c.x, c.y - up * r}, {c.x + r * 0.5f, c.y - up * r}, {c.x + r * 0.3f, c.y + up * r * 0.4f},
                     {c.x + r * 1.1f, c.y + up * r * 0.5f}, color, 2);
}

// A hill that is cut off level.
void mesa(Draw d, ImVec2 c, float r, ImU32 color) {
    const ImVec2 line[] = {{c.x - r * 1.2f, c.y + r * 0.7f},
                           {c.x - r * 0.6f, c.y - r * 0.4f},
                           {c.x + r * 0.6f, c.y - r * 0.4f},
                           {c.x + r * 1.2f, c.y + r * 0.7f}};
    d.AddPolyline(line, 4, color, 0, 2);
}

void wedge(Draw d, ImVec2 c, float r, ImU32 color) {
    d.AddTriangle({c.x - r * 1.1f, c.y + r * 0.7f}, {c.x + r * 1.1f, c.y + r * 0.7f}, {c.x + r * 1.1f, c.y - r * 0.8f},
                  color, 1.8f);
}

// A slope with gullies.
void gullies(Draw d, ImVec2 c, float r, ImU32 color) {
    d.AddLine({c.x, c.y - r}, {c.x - r * 1.1f, c.y + r * 0.8f}, color, 1.8f);
    d.AddLine({c.x, c.y - r}, {c.x + r * 1.1f, c.y + r * 0.8f}, color, 1.8f);
    for (const float x : {-0.35f, 0.05f, 0.4f})
        d.AddBezierQuadratic({c.x + x * r * 0.5f, c.y - r * 0.2f}, {c.x + (x - 0.2f) * r, c.y + r * 0.3f},
                             {c.x + x * r * 1.2f, c.y + r * 0.9f}, color, 1.4f);
}

// A stamp with its handle, over what it leaves.
void stamp(Draw d, ImVec2 c, float r, ImU32 color) {
    d.AddCircleFilled({c.x, c.y - r * 0.8f}, r * 0.38f, color);
    d.AddLine({c.x, c.y - r * 0.7f}, {c.x, c.y + r * 0.2f}, color, 2.4f);
    d.AddRectFilled({c.x - r * 0.9f, c.y + r * 0.15f}, {c.x + r * 0.9f, c.y + r * 0.5f}, color, 1);
    for (const float x : {-0.7f, 0.0f, 0.7f}) d.AddCircleFilled({c.x + x * r, c.y + r * 0.95f}, r * 0.16f, color);
}

void icon(const std::string& tool, const char* label, ImVec2 low, ImVec2 high, ImU32 color) {
    Draw d = *ImGui::GetWindowDrawList();
    const ImVec2 c{(low.x + high.x) / 2, (low.y + high.y) / 2};
    const float r = (high.x - low.x) * 0.26f;
    if (tool == "add" || tool == "subtract") return plus(d, c, r, color, tool == "add");
    if (tool == "set") return level(d, c, r, color);
    if (tool == "smooth") return wave(d, c, r, color);
    if (tool == "noise") return specks(d, c, r, color);
    if (tool == "comb") return comb(d, c, r, color);
    if (tool == "press") return roller(d, c, r, color);
    if (tool == "direction") return compass(d, c, r, color);
    if (tool == "raise" || tool == "lower") return mound(d, c, r, color, tool == "raise" ? 1.f : -1.f);
    if (tool == "flatten") return mesa(d, c, r, color);
    if (tool == "ramp") return wedge(d, c, r, color);
    if (tool == "erode") return gullies(d, c, r, color);
    if (tool == "imprint") return stamp(d, c, r, color);
    const char first[2] = {label[0], 0};
    const ImVec2 size = ImGui::CalcTextSize(first);
    d.AddText({c.x - size.x / 2, c.y - size.y / 2}, color, first);
}

using ToolIcon = void (*)(Draw, ImVec2 centre, float radius, ImU32 color);

// As wide as the strip, but no larger than lets all of them fit one above the other.
float buttonSide(size_t buttons) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    return std::max(8.f, std::min(room.x, std::floor((room.y - 2 * gap) / static_cast<float>(buttons) - gap)));
}

// True if it was pressed. `own`: its icon, of what is no brush.
bool toolButton(bool chosen, const std::string& tool, const char* label, const std::string& help, float side,
                ToolIcon own = nullptr) {
    if (chosen) ui::pushAccent();
    const bool pressed = ImGui::Button(("##" + tool).c_str(), {side, side});
    if (chosen) ui::popAccent();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ui::record(label, ui::Kind::Button, chosen ? "true" : "false");
    ui::tooltip(std::string(label) + "\n" + help);
    const ImU32 color = chosen ? ui::kStrongLine : ImGui::GetColorU32(ImGuiCol_Text);
    if (own)
        own(*ImGui::GetWindowDrawList(), {(low.x + high.x) / 2, (low.y + high.y) / 2}, side * 0.26f, color);
    else
        icon(tool, label, low, high, color);
    return pressed;
}

struct ObjectButton {
    GizmoMode mode;
    ToolIcon icon;
    const char* label;
    const char* help;
};
constexpr ObjectButton kObjectButtons[] = {
    {GizmoMode::Select, pointer, "Select",
     "A click or a box chooses objects; Shift adds, Ctrl toggles. V switches between objects and the brush. Right "
     "button and W A S D fly, Alt and left button orbit."},
    {GizmoMode::Move, cross, "Move", "Chooses and moves objects (W). Ctrl snaps to the grid, Escape lets go."},
    {GizmoMode::Turn, turn, "Turn", "Chooses and turns objects (E). Ctrl snaps to steps, Escape lets go."},
    {GizmoMode::Scale, grow, "Scale", "Chooses and scales objects (R). Ctrl snaps to steps, Escape lets go."},
    {GizmoMode::Path, winding, "Path",
     "Draws paths on which nothing grows (P). A click on the ground adds a point, on the curve inserts one, a drag "
     "moves "
     "it, Delete removes it; Enter or Escape ends."},
};

}  // namespace

void drawToolStrip(const Document& doc, BrushBook& brushes, GizmoMode& mode, Messages& messages) {
    const float side = buttonSide(std::size(kObjectButtons) + brushRows().size());
    for (const ObjectButton& b : kObjectButtons) {
        if (!toolButton(brushes.tool == kViewTool && mode == b.mode, b.label, b.label, b.help, side, b.icon)) continue;
        selectTool(doc, brushes, messages, kViewTool);
        mode = b.mode;
    }
    ImGui::Spacing();
    for (const BrushRow& row : brushRows())
        if (toolButton(brushes.tool == row.name, row.name, row.label, row.help, side))
            selectTool(doc, brushes, messages, row.name);
}

}  // namespace sward
