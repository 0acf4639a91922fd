// The command palette: a line to search in, and what matches below it.
#include "app/palette.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "app/commands.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/input_queue.h"
#include "ui/keys.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

constexpr int kLinesInSight = 12;

// Arrows move the choice, which stays within the lines.
void move(Palette& palette, const FrameInput& in, int lines) {
    for (const int key : in.pressedKeys) palette.chosen += (key == GLFW_KEY_DOWN) - (key == GLFW_KEY_UP);
    palette.chosen = std::clamp(palette.chosen, 0, std::max(0, lines - 1));
}

// True if it was clicked.
bool lineOf(const PaletteLine& line, bool chosen) {
    const bool clicked = ui::selectable(line.label, chosen);
    const std::string what = line.state ? chordText(line.state->chord) : "go there";
    ImGui::SameLine(std::max(0.f, ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(what.c_str()).x - 4));
    ui::coloredText(ui::kDimText, what.c_str());
    return clicked;
}

std::optional<PaletteLine> list(Palette& palette, const std::vector<PaletteLine>& lines, bool follow) {
    std::optional<PaletteLine> clicked;
    const float height = ImGui::GetTextLineHeightWithSpacing() * kLinesInSight;
    ImGui::BeginChild("lines", {0, height});
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lines.size()));
    if (follow)
        ImGui::SetScrollY(ImGui::GetTextLineHeightWithSpacing() *
                          static_cast<float>(std::max(0, palette.chosen - kLinesInSight + 2)));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            if (lineOf(lines[static_cast<size_t>(i)], i == palette.chosen)) clicked = lines[static_cast<size_t>(i)];
    if (lines.empty()) ImGui::TextDisabled("nothing is called so");
    ImGui::EndChild();
    return clicked;
}

}  // namespace

std::optional<PaletteLine> drawPalette(Palette& palette, std::span<const CommandState> states,
                                       const std::vector<std::string>& entities, const FrameInput& in) {
    const bool opening = std::exchange(palette.opening, false);
    if (opening) ImGui::OpenPopup("Palette");
    const float width = std::min(ImGui::GetFontSize() * 34, ImGui::GetIO().DisplaySize.x - 16);
    ImGui::SetNextWindowPos({ImGui::GetIO().DisplaySize.x / 2, ImGui::GetFrameHeight() + 8}, ImGuiCond_Always,
                            {0.5f, 0});
    ImGui::SetNextWindowSize({width, 0});
    palette.open = ImGui::BeginPopup("Palette");
    if (!palette.open) return {};
    if (opening) ui::focusNext();
    ImGui::SetNextItemWidth(-1);
    bool entered = false;
    const std::string before = palette.text;
    ui::input("Search", palette.text, "a command, or the name of an object", &entered);
    if (palette.text != before) palette.chosen = 0;
    const std::vector<PaletteLine> lines = paletteLines(palette.text, states, entities);
    const int was = palette.chosen;
    move(palette, in, static_cast<int>(lines.size()));
    std::optional<PaletteLine> chosen = list(palette, lines, palette.chosen != was);
    if (entered && !lines.empty()) chosen = lines[static_cast<size_t>(palette.chosen)];
    if (chosen || (ui::escapePressed() && !opening)) {
        ImGui::CloseCurrentPopup();
        palette.open = false;
    }
    ImGui::EndPopup();
    return chosen;
}

}  // namespace sward
