#include "editor/ui/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(Keys, ChordsAreReadInAnyCase) {
    EXPECT_EQ(parseChord("ctrl+z"), (Chord{GLFW_KEY_Z, true, false, false}));
    EXPECT_EQ(parseChord("Ctrl+Shift+Z"), (Chord{GLFW_KEY_Z, true, true, false}));
    EXPECT_EQ(parseChord("["), (Chord{GLFW_KEY_LEFT_BRACKET, false, false, false}));
    EXPECT_EQ(parseChord("F11"), (Chord{GLFW_KEY_F11, false, false, false}));
    EXPECT_EQ(parseChord("f"), (Chord{GLFW_KEY_F, false, false, false}));
    EXPECT_EQ(parseChord("alt+left"), (Chord{GLFW_KEY_LEFT, false, false, true}));
}

TEST(Keys, WhatIsNoChordIsRefused) {
    for (const char* text : {"", "+", "ctrl", "ctrl+", "ctrl+nokey", "a+b", "F13", "é"})
        EXPECT_EQ(parseChord(text), std::nullopt) << text;
}

TEST(Keys, ANamedChordIsReadAsItWas) {
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_F12; ++key)
        for (const bool held : {false, true}) {
            const Chord chord{key, held, !held, held};
            const std::string name = chordName(chord);
            if (!name.empty()) EXPECT_EQ(parseChord(name), chord) << name;
        }
    EXPECT_EQ(chordName({GLFW_KEY_EQUAL, true, false, false}), "ctrl+=");
    EXPECT_EQ(chordName({GLFW_KEY_PAGE_UP, false, true, true}), "shift+alt+pageup");
    EXPECT_EQ(chordName({GLFW_KEY_F11, false, false, false}), "f11");
    EXPECT_EQ(chordName({GLFW_KEY_CAPS_LOCK, false, false, false}), "");
}

TEST(Keys, MenusShowChordsCapitalised) { EXPECT_EQ(chordText("ctrl+shift+z"), "Ctrl+Shift+Z"); }

}  // namespace
}  // namespace sward
