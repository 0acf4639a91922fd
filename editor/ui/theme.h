// The editor's looks: a dark neutral theme, its font and the few colours that mean something.
// Does not: lay anything out.
#pragma once
#include <imgui.h>

namespace sward::ui {

inline constexpr ImU32 kAccent = IM_COL32(104, 160, 72, 255);
inline constexpr ImU32 kErrorText = IM_COL32(255, 120, 105, 255);
inline constexpr ImU32 kErrorBack = IM_COL32(140, 38, 34, 245);
inline constexpr ImU32 kWarningText = IM_COL32(232, 186, 92, 255);
inline constexpr ImU32 kDimText = IM_COL32(150, 152, 150, 255);

// Font (DejaVu Sans as packaged, else ImGui's own), sharp at `density` pixels a point, and style.
void applyTheme(float density);
// Buttons between these two are shown as chosen.
void pushAccent();
// Ends the last pushAccent.
void popAccent();
// Text in a colour, on the current line.
void coloredText(ImU32 color, const char* text);

}  // namespace sward::ui
