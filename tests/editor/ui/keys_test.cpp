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

TEST(Keys, MenusShowChordsCapitalised) { EXPECT_EQ(chordText("ctrl+shift+z"), "Ctrl+Shift+Z"); }

}  // namespace
}  // namespace sward
