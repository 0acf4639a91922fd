// The editor's looks: two neutral themes, dark and light, their font and the few colours that mean something.
// Does not: lay anything out.
#pragma once
#include <imgui.h>

namespace sward::ui {

enum class Theme { Dark, Light };
// That of the current ImGui context.
Theme theme();

// A colour that follows the theme. What lies over the picture takes the dark one's: the picture has no theme.
struct ThemeColor {
    ImU32 dark, light;
    operator ImU32() const { return theme() == Theme::Light ? light : dark; }
};
inline constexpr ThemeColor kAccent{IM_COL32(104, 160, 72, 255), IM_COL32(60, 112, 34, 255)};
inline constexpr ThemeColor kErrorText{IM_COL32(255, 120, 105, 255), IM_COL32(176, 32, 22, 255)};
inline constexpr ThemeColor kErrorBack{IM_COL32(140, 38, 34, 245), IM_COL32(252, 214, 208, 250)};
inline constexpr ThemeColor kWarningText{IM_COL32(232, 186, 92, 255), IM_COL32(134, 86, 0, 255)};
inline constexpr ThemeColor kDimText{IM_COL32(150, 152, 150, 255), IM_COL32(92, 95, 92, 255)};
// Lines of plots and the like, from strong to faint.
inline constexpr ThemeColor kStrongLine{IM_COL32(255, 255, 255, 255), IM_COL32(20, 22, 20, 255)};
inline constexpr ThemeColor kLine{IM_COL32(255, 255, 255, 130), IM_COL32(0, 0, 0, 140)};
inline constexpr ThemeColor kFaintLine{IM_COL32(255, 255, 255, 30), IM_COL32(0, 0, 0, 34)};
// The filled part of a number's slider.
inline constexpr ThemeColor kFill{IM_COL32(66, 102, 46, 255), IM_COL32(176, 212, 152, 255)};
inline constexpr ThemeColor kFillHot{IM_COL32(78, 120, 54, 255), IM_COL32(160, 202, 132, 255)};
inline constexpr ThemeColor kFillHeld{IM_COL32(86, 134, 58, 255), IM_COL32(142, 190, 112, 255)};

// Font (DejaVu Sans as packaged, else ImGui's own), sharp at `density` pixels a point, and style.
void applyTheme(float density, Theme theme = Theme::Dark);
// The colours alone, of the next frame's widgets; nothing if they are these.
void setTheme(Theme theme);
// Buttons between these two are shown as chosen.
void pushAccent();
// Ends the last pushAccent.
void popAccent();
// Text in a colour, on the current line.
void coloredText(ImU32 color, const char* text);

}  // namespace sward::ui
