#include "editor/tools/brush_book.h"

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

TEST(BrushBook, AColourStaysWithItsMapForAllToolsAndGoesIntoStrokes) {
    BrushBook b = painting("add");
    b.map = "ground.Terrain.terrainMap";
    EXPECT_EQ(currentColor(b), glm::vec3(1));
    currentColor(b) = {0.9f, 0.8f, 0.1f};
    b.tool = "set";
    EXPECT_EQ(strokeBrush(b, false, false).color, glm::vec3(0.9f, 0.8f, 0.1f));
    b.map = "lawn.GrassField.vegetation";
    EXPECT_EQ(strokeBrush(b, true, false).color, glm::vec3(1));
}

TEST(BrushBook, ColoursAreWrittenAsInImagePrograms) {
    EXPECT_EQ(colorText({0.9f, 0, 1.4f}), "#e600ff");
    for (const char* text : {"#e5c81a", "E5C81A"}) {
        ASSERT_TRUE(parseColor(text)) << text;
        EXPECT_EQ(colorText(*parseColor(text)), "#e5c81a");
    }
    for (const char* text : {"", "#", "#fff", "#e5c81", "#e5c81ag", "#e5c81g", "-e5c81", "#-5c81a", "yellow"})
        EXPECT_FALSE(parseColor(text)) << text;
}

TEST(BrushBook, ThePresetMakesShiftAnEraser) {
    BrushBook b = painting("add");
    b.shiftErases = true;
    EXPECT_EQ(strokeBrush(b, false, true).mode, "subtract");
    EXPECT_EQ(strokeBrush(b, false, false).mode, "add");
}

TEST(BrushBook, OnHeightsCtrlSwapsRaiseAndLowerAndShiftSmoothsEvenWithThePreset) {
    BrushBook b = painting("raise");
    b.map = "ground.Terrain.height", b.kind = MapKind::Heights;
    EXPECT_LT(currentBrush(b).value, 0.5f) << "metres a stamp";
    EXPECT_EQ(strokeBrush(b, true, false).mode, "lower");
    b.shiftErases = true;
    EXPECT_EQ(strokeBrush(b, false, true).mode, "smooth");
    b.tool = "lower";
    EXPECT_EQ(strokeBrush(b, true, false).mode, "raise");
    for (const char* tool : {"flatten", "ramp", "erode", "noise"}) {
        b.tool = tool;
        EXPECT_EQ(strokeBrush(b, true, false).mode, tool);
        EXPECT_EQ(strokeBrush(b, false, true).mode, "smooth");
    }
    b.tool = "flatten";
    EXPECT_EQ(currentBrush(b).value, 0);
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
