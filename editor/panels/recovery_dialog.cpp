// Offers the copy of unsaved work that a run left which did not end in order.
#include <fmt/chrono.h>
#include <imgui.h>
#include <sys/stat.h>

#include <memory>

#include "app/edits.h"
#include "app/messages.h"
#include "app/waiting.h"
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

struct Recovery {
    Autosave& autosave;
    Document& doc;
    Messages& messages;
    Waiting& waiting;
    std::vector<std::filesystem::path> copies;  // the newest first
};

// From the newest copy that can be read; `at`: those before it cannot, as `first` says.
void recoverFrom(const std::shared_ptr<const Recovery>& r, size_t at, const Status& first) {
    const std::filesystem::path copy = r->copies[at];
    const auto take = [r](Project& p) { return r->doc.takeOver(p, "recover unsaved work"); };
    readBeside(r->waiting, r->doc, copy, take, [r, at, first, copy](const Status& taken) {
        const Status& told = first ? taken : first;
        if (!taken && at + 1 < r->copies.size()) return recoverFrom(r, at + 1, told);
        if (!taken) return showError(r->messages, told.error());
        adoptAutosave(r->autosave, copy);
        if (!first) logWarning(first.error().text());
        say(r->messages, first ? "unsaved work is back; undo shows what was saved"
                               : "the newest copy is damaged: unsaved work of an older one is back");
    });
}

}  // namespace

bool drawRecoveryDialog(Autosave& a, Document& doc, Edits& edits, Messages& messages, Waiting& waiting) {
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
        const auto recovery = std::make_shared<const Recovery>(Recovery{a, doc, messages, waiting, a.found});
        edits.deferred.push_back([recovery] { recoverFrom(recovery, 0, Status()); });
        close(a);
    } else if (thrown || later) {
        if (thrown) forgetAutosaves(a.of);
        close(a);
    }
    ImGui::EndPopup();
    return false;
}

}  // namespace sward
