// The menu at the pointer: what can be added, and the commands of the menu Object for what is chosen: those that are
// used most at the top and the others in menus of their own.
#include <imgui.h>

#include <algorithm>
#include <string_view>

#include "app/commands.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/keys.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// Which commands stand in a menu of their own; those that no row names stand at the top.
struct Submenu {
    const char* title;
    std::span<const std::string_view> labels;
};
constexpr std::string_view kSight[] = {"Hide or Show", "Show All", "Lock or Unlock", "Unlock All"};
constexpr std::string_view kTools[] = {"Objects or Brush", "Move", "Turn", "Scale", "Path"};
constexpr std::string_view kPaths[] = {"New Path", "End Path", "Flatten Along Path", "Camera Path from Path"};
constexpr std::string_view kScatters[] = {"Add Scatter", "Make Objects of It"};
constexpr Submenu kSubmenus[] = {
    {"Sight and Lock", kSight}, {"Scatter", kScatters}, {"Paths", kPaths}, {"Tool", kTools}};

bool holds(const Submenu& menu, std::string_view label) {
    return std::find(menu.labels.begin(), menu.labels.end(), label) != menu.labels.end();
}

// The command of the menu whose item was chosen, of those that `takes`; else `before`.
template <class Takes>
const Command* items(std::span<const CommandState> states, std::string_view menu, const Command* before,
                     const Takes& takes) {
    for (const CommandState& s : states)
        if (std::string_view(s.command->menu) == menu && takes(s.command->label) &&
            ui::menuItem(s.command->label, chordText(s.chord), s.checked, s.enabled))
            before = s.command;
    return before;
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
        chosen = items(states, "Add", chosen, [](std::string_view) { return true; });
        ui::endMenu();
    }
    ImGui::Separator();
    chosen = items(states, "Object", chosen, [](std::string_view label) {
        return std::none_of(std::begin(kSubmenus), std::end(kSubmenus),
                            [&](const Submenu& menu) { return holds(menu, label); });
    });
    ImGui::Separator();
    for (const Submenu& menu : kSubmenus) {
        if (!ui::beginMenu(menu.title)) continue;
        chosen = items(states, "Object", chosen, [&](std::string_view label) { return holds(menu, label); });
        ui::endMenu();
    }
    ImGui::EndPopup();
    return chosen;
}

}  // namespace sward
