// The two themes: text stands out from what lies under it in both.
#include "ui/theme.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sward::ui {
namespace {

double light(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
double luminance(const ImVec4& c) {
    return 0.2126 * light(static_cast<double>(c.x)) + 0.7152 * light(static_cast<double>(c.y)) +
           0.0722 * light(static_cast<double>(c.z));
}
// WCAG 2.1, section 1.4.3.
double contrast(const ImVec4& a, const ImVec4& b) {
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

class Themes : public testing::TestWithParam<Theme> {
  protected:
    Themes() : context_(ImGui::CreateContext()) {
        ImGui::SetCurrentContext(context_);
        applyTheme(1);
        setTheme(GetParam());
    }
    ~Themes() override { ImGui::DestroyContext(context_); }
    ImVec4 color(int which) { return ImGui::GetStyle().Colors[which]; }

  private:
    ImGuiContext* context_;
};

TEST_P(Themes, TextIsLegibleOnEverythingThatItStandsOn) {
    EXPECT_EQ(theme(), GetParam());
    for (const int back : {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered,
                           ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive, ImGuiCol_Header,
                           ImGuiCol_HeaderHovered, ImGuiCol_MenuBarBg, ImGuiCol_TableHeaderBg})
        EXPECT_GE(contrast(color(ImGuiCol_Text), color(back)), 4.5) << ImGui::GetStyleColorName(back);
    for (const ImU32 fill : {ImU32(kFill), ImU32(kFillHot), ImU32(kFillHeld)})
        EXPECT_GE(contrast(color(ImGuiCol_Text), ImGui::ColorConvertU32ToFloat4(fill)), 3) << "on a slider's fill";
    for (const ImU32 text : {ImU32(kDimText), ImU32(kErrorText), ImU32(kWarningText)})
        EXPECT_GE(contrast(ImGui::ColorConvertU32ToFloat4(text), color(ImGuiCol_WindowBg)), 4.5);
}

INSTANTIATE_TEST_SUITE_P(Both, Themes, testing::Values(Theme::Dark, Theme::Light));

}  // namespace
}  // namespace sward::ui
