// What the person has chosen, in the outliner or by a click in the viewport.
// Does not: hold what tools choose for themselves (tools/brush_book.h, tools/tier_view.h).
#pragma once
#include <set>
#include <span>
#include <string>
#include <vector>

namespace sward {

struct Project;

struct Selection {
    std::vector<std::string> entities;  // by name, in the order in which they were chosen
    std::string newEntity;              // being typed in the outliner
    std::string search;                 // likewise: rows without it are not listed
    std::set<std::string> closedFolders;
    std::string renaming;  // a folder whose name is being typed; empty: none
    int nameAge = 0;       // frames since it was asked for; -1: the line has the keyboard
};

// How a click or a box chooses: these alone, these too, or each of them on and off.
enum class Choose { Only, Add, Toggle };
// Ctrl toggles, Shift adds.
Choose howChosen(bool ctrl, bool shift);

// The one that was chosen last, which the inspector shows; "": none is.
const std::string& shownEntity(const Selection& selection);
// Whether it is one of the chosen.
bool isChosen(const Selection& selection, const std::string& entity);
// Those that are named are chosen last, in their order.
void choose(Selection& selection, std::span<const std::string> names, Choose how);
// The same of one.
void choose(Selection& selection, const std::string& name, Choose how = Choose::Only);
// Forgets those that the project has no more.
void dropMissing(Selection& selection, const Project& project);

}  // namespace sward
