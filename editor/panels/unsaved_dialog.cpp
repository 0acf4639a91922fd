// Asks what to do with unsaved work before it would be lost.
#include <imgui.h>

#include <functional>

#include "app/edits.h"
#include "app/file_tasks.h"
#include "core/log.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// The answer is given: the question closes, and what waited for it runs after this frame's widgets.
void answer(UnsavedDialog& d, Edits& edits, bool goOn) {
    const std::function<void()> then = std::exchange(d.then, nullptr);
    if (goOn && then) edits.deferred.push_back(then);
    ImGui::CloseCurrentPopup();
}

// The question closes while it is saved, and is back if that fails.
void save(UnsavedDialog& d, Document& doc, const OutsideDialog& outside, Edits& edits, Waiting& waiting) {
    if (othersOnDisk(outside, doc)) {
        d.error = "Another program changed the project on disk: cancel, then save, to choose whose counts.";
        return;
    }
    const auto saved = [&d, then = std::exchange(d.then, nullptr)](const Result<std::vector<std::string>>& written) {
        if (written) return then();
        d.then = then;
        d.opening = true;
        d.error = written.error().text();
        logWarning(d.error);
    };
    edits.deferred.push_back([&doc, &waiting, saved] { saveBeside(waiting, doc, {}, saved); });
    ImGui::CloseCurrentPopup();
}

}  // namespace

void drawUnsavedDialog(UnsavedDialog& d, Document& doc, const OutsideDialog& outside, Edits& edits, Waiting& waiting) {
    if (!d.then) return;
    if (std::exchange(d.opening, false)) ImGui::OpenPopup("Unsaved work");
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    const int flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    if (!ImGui::BeginPopupModal("Unsaved work", nullptr, flags)) return;
    const float width = ImGui::GetFontSize() * 7;
    ImGui::Spacing();
    ImGui::Text("%s has changes that are not saved.", doc.project().name.c_str());
    ImGui::Dummy({3 * width + 16, 4});
    if (!d.error.empty()) {
        ImGui::PushTextWrapPos(3 * width + 16);
        ui::coloredText(ui::kErrorText, d.error.c_str());
        ImGui::PopTextWrapPos();
        ui::record("Error", ui::Kind::Label, d.error);
    }
    const bool saved = ui::button("Save", width, true);
    ImGui::SameLine(0, 8);
    const bool discarded = ui::button("Discard", width);
    ImGui::SameLine(0, 8);
    const bool cancelled = ui::button("Cancel", width) || ui::escapePressed();
    if (saved)
        save(d, doc, outside, edits, waiting);
    else if (discarded || cancelled)
        answer(d, edits, discarded);
    ImGui::EndPopup();
}

}  // namespace sward
