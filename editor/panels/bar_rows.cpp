#include "panels/bar_rows.h"

#include <imgui.h>

#include "ui/theme.h"

namespace sward::bar {

float em(float ems) { return ImGui::GetFontSize() * ems; }

void next(Rows& rows, const char* label, float width) {
    const float needed = 14 + ImGui::CalcTextSize(label).x + 5 + width;
    if (ImGui::GetItemRectMax().x + needed > rows.right - 6)
        ++rows.count;
    else
        ImGui::SameLine(0, 14);
}

void caption(const char* text) {
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, text);
    ImGui::SameLine(0, 5);
}

void number(Rows& rows, const char* label, float& value, float width, const ui::NumberSpec& spec, const char* help) {
    next(rows, label, width);
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

ui::NumberSpec range(double softMin, double softMax, double hardMin, double hardMax, const char* unit) {
    ui::NumberSpec s;
    s.softMin = softMin, s.softMax = softMax, s.hardMin = hardMin, s.hardMax = hardMax, s.unit = unit;
    return s;
}

}  // namespace sward::bar
