// The log, and a line that runs a script command.
#include <imgui.h>

#include "panels/panels.h"
#include "ui/theme.h"

namespace sward {
namespace {

void lines(EditorApp& app) {
    for (const LogLine& line : app.log.lines) {
        const ImU32 color = line.level == LogLevel::Error     ? ui::kErrorText
                            : line.level == LogLevel::Warning ? ui::kWarningText
                                                              : ImGui::GetColorU32(ImGuiCol_Text);
        ImGui::PushTextWrapPos(0);
        ui::coloredText(color, line.text.c_str());
        ImGui::PopTextWrapPos();
    }
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1);
}

void run(EditorApp& app) {
    const std::string line = app.consoleLine;
    if (line.empty()) return;
    app.consoleLine.clear();
    app.consoleHistory.push_back(line);
    logInfo("> " + line);
    app.luaLines.push_back(line);
}

}  // namespace

void drawConsole(EditorApp& app) {
    const float inputHeight = app.runLua ? ImGui::GetFrameHeightWithSpacing() : 0;
    ImGui::BeginChild("log", {0, -inputHeight});
    lines(app);
    ImGui::EndChild();
    ui::record("Log", ui::Kind::Area, app.log.lines.empty() ? "" : app.log.lines.back().text);
    if (!app.runLua) return;
    ImGui::SetNextItemWidth(-1);
    bool entered = false;
    ui::input("Command", app.consoleLine, "a line of Lua, such as  map.mean(\"density\")", &entered);
    if (!entered) return;
    run(app);
    if (!app.queue.pending()) ImGui::SetKeyboardFocusHere(-1);  // else a click that waits would lose to it
}

}  // namespace sward
