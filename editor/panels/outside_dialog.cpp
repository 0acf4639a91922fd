// Asks what to do where another program changed the open project's files.
#include <fmt/format.h>
#include <imgui.h>

#include "app/edits.h"
#include "app/file_tasks.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

constexpr size_t kMostNamed = 6;

std::string namesOf(const OutsideDialog& d) {
    std::string names;
    size_t n = 0;
    for (const auto& [name, stamp] : d.files) {
        if (++n > kMostNamed) return names + fmt::format("... and {} more", d.files.size() - kMostNamed);
        names += name + "\n";
    }
    return names;
}

}  // namespace

void drawOutsideDialog(const SaveParts& parts, UnsavedDialog& unsaved, Edits& edits) {
    OutsideDialog& d = parts.outside;
    Document& doc = parts.doc;
    if (d.files.empty() || !doc.isOpen()) return;
    if (std::exchange(d.opening, false)) ImGui::OpenPopup("Changed on disk");
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    const int flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    if (!ImGui::BeginPopupModal("Changed on disk", nullptr, flags)) return;
    const float width = ImGui::GetFontSize() * 9;
    ImGui::Text("Another program changed %s since it was opened here:", doc.project().name.c_str());
    ImGui::TextDisabled("%s", namesOf(d).c_str());
    if (!d.error.empty()) {
        ImGui::PushTextWrapPos(4 * width);
        ui::coloredText(ui::kErrorText, d.error.c_str());
        ImGui::PopTextWrapPos();
        ui::record("Error", ui::Kind::Label, d.error);
    }
    const bool theirs = ui::button("Take theirs", width);
    ui::tooltip("What is on disk takes the place of what is open here; undo brings that back.");
    ImGui::SameLine(0, 8);
    const bool mine = ui::button(d.saving ? "Save mine over it" : "Keep mine", width);
    ui::tooltip("What is open here counts; saving replaces what is on disk.");
    ImGui::SameLine(0, 8);
    const bool copy = ui::button("Save mine elsewhere...", width, true);
    ui::tooltip("Both stay: what is open here goes into another folder.");
    ImGui::SameLine(0, 8);
    const bool cancelled = ui::button(d.saving ? "Cancel" : "Later", width) || ui::escapePressed();
    if (theirs)
        edits.deferred.push_back([parts] {
            takeTheirs(parts.outside, parts.doc, parts.waiting, [&messages = parts.messages] {
                say(messages, "what was on disk is open now; undo brings back what was here");
            });
        });
    if (mine)
        edits.deferred.push_back([parts, saves = d.saving] {
            keepOwn(parts.outside);
            if (saves) saveNow(parts);
        });
    if (copy)
        edits.deferred.push_back([parts, &unsaved] {
            keepOwn(parts.outside);
            requestTask(parts.files, unsaved, parts.doc, FileTask::SaveAs);
        });
    if (cancelled) d.files.clear();
    if (d.files.empty() || mine || copy) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace sward
