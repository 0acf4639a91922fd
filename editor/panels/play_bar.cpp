// Start, pause and step, in the middle of the menu bar; and the viewport's frame while it is played.
#include "panels/play_bar.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "model/document.h"
#include "panels/panels.h"
#include "playtest/playtest.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

constexpr ImU32 kPlaying = IM_COL32(78, 176, 232, 255), kPaused = IM_COL32(232, 176, 64, 255);

enum class PlayIcon { Play, Stop, Pause, Step };

void drawPlayIcon(PlayIcon icon, ImVec2 c, float r, ImU32 color) {
    ImDrawList& d = *ImGui::GetWindowDrawList();
    const auto bar = [&](float x) {
        d.AddRectFilled({c.x + x - r * 0.22f, c.y - r}, {c.x + x + r * 0.22f, c.y + r}, color);
    };
    const auto arrow = [&](float x) {
        d.AddTriangleFilled({c.x + x - r * 0.8f, c.y - r}, {c.x + x + r, c.y}, {c.x + x - r * 0.8f, c.y + r}, color);
    };
    switch (icon) {
        case PlayIcon::Play:
            return arrow(0);
        case PlayIcon::Stop:
            return d.AddRectFilled({c.x - r * 0.9f, c.y - r * 0.9f}, {c.x + r * 0.9f, c.y + r * 0.9f}, color);
        case PlayIcon::Pause:
            return bar(-r * 0.5f), bar(r * 0.5f);
        case PlayIcon::Step:
            return bar(-r * 0.9f), arrow(r * 0.3f);
    }
}

bool iconButton(const char* label, PlayIcon icon, ImU32 color, const char* help, bool enabled) {
    const ui::Disabled off(!enabled);
    const float height = ImGui::GetFrameHeight() - 4;
    ImGui::SetCursorPosY(2);
    const bool pressed = ImGui::Button((std::string("##") + label).c_str(), {height * 1.7f, height});
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ui::record(label, ui::Kind::Button);
    ui::tooltip(help);
    drawPlayIcon(icon, {(low.x + high.x) / 2, (low.y + high.y) / 2}, height * 0.28f,
                 enabled ? color : ImGui::GetColorU32(ImGuiCol_TextDisabled));
    return pressed;
}

void outlined(ImVec2 at, ImU32 color, const std::string& text) {
    ImDrawList& d = *ImGui::GetWindowDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    d.AddRectFilled({at.x - 7, at.y - 4}, {at.x + size.x + 7, at.y + size.y + 4}, IM_COL32(18, 20, 22, 205), 4);
    d.AddText(at, color, text.c_str());
}

}  // namespace

PlayAction drawPlayBar(const Document& doc) {
    if (!ImGui::Begin("##MainMenuBar") || !ImGui::BeginMenuBar()) {  // goes on in the menus' row
        ImGui::End();
        return PlayAction::None;
    }
    PlayAction action = PlayAction::None;
    const Playtest* play = doc.play();
    const float width = (ImGui::GetFrameHeight() - 4) * 1.7f * 3 + 2 * ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX() + 12, (ImGui::GetWindowWidth() - width) / 2));
    const ImU32 plain = ImGui::GetColorU32(ImGuiCol_Text);
    if (iconButton("Start", play ? PlayIcon::Stop : PlayIcon::Play, play ? ui::kErrorText : IM_COL32(120, 200, 90, 255),
                   play ? "Stops: everything is as it was before (F5)." : "Walks through the project from here (F5).",
                   doc.isOpen()))
        action = PlayAction::Toggle;
    if (iconButton("Pause", play && play->paused() ? PlayIcon::Play : PlayIcon::Pause,
                   play && play->paused() ? kPaused : plain, play && play->paused() ? "Goes on (F6)." : "Pauses (F6).",
                   play))
        action = PlayAction::Pause;
    if (iconButton("Step", PlayIcon::Step, plain, "One step of 1/60 s (F11).", play)) action = PlayAction::Step;
    ui::record("State", ui::Kind::Label, !play ? "stopped" : play->paused() ? "paused" : "playing");
    ImGui::EndMenuBar();
    ImGui::End();
    return action;
}

void drawPlayFrame(const Document& doc, bool captured, const Rect& r) {
    const Playtest* play = doc.play();
    if (!play) return;
    const ImU32 color = play->paused() ? kPaused : kPlaying;
    ImGui::GetWindowDrawList()->AddRect({r.x + 1.5f, r.y + 1.5f}, {r.x + r.w - 1.5f, r.y + r.h - 1.5f}, color, 0, 0, 3);
    outlined({r.x + 18, r.y + 14}, color,
             fmt::format("{}   {:.2f} s", play->paused() ? "PAUSED" : "PLAYING", play->time()));
    ui::recordAt("Viewport/Playing",
                 {ui::Kind::Area, r.x, r.y, r.x + r.w, r.y + r.h, fmt::format("{:.2f}", play->time())});
    const std::string keys =
        captured ? "W A S D walk    Shift run    Space jump    Esc frees the mouse    F6 pause    F11 step    F5 stop"
        : play->paused() ? "F6 goes on    F11 one step    F5 stop"
        : !play->runs()  ? "A script takes the steps    F11 one step    F5 stop"
                         : "Click to walk and look    F6 pause    F11 step    F5 stop";
    const ImVec2 size = ImGui::CalcTextSize(keys.c_str());
    outlined({r.x + (r.w - size.x) / 2, r.y + r.h - size.y - 16}, IM_COL32(235, 236, 235, 255), keys);
}

}  // namespace sward
