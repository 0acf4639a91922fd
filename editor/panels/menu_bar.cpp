// The menu bar: commands by menu, then what the View menu lists from tables.
#include <imgui.h>

#include <cctype>

#include "app/commands.h"
#include "app/layout.h"
#include "app/viewport.h"
#include "model/document.h"
#include "panels/panels.h"
#include "ui/keys.h"
#include "ui/widgets.h"
#include "ui/words.h"

namespace sward {
namespace {

std::string capitalized(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

void themeItems(bool& light) {
    if (!ui::beginMenu("Theme")) return;
    if (ui::menuItem("Dark", "", !light)) light = false;
    if (ui::menuItem("Light", "", light)) light = true;
    ui::endMenu();
}

void viewItems(ViewMode& mode, Layout& layout) {
    themeItems(layout.lightTheme);
    ImGui::Separator();
    for (int i = 0; i < static_cast<int>(std::size(kViewModes)); ++i)
        if (ui::menuItem(capitalized(kViewModes[i]), "", static_cast<int>(mode) == i)) mode = static_cast<ViewMode>(i);
    ImGui::Separator();
    for (const PanelRow& row : panelRows()) {
        if (!row.hideable) continue;
        const bool shown = !layout.hidden.count(row.name);
        if (!ui::menuItem(row.menu ? row.menu : row.name, "", shown)) continue;
        if (shown)
            layout.hidden.insert(row.name);
        else
            layout.hidden.erase(row.name);
        if (!shown && row.dock == Dock::Bottom) layout.tab = row.name;
    }
}

// The command whose item was chosen, or null.
const Command* commandItems(const std::string& menu, const Document& doc, std::span<const CommandState> states) {
    const Command* chosen = nullptr;
    for (const CommandState& state : states) {
        const Command& c = *state.command;
        if (menu != c.menu) continue;
        const std::string label = c.label;
        if (ui::menuItem(label, chordText(state.chord), state.checked, state.enabled)) chosen = &c;
        if (label == "Undo" && doc.canUndo()) ui::tooltip("takes back: " + ui::inWords(doc.undoLabel()));
        if (label == "Redo" && doc.canRedo()) ui::tooltip("does again: " + ui::inWords(doc.redoLabel()));
    }
    return chosen;
}

}  // namespace

const Command* drawMenuBar(const Document& doc, std::span<const CommandState> states, ViewMode& mode, Layout& layout) {
    if (!ImGui::BeginMainMenuBar()) return nullptr;
    const Command* chosen = nullptr;
    std::string last;
    for (const CommandState& state : states) {
        if (last == state.command->menu) continue;
        last = state.command->menu;
        if (!ui::beginMenu(last)) continue;
        if (const Command* c = commandItems(last, doc, states)) chosen = c;
        if (last == "View") viewItems(mode, layout);
        ui::endMenu();
    }
    ImGui::EndMainMenuBar();
    return chosen;
}

}  // namespace sward
