// Asks for an entity's new name. Fields that name the entity follow (model/entity_edits.h).
#include <imgui.h>

#include "app/edits.h"
#include "app/object_actions.h"
#include "model/entity_edits.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// Stays open with what is wrong.
void rename(RenameDialog& d, Document& doc, Edits& edits, const std::function<void(const std::string&)>& renamed) {
    edits.deferred.push_back([&d, &doc, renamed] {
        const Status done = renameEntity(doc, d.entity, d.name);
        d.error = done ? "" : done.error().text();
        if (!done) return;
        renamed(d.name);
        d.entity.clear();
    });
}

}  // namespace

void drawRenameDialog(RenameDialog& d, Document& doc, Edits& edits,
                      const std::function<void(const std::string& name)>& renamed) {
    const bool opening = std::exchange(d.opening, false);
    if (opening) ImGui::OpenPopup("Rename");
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    const int flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    if (!ImGui::BeginPopupModal("Rename", nullptr, flags)) return;
    if (d.entity.empty()) {
        ImGui::CloseCurrentPopup();
        return ImGui::EndPopup();
    }
    const float width = ImGui::GetFontSize() * 8;
    ImGui::Text("A new name for %s: letters, digits, '_' and '-'.", d.entity.c_str());
    ImGui::SetNextItemWidth(2 * width + 8);
    if (opening) ui::focusNext();
    bool entered = false;
    ui::input("Name", d.name, "name", &entered);
    if (!d.error.empty()) {
        ImGui::PushTextWrapPos(3 * width);
        ui::coloredText(ui::kErrorText, d.error.c_str());
        ImGui::PopTextWrapPos();
        ui::record("Error", ui::Kind::Label, d.error);
    }
    ImGui::SetCursorPosX(std::max(ImGui::GetWindowContentRegionMax().x - 2 * width - 8, 0.f));
    const bool cancelled = ui::button("Cancel", width) || (ui::escapePressed() && !opening);
    ImGui::SameLine(0, 8);
    if (ui::button("Rename", width, true) || entered) rename(d, doc, edits, renamed);
    if (cancelled) d.entity.clear();
    ImGui::EndPopup();
}

}  // namespace sward
