// The history: every step that can be undone or done again; a click goes there.
#include <fmt/format.h>
#include <imgui.h>

#include "app/edits.h"
#include "app/messages.h"
#include "model/document.h"
#include "panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// A line that stands for the state after so many steps.
void state(Document& doc, Edits& edits, Messages& messages, size_t steps, const std::string& label, size_t done) {
    if (steps > done) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(ui::kDimText));
    const bool pressed = ui::selectable(fmt::format("{} {}", steps, label), steps == done);
    if (steps > done) ImGui::PopStyleColor();
    if (!pressed || steps == done) return;
    edits.deferred.push_back([&doc, &messages, steps, label] {
        if (doc.jumpTo(steps)) say(messages, "back to: " + label);
    });
}

}  // namespace

void drawHistory(Document& doc, Edits& edits, Messages& messages, size_t& shownSteps) {
    if (!doc.isOpen()) return ImGui::TextDisabled("No project is open.");
    const std::vector<std::string> labels = doc.stepLabels();
    const size_t done = doc.stepsDone();
    ImGui::BeginChild("steps");
    state(doc, edits, messages, 0, labels.empty() ? "nothing was changed yet" : "as it was", done);
    for (size_t i = 0; i < labels.size(); ++i) {
        state(doc, edits, messages, i + 1, labels[i], done);
        if (i + 1 == done && done != shownSteps) ImGui::SetScrollHereY();
    }
    shownSteps = done;
    ImGui::EndChild();
}

}  // namespace sward
