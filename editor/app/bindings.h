// Keys of commands: those of the table of commands, but for what the person bound otherwise. Kept in keys.txt beside
// the layout, a command a line ("File/Save As... = ctrl+alt+s"; nothing after the sign: no key). Does not: read a
// keyboard, nor run commands.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/error.h"
#include "ui/keys.h"

namespace sward {

struct Command;

struct Bindings {
    std::map<std::string, std::string> own;  // by command ("File/Save"): its chord in keys.h's words, "" for none
};

// The dialog that lists all keys and binds others.
struct KeysDialog {
    bool open = false, opening = false;
    std::string search;
    std::string waiting;  // the command that takes the next keys; "" for none
    std::string error;    // why the last ones were not taken
};
// Opens it with everything listed.
void openKeys(KeysDialog& dialog);

// What a command is called in menus, in the palette and in keys.txt: "File/Save".
std::string commandName(const Command& command);
// The chord that menus show of a command; "" if it has none.
std::string chordOf(const Bindings& bindings, const Command& command);
// Whether these keys run the command: a second chord of the table counts until the person binds another.
bool runsBy(const Bindings& bindings, const Command& command, const Chord& pressed);
// Fails if another command has these keys, naming it; an empty chord takes the command's key away.
Status bindKey(Bindings& bindings, const Command& command, const std::string& chord);
// The table's keys again. Fails as bindKey does, if another command has taken them.
Status unbindKey(Bindings& bindings, const Command& command);

// Beside the layout's file; nothing where that is nothing.
std::optional<std::filesystem::path> bindingsFile();
// Lines that name no command or no keys, or keys of another command, are left out, and told in the log.
Bindings loadBindings(const std::filesystem::path& file);
// Makes the folders on the way. False if it could not be written whole.
bool saveBindings(const std::filesystem::path& file, const Bindings& bindings);

}  // namespace sward
