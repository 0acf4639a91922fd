// Asks what to do with unsaved work before it would be lost.
#include <imgui.h>

#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"

namespace sward {
namespace {

// The answer is given: the question closes, and what waited for it runs after this frame's widgets.
void answer(EditorApp& app, bool goOn) {
    const std::function<void()> then = std::exchange(app.unsaved.then, nullptr);
    if (goOn && then) app.deferred.push_back(then);
    ImGui::CloseCurrentPopup();
}

void save(EditorApp& app) {
    const auto written = app.doc.save();
    if (written) return answer(app, true);
    app.unsaved.error = written.error().text();
    logWarning(app.unsaved.error);
}

}  // namespace

void drawUnsavedDialog(EditorApp& app) {
    UnsavedDialog& d = app.unsaved;
    if (!d.then) return;
    if (std::exchange(d.opening, false)) {
        d.error.clear();
        ImGui::OpenPopup("Unsaved work");
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    const int flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    if (!ImGui::BeginPopupModal("Unsaved work", nullptr, flags)) return;
    const float width = ImGui::GetFontSize() * 7;
    ImGui::Spacing();
    ImGui::Text("%s has changes that are not saved.", app.doc.project().name.c_str());
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
        save(app);
    else if (discarded || cancelled)
        answer(app, discarded);
    ImGui::EndPopup();
}

}  // namespace sward
