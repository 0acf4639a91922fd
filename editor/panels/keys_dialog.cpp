// All keys: those of commands, which may be bound otherwise here, and what the mouse does.
#include <imgui.h>

#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/bindings.h"
#include "app/commands.h"
#include "app/palette.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/input_queue.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// What no command does.
struct HandRow {
    const char *keys, *does;
};
constexpr HandRow kHand[] = {
    {"Right button", "look; with W A S D, E and Q fly; Shift faster, the wheel sets the speed"},
    {"Alt + left button", "orbit"},
    {"Middle button", "pan"},
    {"Wheel", "nearer, farther"},
    {"Left button, with a brush", "paint; Ctrl inverts, Shift smooths, Ctrl+Shift erases every species"},
    {"Alt + Shift + left button", "a straight stroke on from where the last one ended"},
    {"Left button, without a brush", "choose; drag for a box; Shift adds, Ctrl toggles"},
    {"Ctrl, while a handle is dragged", "snap to grid and angles; Escape lets go"},
    {"Double click on a number", "type it"},
};

// The keys that went down, as a chord; those of the dialog itself bind nothing.
void take(KeysDialog& d, Bindings& bindings, const Command& c, const FrameInput& in, bool& changed) {
    for (const int key : in.pressedKeys) {
        if (isModifierKey(key)) continue;
        d.waiting.clear();
        d.error.clear();
        if (key == GLFW_KEY_ESCAPE) return;
        const bool none = key == GLFW_KEY_BACKSPACE && !in.ctrl() && !in.shift() && !in.alt();
        const std::string chord = none ? "" : chordName({key, in.ctrl(), in.shift(), in.alt()});
        const Status bound = none || !chord.empty() ? bindKey(bindings, c, chord) : failed("that key has no name here");
        if (!bound) d.error = bound.error().text();
        changed |= static_cast<bool>(bound);
        return;
    }
}

void commandRow(KeysDialog& d, Bindings& bindings, const Command& c, const FrameInput& in, bool& changed) {
    const std::string name = commandName(c);
    const ui::Scope scope(name);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s \xE2\x80\xBA %s", c.menu, c.label);
    ImGui::TableNextColumn();
    const std::string chord = chordText(chordOf(bindings, c));
    ImGui::PushID(name.c_str());
    const bool waits = d.waiting == name;
    if (ui::button("Bind", 0, waits)) d.waiting = waits ? "" : name;
    ui::tooltip("then press the new keys; Backspace takes them away, Escape leaves them");
    ImGui::SameLine(0, 8);
    ImGui::TextUnformatted(waits ? "press keys..." : chord.c_str());
    ui::record("Keys", ui::Kind::Label, chord);
    ImGui::TableNextColumn();
    if (bindings.own.contains(name) && ui::button("Reset")) {
        const Status back = unbindKey(bindings, c);
        d.error = back ? "" : back.error().text();
        changed |= static_cast<bool>(back);
    }
    ImGui::PopID();
    if (waits) take(d, bindings, c, in, changed);
}

void handRow(const HandRow& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.keys);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.does);
}

bool rows(KeysDialog& d, Bindings& bindings, const FrameInput& in) {
    bool changed = false;
    const float em = ImGui::GetFontSize();
    if (ImGui::BeginTable("commands", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
        for (const Command& c : commands())
            if (paletteMatch(d.search, commandName(c) + " " + chordText(chordOf(bindings, c))))
                commandRow(d, bindings, c, in, changed);
        ImGui::EndTable();
    }
    ImGui::Spacing();
    if (ImGui::BeginTable("hand", 2, ImGuiTableFlags_RowBg)) {
        ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, em * 15);
        for (const HandRow& row : kHand)
            if (paletteMatch(d.search, std::string(row.keys) + " " + row.does)) handRow(row);
        ImGui::EndTable();
    }
    return changed;
}

}  // namespace

bool drawKeysDialog(KeysDialog& d, Bindings& bindings, const FrameInput& in) {
    if (!d.open) return false;
    const bool opening = std::exchange(d.opening, false);
    if (opening) ImGui::OpenPopup("Keys");
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(em * 46, screen.x - 16), std::min(em * 44, screen.y - 16)});
    const int flags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;
    if (!ImGui::BeginPopupModal("Keys", &d.open, flags)) return false;
    const bool waited = !d.waiting.empty();
    ImGui::SetNextItemWidth(-ImGui::CalcTextSize("Close").x - 3 * ImGui::GetStyle().FramePadding.x - 8);
    if (opening) ui::focusNext();
    ui::input("Search", d.search, "search a command or a key");
    ImGui::SameLine(0, 8);
    if (ui::button("Close") || (ui::escapePressed() && !opening && !waited)) d.open = false;
    if (!d.error.empty()) {
        ImGui::PushTextWrapPos(0);
        ui::coloredText(ui::kErrorText, d.error.c_str());
        ImGui::PopTextWrapPos();
        ui::record("Error", ui::Kind::Label, d.error);
    }
    ImGui::BeginChild("rows");
    const bool changed = rows(d, bindings, in);
    ImGui::EndChild();
    if (!d.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return changed;
}

}  // namespace sward
