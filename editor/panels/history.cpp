// The history: every step that can be undone or done again; a click goes there.
#include <fmt/format.h>
#include <imgui.h>

#include "app/edits.h"
#include "app/messages.h"
#include "app/step_actions.h"
#include "model/document.h"
#include "panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

struct List {
    Document& doc;
    Edits& edits;
    Messages& messages;
    Selection& selection;
    size_t done;                  // steps behind the project
    std::optional<size_t> saved;  // where it is as on disk
};

// Beside the line last drawn: the dot of the title and the status bar stands for what is not saved, this for what is.
void savedMark(const List& list, size_t steps) {
    const char* text = steps == list.done ? "saved, here" : "saved";
    const float width = ImGui::CalcTextSize(text).x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    ui::coloredText(ui::kAccent, text);
    ui::record("Saved", ui::Kind::Label, fmt::format("{}", steps));
    ui::tooltip("The project on disk is as after this step.");
}

// A line that stands for the state after so many steps.
void state(const List& list, size_t steps, const std::string& label) {
    if (steps > list.done) ImGui::PushStyleColor(ImGuiCol_Text, ImU32(ui::kDimText));
    const bool pressed = ui::selectable(fmt::format("{} {}", steps, label), steps == list.done);
    if (steps > list.done) ImGui::PopStyleColor();
    if (steps == list.saved) savedMark(list, steps);
    if (!pressed || steps == list.done) return;
    list.edits.deferred.push_back([list, steps, label] {
        if (goToStep(list.doc, list.selection, steps)) say(list.messages, "back to: " + label);
    });
}

}  // namespace

void drawHistory(Document& doc, Selection& selection, Edits& edits, Messages& messages, size_t& shownSteps) {
    if (!doc.isOpen()) return ImGui::TextDisabled("No project is open.");
    const std::vector<std::string> labels = doc.stepLabels();
    const List list{doc, edits, messages, selection, doc.stepsDone(), doc.savedStep()};
    ImGui::BeginChild("steps");
    state(list, 0, labels.empty() ? "nothing was changed yet" : "as it was");
    for (size_t i = 0; i < labels.size(); ++i) {
        state(list, i + 1, labels[i]);
        if (i + 1 == list.done && list.done != shownSteps) ImGui::SetScrollHereY();
    }
    shownSteps = list.done;
    ImGui::EndChild();
}

}  // namespace sward
