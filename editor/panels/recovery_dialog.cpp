// Offers the copy of unsaved work that a run left which did not end in order.
#include <fmt/chrono.h>
#include <imgui.h>
#include <sys/stat.h>

#include "app/edits.h"
#include "app/messages.h"
#include "core/log.h"
#include "model/autosave.h"
#include "model/document.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

constexpr int kFirstFrame = 4;  // Dear ImGui's: a modal before the other windows are there stops it

// "21 November, 18:04"
std::string timeOf(const std::filesystem::path& file) {
    struct stat about {};
    if (stat(file.c_str(), &about) != 0) return "an unknown time";
    return fmt::format("{:%d %B, %H:%M}", fmt::localtime(about.st_mtime));
}

void close(Autosave& autosave) {
    autosave.found.clear();
    ImGui::CloseCurrentPopup();
}

// From the newest copy that can be read.
void recover(Autosave& autosave, Document& doc, Edits& edits, Messages& messages) {
    edits.deferred.push_back([&, copies = autosave.found] {
        Status first;
        for (const std::filesystem::path& copy : copies) {
            const Status taken = doc.takeOver(copy, "recover unsaved work");
            if (!taken) {
                if (first) first = taken;
                continue;
            }
            adoptAutosave(autosave, copy);
            if (!first) logWarning(first.error().text());
            return say(messages, first ? "unsaved work is back; undo shows what was saved"
                                       : "the newest copy is damaged: unsaved work of an older one is back");
        }
        if (!first) showError(messages, first.error());
    });
    close(autosave);
}

}  // namespace

bool drawRecoveryDialog(Autosave& a, Document& doc, Edits& edits, Messages& messages) {
    if (a.found.empty() || !doc.isOpen()) return false;
    if (a.opening && ImGui::GetFrameCount() < kFirstFrame) return true;
    if (std::exchange(a.opening, false)) ImGui::OpenPopup("Recovery");
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    const int flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    if (!ImGui::BeginPopupModal("Recovery", nullptr, flags)) return false;
    const float width = ImGui::GetFontSize() * 8;
    ImGui::Spacing();
    ImGui::Text("%s was left without being saved.", doc.project().name.c_str());
    ImGui::Text("A copy of the work from %s is there.", timeOf(a.found.front()).c_str());
    ImGui::Dummy({3 * width + 16, 4});
    const bool taken = ui::button("Recover", width, true);
    ui::tooltip("Takes the copy over the saved project; undo goes back. Nothing is saved yet.");
    ImGui::SameLine(0, 8);
    const bool thrown = ui::button("Throw away", width);
    ImGui::SameLine(0, 8);
    const bool later = ui::button("Ask again later", width) || ui::escapePressed();
    if (taken) {
        recover(a, doc, edits, messages);
    } else if (thrown || later) {
        if (thrown) forgetAutosaves(a.of);
        close(a);
    }
    ImGui::EndPopup();
    return false;
}

}  // namespace sward
