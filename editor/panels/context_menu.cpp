// The menu of the chosen entities, at the pointer: the commands of the menu Object.
#include <imgui.h>

#include "app/commands.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/keys.h"
#include "ui/widgets.h"

namespace sward {

const Command* drawContextMenu(std::span<const CommandState> states, const std::string& title, bool& opening) {
    if (std::exchange(opening, false)) ImGui::OpenPopup("Context");
    if (!ImGui::BeginPopup("Context")) return nullptr;
    if (ui::escapePressed()) ImGui::CloseCurrentPopup();
    ImGui::TextDisabled("%s", title.empty() ? "nothing is chosen" : title.c_str());
    ImGui::Separator();
    const Command* chosen = nullptr;
    for (const CommandState& state : states) {
        const Command& c = *state.command;
        if (std::string(c.menu) == "Object" &&
            ui::menuItem(c.label, chordText(state.chord), state.checked, state.enabled))
            chosen = &c;
    }
    ImGui::EndPopup();
    return chosen;
}

}  // namespace sward
