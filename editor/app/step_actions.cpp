#include "app/step_actions.h"

#include <functional>
#include <set>

namespace sward {
namespace {

// Chooses what `step` brings; what it leaves alone stays chosen.
bool choosingWhatCame(Document& doc, Selection& selection, const std::function<bool()>& step) {
    if (!doc.isOpen()) return step();
    std::set<std::string> before;
    for (const auto& [name, e] : doc.project().entities) before.insert(name);
    if (!step()) return false;
    std::vector<std::string> came;
    for (const auto& [name, e] : doc.project().entities)
        if (!before.contains(name)) came.push_back(name);
    if (!came.empty()) choose(selection, came, Choose::Only);
    return true;
}

}  // namespace

void undoStep(Document& doc, Selection& selection, Messages& messages) {
    const std::string label = doc.undoLabel();
    if (choosingWhatCame(doc, selection, [&] { return doc.undo(); })) say(messages, "undone: " + label);
}

void redoStep(Document& doc, Selection& selection, Messages& messages) {
    const std::string label = doc.redoLabel();
    if (choosingWhatCame(doc, selection, [&] { return doc.redo(); })) say(messages, "done again: " + label);
}

bool goToStep(Document& doc, Selection& selection, size_t stepsDone) {
    return choosingWhatCame(doc, selection, [&] { return doc.jumpTo(stepsDone); });
}

}  // namespace sward
