// What the person waits for, in front of everything: how far it is, how long it took, and a button that ends it.
#include "app/waiting.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/time_left.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// A part of the bar that wanders to and fro: work that does not know how far it is.
void wanderingBar(float width, float height, double seconds) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(at, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    const float part = width * 0.25f, way = static_cast<float>(0.5 - 0.5 * std::cos(2 * seconds)) * (width - part);
    draw.AddRectFilled({at.x + way, at.y}, {at.x + way + part, at.y + height},
                       ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    ImGui::Dummy({width, height});
}

void body(Waiting& w) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - w.begun).count();
    const double share = w.slot->progress();
    const float width = ImGui::GetFontSize() * 22, height = ImGui::GetTextLineHeight();
    if (share > 0)
        ImGui::ProgressBar(static_cast<float>(share), {width, height}, "");
    else
        wanderingBar(width, height, seconds);
    const std::string left = share > 0 ? timeLeft(share, seconds) : "";
    const std::string told = w.slot->cancelled() ? "stopping"
                             : share > 0 ? fmt::format("{:.0f} %{}{}", 100 * share, left.empty() ? "" : ", ", left)
                                         : fmt::format("{:.1f} s", seconds);
    ui::record("Progress", ui::Kind::Label, told);
    ui::coloredText(ui::kDimText, told.c_str());
    const ui::Disabled once(w.slot->cancelled());
    if (ui::button("Cancel", ImGui::GetFontSize() * 7) || ui::escapePressed()) cancelWaiting(w);
}

}  // namespace

void drawWaiting(Waiting& w) {
    if (!w.slot && !w.shown) return;
    const std::string title = w.label + "###waiting";
    if (std::exchange(w.opening, false) && w.slot) ImGui::OpenPopup("###waiting");
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    const int flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    w.shown = ImGui::BeginPopupModal(title.c_str(), nullptr, flags);
    if (!w.shown) return;
    if (w.slot)
        body(w);
    else
        ImGui::CloseCurrentPopup();
    w.shown = w.slot != nullptr;
    ImGui::EndPopup();
}

}  // namespace sward
