#include "ui/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cctype>

namespace sward {
namespace {

struct NamedKey {
    const char* name;
    int key;
};
constexpr NamedKey kNamed[] = {
    {"space", GLFW_KEY_SPACE},    {"enter", GLFW_KEY_ENTER},         {"return", GLFW_KEY_ENTER},
    {"escape", GLFW_KEY_ESCAPE},  {"esc", GLFW_KEY_ESCAPE},          {"tab", GLFW_KEY_TAB},
    {"delete", GLFW_KEY_DELETE},  {"backspace", GLFW_KEY_BACKSPACE}, {"insert", GLFW_KEY_INSERT},
    {"left", GLFW_KEY_LEFT},      {"right", GLFW_KEY_RIGHT},         {"up", GLFW_KEY_UP},
    {"down", GLFW_KEY_DOWN},      {"home", GLFW_KEY_HOME},           {"end", GLFW_KEY_END},
    {"pageup", GLFW_KEY_PAGE_UP}, {"pagedown", GLFW_KEY_PAGE_DOWN},  {"minus", GLFW_KEY_MINUS},
    {"equal", GLFW_KEY_EQUAL},    {"plus", GLFW_KEY_EQUAL},
};

int keyNamed(const std::string& name) {
    for (const NamedKey& k : kNamed)
        if (name == k.name) return k.key;
    if (name.size() == 1) {
        const unsigned char c = static_cast<unsigned char>(std::toupper(static_cast<unsigned char>(name[0])));
        const bool typed =
            std::isalnum(c) || std::string("[]-=;',./\\`").find(static_cast<char>(c)) != std::string::npos;
        return typed ? c : 0;  // GLFW's codes of typing keys are their US characters
    }
    if (name.size() <= 3 && name[0] == 'f') {
        const int n = std::atoi(name.c_str() + 1);
        return n >= 1 && n <= 12 ? GLFW_KEY_F1 + n - 1 : 0;
    }
    return 0;
}

std::string nameOf(int key) {
    const std::string typed(1, keyChar(key));
    if (keyNamed(typed) == key) return typed;
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "f" + std::to_string(key - GLFW_KEY_F1 + 1);
    for (const NamedKey& k : kNamed)
        if (key == k.key) return k.name;
    return "";
}

}  // namespace

std::string chordName(const Chord& chord) {
    const std::string key = nameOf(chord.key);
    if (key.empty()) return "";
    std::string name;
    if (chord.ctrl) name += "ctrl+";
    if (chord.shift) name += "shift+";
    if (chord.alt) name += "alt+";
    return name + key;
}

std::optional<Chord> parseChord(const std::string& text) {
    Chord chord;
    std::string part;
    const auto finish = [&]() {
        if (part == "ctrl" || part == "control") return chord.ctrl = true;
        if (part == "shift") return chord.shift = true;
        if (part == "alt") return chord.alt = true;
        if (chord.key != 0) return false;
        chord.key = keyNamed(part);
        return chord.key != 0;
    };
    for (const char c : text + "+") {
        if (c != '+') {
            part += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            continue;
        }
        if (part.empty() || !finish()) return std::nullopt;
        part.clear();
    }
    return chord.key != 0 ? std::optional(chord) : std::nullopt;
}

std::string chordText(const std::string& chord) {
    std::string text = chord;
    bool first = true;
    for (char& c : text) {
        if (first) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        first = c == '+';
    }
    return text;
}

char keyChar(int key) {
    if (key == GLFW_KEY_SPACE) return ' ';
    if (key <= GLFW_KEY_SPACE || key > GLFW_KEY_GRAVE_ACCENT) return 0;
    return static_cast<char>(std::tolower(key));
}

bool isModifierKey(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

bool isControlKey(int key) { return key >= GLFW_KEY_ESCAPE && !isModifierKey(key); }

}  // namespace sward
