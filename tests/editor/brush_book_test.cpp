#include "editor/brush_book.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

BrushBook painting(const std::string& tool) {
    BrushBook b;
    b.tool = tool;
    b.map = "lawn.GrassField.species[a].density";
    return b;
}

TEST(BrushBook, SettingsStayWithTheirToolAndMap) {
    BrushBook b = painting("add");
    currentBrush(b).radius = 7;
    b.tool = "smooth";
    EXPECT_NE(currentBrush(b).radius, 7);
    currentBrush(b).radius = 3;
    b.tool = "add";
    EXPECT_EQ(currentBrush(b).radius, 7);
    b.map = "lawn.GrassField.species[b].density";
    EXPECT_NE(currentBrush(b).radius, 7);
    EXPECT_EQ(currentBrush(b).map, b.map);
}

TEST(BrushBook, ModifiersChangeTheStrokeAndNotTheSettings) {
    BrushBook b = painting("add");
    EXPECT_EQ(strokeBrush(b, false, false).mode, "add");
    EXPECT_EQ(strokeBrush(b, true, false).mode, "subtract");
    EXPECT_EQ(strokeBrush(b, false, true).mode, "smooth");
    EXPECT_EQ(strokeBrush(b, true, true).mode, "subtract");
    EXPECT_EQ(currentBrush(b).mode, "add");
    BrushBook s = painting("set");
    EXPECT_EQ(strokeBrush(s, true, false).value, 0);
    EXPECT_EQ(currentBrush(s).value, 1);
    BrushBook m = painting("subtract");
    EXPECT_EQ(strokeBrush(m, true, false).mode, "add");
    for (const char* lays : {"comb", "direction", "press"}) {
        BrushBook c = painting(lays);
        EXPECT_EQ(strokeBrush(c, true, false).mode, "subtract");
        EXPECT_EQ(strokeBrush(c, false, true).mode, "smooth");
    }
}

TEST(BrushBook, ThePresetMakesShiftAnEraser) {
    BrushBook b = painting("add");
    b.shiftErases = true;
    EXPECT_EQ(strokeBrush(b, false, true).mode, "subtract");
    EXPECT_EQ(strokeBrush(b, false, false).mode, "add");
}

TEST(BrushBook, SizeAndStrengthKeysStayWithinTheirRanges) {
    BrushSettings b;
    for (int i = 0; i < 200; ++i) growBrush(b, 1), strengthenBrush(b, 1);
    EXPECT_EQ(b.radius, 500);
    EXPECT_EQ(b.strength, 1);
    for (int i = 0; i < 200; ++i) growBrush(b, -1), strengthenBrush(b, -1);
    EXPECT_FLOAT_EQ(b.radius, 0.05f);
    EXPECT_FLOAT_EQ(b.strength, 0.05f);
    growBrush(b, 1);
    EXPECT_GT(b.radius, 0.05f);
}

}  // namespace
}  // namespace sward
