// What menus and keys run: one row a command.
// Does not: hold the view modes and panels, which the View menu lists from their own tables.
#pragma once
#include <span>

#include "app/app.h"

namespace sward {

struct Command {
    const char* menu;    // "File"
    const char* label;   // "Save"
    const char* chord;   // "ctrl+s"; "" for none
    const char* chord2;  // another one, not shown; "" for none
    void (*run)(EditorApp&);
    bool (*enabled)(EditorApp&);
    bool anywhere = true;                   // false: only while the pointer is over the viewport
    bool (*checked)(EditorApp&) = nullptr;  // of what is switched on and off
    bool inPlay = false;                    // also while the project is played
};
std::span<const Command> commands();
// Runs the commands of the keys that went down in this frame, unless a text line or a dialog has the keyboard.
void runShortcuts(EditorApp& app);

}  // namespace sward
