// Undo, redo and the way to a step as menus, keys and the history's list ask for them: what is chosen follows, so that
// an entity that comes back is in the hand again.
// Does not: hold the steps (model/document.h).
#pragma once
#include <cstddef>

#include "app/messages.h"
#include "app/selection.h"
#include "model/document.h"

namespace sward {

// Document::undo and redo, with a message; entities that came by it are chosen, such as one whose removal or renaming
// was taken back. Nothing happens where there is no step.
void undoStep(Document& document, Selection& selection, Messages& messages);
void redoStep(Document& document, Selection& selection, Messages& messages);
// Document::jumpTo likewise; false if it cannot be reached now.
bool goToStep(Document& document, Selection& selection, size_t stepsDone);

}  // namespace sward
