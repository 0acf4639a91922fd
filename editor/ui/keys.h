// Key codes and chords ("ctrl+shift+z"). Codes are GLFW's, so that a window's callbacks need no table.
// Does not: read a keyboard.
#pragma once
#include <optional>
#include <string>

namespace sward {

struct Chord {
    int key = 0;
    bool ctrl = false, shift = false, alt = false;
    bool operator==(const Chord&) const = default;
};

// "ctrl+z", "F5", "[", "shift+left"; case does not matter. Nothing if a part is unknown.
std::optional<Chord> parseChord(const std::string& text);
// What parseChord reads as this; "" for a key that has no name there.
std::string chordName(const Chord& chord);
// As menus show it: "Ctrl+Shift+Z".
std::string chordText(const std::string& chord);
// The character a key types without modifiers (US layout), or 0.
char keyChar(int key);

// Ctrl, Shift, Alt or Super, left or right.
bool isModifierKey(int key);
// Keys that edit or move instead of typing: Enter, Backspace, arrows, function keys ...
bool isControlKey(int key);

}  // namespace sward
