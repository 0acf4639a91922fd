// The menu at the pointer: what can be added, and the commands of the menu Object for what is chosen.
#include <imgui.h>

#include "app/commands.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/keys.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// The command of this menu whose item was chosen, or null.
const Command* items(std::span<const CommandState> states, const std::string& menu) {
    const Command* chosen = nullptr;
    for (const CommandState& state : states) {
        const Command& c = *state.command;
        if (menu == c.menu && ui::menuItem(c.label, chordText(state.chord), state.checked, state.enabled)) chosen = &c;
    }
    return chosen;
}

}  // namespace

const Command* drawContextMenu(std::span<const CommandState> states, const std::string& title, bool& opening) {
    if (std::exchange(opening, false)) ImGui::OpenPopup("Context");
    if (!ImGui::BeginPopup("Context")) return nullptr;
    if (ui::escapePressed()) ImGui::CloseCurrentPopup();
    ImGui::TextDisabled("%s", title.empty() ? "nothing is chosen" : title.c_str());
    ImGui::Separator();
    const Command* chosen = nullptr;
    if (ui::beginMenu("Add")) {
        chosen = items(states, "Add");
        ui::endMenu();
    }
    ImGui::Separator();
    if (const Command* c = items(states, "Object")) chosen = c;
    ImGui::EndPopup();
    return chosen;
}

}  // namespace sward
