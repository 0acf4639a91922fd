// The brush bar: what the brush paints on and how. Each tool and map has settings of its own.
#include <imgui.h>

#include "panels/panels.h"
#include "ui/theme.h"

namespace sward {
namespace {

void caption(const char* text) {
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, text);
    ImGui::SameLine(0, 5);
}

void next() { ImGui::SameLine(0, 14); }

float em(float ems) { return ImGui::GetFontSize() * ems; }

void mapCombo(EditorApp& app) {
    std::vector<std::string> names, paths;
    for (const FieldRef& map : paintableMaps(app)) {
        paths.push_back(map.path);
        names.push_back(static_cast<const MapField*>(map.value)->present() ? map.path : map.path + " (new)");
    }
    const auto it = std::find(paths.begin(), paths.end(), app.brushes.map);
    int chosen = it == paths.end() ? -1 : static_cast<int>(it - paths.begin());
    caption("Map");
    ImGui::SetNextItemWidth(em(22));
    if (ui::combo("Map", names, chosen)) app.brushes.map = paths[static_cast<size_t>(chosen)];
    ui::tooltip("The map that the brush paints: where this kind of grass grows.");
}

void modeCombo(EditorApp& app) {
    std::vector<std::string> labels{"Look"}, tools{kLookTool};
    for (const BrushRow& row : brushRows()) labels.push_back(row.label), tools.push_back(row.name);
    const auto it = std::find(tools.begin(), tools.end(), app.brushes.tool);
    int chosen = static_cast<int>(it - tools.begin());
    caption("Mode");
    ImGui::SetNextItemWidth(em(7));
    if (ui::combo("Mode", labels, chosen)) selectTool(app, tools[static_cast<size_t>(chosen)]);
}

void number(const char* label, float& value, float width, const ui::NumberSpec& spec, const char* help) {
    caption(label);
    ImGui::SetNextItemWidth(width);
    ui::slider(label, value, spec);
    const std::string* error = ui::errorAt(label);
    ui::tooltip(error ? *error : help);
    if (error) {
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddRect(low, high, ui::kErrorText, 3);
    }
}

ui::NumberSpec range(double softMin, double softMax, double hardMin, double hardMax, const char* unit = "") {
    ui::NumberSpec s;
    s.softMin = softMin, s.softMax = softMax, s.hardMin = hardMin, s.hardMax = hardMax, s.unit = unit;
    return s;
}

}  // namespace

void drawBrushBar(EditorApp& app) {
    const ui::Disabled noProject(!app.doc.isOpen());
    modeCombo(app);
    next();
    mapCombo(app);
    const ui::Disabled looking(app.brushes.tool == kLookTool);
    BrushSettings& b = currentBrush(app.brushes);
    next();
    number("Radius", b.radius, em(7.5f), range(0.1, 30, 0.05, 500, "m"), "Size of the brush: [ and ] change it.");
    next();
    number("Strength", b.strength, em(5.5f), range(0, 1, 0, 1),
           "How much one pass over a place changes it: - and = change it.");
    next();
    number("Falloff", b.falloff, em(5.5f), range(0, 1, 0, 1), "0: a hard edge; 1: weaker from the centre on.");
    if (b.mode != "set") return;
    next();
    number("Value", b.value, em(5.5f), range(0, 1, 0, 1), "What the brush paints towards: 0 is bare, 1 is full.");
}

}  // namespace sward
