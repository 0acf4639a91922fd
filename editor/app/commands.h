// What menus and keys run: one row a command.
// Does not: hold the view modes and panels, which the View menu lists from their own tables.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace sward {

struct EditorApp;

// A row hands the parts of the editor that its command needs to the functions that do the work.
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
// All rows, menu by menu, in the order in which they are shown.
std::span<const Command> commands();

// How a menu shows a command now.
struct CommandState {
    const Command* command;
    std::string chord;  // as bound now
    bool enabled, checked;
};
// All of them, in the table's order: those of a menu lie together.
std::vector<CommandState> commandStates(EditorApp& app);
// Brings what is chosen and has a place before the camera, else what is under the pointer.
void focusChosen(EditorApp& app);
// Runs the commands of the keys that went down in this frame, unless a text line or a dialog has the keyboard.
void runShortcuts(EditorApp& app);

}  // namespace sward
