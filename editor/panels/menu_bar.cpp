// The menu bar: commands by menu, then what the View menu lists from tables.
#include <imgui.h>

#include "app/commands.h"
#include "panels/panels.h"
#include "ui/keys.h"

namespace sward {
namespace {

std::string capitalized(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

void viewItems(EditorApp& app) {
    ImGui::Separator();
    for (int i = 0; i < static_cast<int>(std::size(kViewModes)); ++i)
        if (ui::menuItem(capitalized(kViewModes[i]), "", static_cast<int>(app.viewport.mode) == i))
            app.viewport.mode = static_cast<ViewMode>(i);
    ImGui::Separator();
    for (const PanelRow& row : panelRows()) {
        if (!row.hideable) continue;
        const bool shown = !app.layout.hidden.count(row.name);
        if (!ui::menuItem(row.menu ? row.menu : row.name, "", shown)) continue;
        if (shown)
            app.layout.hidden.insert(row.name);
        else
            app.layout.hidden.erase(row.name);
        if (!shown && row.dock == Dock::Bottom) app.layout.tab = row.name;
    }
}

void drawMenu(EditorApp& app, const std::string& menu) {
    if (!ui::beginMenu(menu)) return;
    for (const Command& c : commands()) {
        if (menu != c.menu) continue;
        const std::string label = c.label;
        if (ui::menuItem(label, chordText(c.chord), c.checked && c.checked(app),
                         c.enabled(app) && (c.inPlay || !playing(app))))
            app.deferred.push_back([&app, &c] { c.run(app); });
        if (label == "Undo" && app.doc.canUndo()) ui::tooltip("takes back: " + app.doc.undoLabel());
        if (label == "Redo" && app.doc.canRedo()) ui::tooltip("does again: " + app.doc.redoLabel());
    }
    if (menu == "View") viewItems(app);
    ui::endMenu();
}

}  // namespace

void drawMenuBar(EditorApp& app) {
    if (!ImGui::BeginMainMenuBar()) return;
    const char* last = "";
    for (const Command& c : commands()) {
        if (std::string(last) == c.menu) continue;
        last = c.menu;
        drawMenu(app, c.menu);
    }
    ImGui::EndMainMenuBar();
}

}  // namespace sward
