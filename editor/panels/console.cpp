// The log, and a line that runs a script command.
#include <imgui.h>

#include "app/console.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

void lines(const LogBook& log) {
    for (const LogLine& line : log.lines) {
        const ImU32 color = line.level == LogLevel::Error     ? ui::kErrorText
                            : line.level == LogLevel::Warning ? ui::kWarningText
                                                              : ImGui::GetColorU32(ImGuiCol_Text);
        ImGui::PushTextWrapPos(0);
        ui::coloredText(color, line.text.c_str());
        ImGui::PopTextWrapPos();
    }
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1);
}

void enter(Console& console) {
    const std::string line = console.line;
    if (line.empty()) return;
    console.line.clear();
    console.recalled = 0;
    if (console.history.empty() || console.history.back() != line) console.history.push_back(line);
    logInfo("> " + line);
    console.luaLines.push_back(line);
}

}  // namespace

void drawConsole(Console& console, bool inputWaits) {
    const float inputHeight = console.runLua ? ImGui::GetFrameHeightWithSpacing() : 0;
    ImGui::BeginChild("log", {0, -inputHeight});
    lines(console.log);
    ImGui::EndChild();
    ui::record("Log", ui::Kind::Area, console.log.lines.empty() ? "" : console.log.lines.back().text);
    if (!console.runLua) return;
    ImGui::SetNextItemWidth(-1);
    bool entered = false;
    ui::input("Command", console.line, "a line of Lua, such as  map.mean(\"density\");  help()  lists all", &entered,
              {[&](const std::string& text, int step) { return recall(console, text, step); },
               [&](const std::string& text) { return completed(console, text); }});
    if (!entered) return;
    enter(console);
    if (!inputWaits) ui::focusLast();  // else a click that waits would lose to it
}

}  // namespace sward
