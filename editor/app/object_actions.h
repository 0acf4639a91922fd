// What menus and keys do with the chosen entities: each one undo step. And the question for a new name.
// Does not: draw (panels/rename_dialog.cpp), nor know how entities are copied (model/entity_edits.h).
#pragma once
#include <glm/glm.hpp>
#include <string>

#include "app/messages.h"
#include "app/selection.h"
#include "model/document.h"
#include "tools/brush_book.h"
#include "tools/tier_view.h"

namespace sward {

struct RenameDialog {
    std::string entity;  // empty: not asked
    std::string name;    // what is typed
    std::string error;
    bool opening = false;
};

// The copies are chosen then; what has a place stands `aside` of its original, metres in the world, and on the ground
// if that does.
void duplicateChosen(Document& document, Selection& selection, Messages& messages, const glm::dvec3& aside = {});
// The chosen come into a new folder of the outliner, whose name is asked for there.
void folderChosen(Document& document, Selection& selection, Messages& messages);
// They come out of their folders.
void unfolderChosen(Document& document, const Selection& selection, Messages& messages);
// None is chosen then.
void removeChosen(Document& document, Selection& selection, Messages& messages);
// A new entity that scatters the chosen objects' meshes, or all of the project's; it is chosen then.
void scatterChosen(Document& document, Selection& selection, Messages& messages);
// The objects of the Scatter chosen last become entities, which are chosen then.
void makeObjectsOfChosen(Document& document, Selection& selection, Messages& messages);
// Hides all; where all are hidden, shows them again.
void hideChosen(Document& document, const Selection& selection, Messages& messages);
// Locks all; where all are locked, unlocks them.
void lockChosen(Document& document, const Selection& selection, Messages& messages);
// Whatever is locked is unlocked.
void unlockAll(Document& document, Messages& messages);
// Whatever is hidden is shown.
void showAll(Document& document, Messages& messages);
// Asks for a new name of the one chosen last.
void askName(RenameDialog& dialog, const Selection& selection);
// What followed the entity by its name: the selection, the brush's map, the tiers' field.
void followName(const std::string& from, const std::string& to, Selection& selection, BrushBook& brushes,
                TierView& tiers);

}  // namespace sward
