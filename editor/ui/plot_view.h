// A plot of the engine (cost/plot.h) drawn into the present window, in the theme's font.
// Does not: lay it out, nor take input.
#pragma once
#include <imgui.h>

#include <string>

#include "cost/plot.h"

namespace sward::ui {

// Its upper left corner at `at`; without its background.
void drawPlot(const Plot& plot, ImVec2 at);
// "#rrggbb" of a colour as it looks on the window's background.
std::string hexOf(ImU32 color);
// The colour that "#rrggbb" names; black if it is none.
ImU32 colorOf(const std::string& hex);

}  // namespace sward::ui
