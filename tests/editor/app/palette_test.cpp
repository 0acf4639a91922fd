// What the palette finds for what is typed, and in which order.
#include "app/palette.h"

#include <gtest/gtest.h>

#include "app/commands.h"

namespace sward {
namespace {

std::vector<std::string> found(const std::string& typed, const std::vector<std::string>& entities = {},
                               const std::string& disabled = "") {
    std::vector<CommandState> states;
    for (const Command& c : commands()) states.push_back({&c, c.chord, c.label != disabled, false});
    std::vector<std::string> labels;
    for (const PaletteLine& line : paletteLines(typed, states, entities)) labels.push_back(line.label);
    return labels;
}

TEST(Palette, LettersCountInTheirOrderAndInAnyCase) {
    EXPECT_GT(paletteMatch("sa", "File > Save As"), 0);
    EXPECT_GT(paletteMatch("FS", "File > Save As"), 0);
    EXPECT_EQ(paletteMatch("sf", "File > Save"), 0);
    EXPECT_EQ(paletteMatch("savee", "File > Save"), 0);
    EXPECT_EQ(paletteMatch("", "anything"), paletteMatch("  ", "else"));
}

TEST(Palette, BeginningsOfWordsAndNeighboursCountMore) {
    EXPECT_GT(paletteMatch("sa", "Save As"), paletteMatch("sa", "Resample"));
    EXPECT_GT(paletteMatch("over", "Map Overlay"), paletteMatch("over", "Love every rabbit"));
    EXPECT_GT(paletteMatch("ab", "a b"), paletteMatch("ab", "xaxb"));
}

TEST(Palette, ALongNameOfOneLetterIsFoundAtOnce) {
    const std::string many(2000, 'a');
    EXPECT_GT(paletteMatch(std::string(30, 'a'), many), 30);
    std::string other(31, 'a');
    other.back() = 'b';
    EXPECT_EQ(paletteMatch(other, many), 0);
}

TEST(Palette, TheBestComesFirstAndObjectsAfterCommands) {
    ASSERT_FALSE(found("save").empty());
    EXPECT_EQ(found("save")[0], "File \xE2\x80\xBA Save");
    EXPECT_EQ(found("saveas")[0], "File \xE2\x80\xBA Save As...");
    const std::vector<std::string> rocks = found("rock-2", {"lawn", "rock-1", "rock-2"});
    ASSERT_FALSE(rocks.empty());
    EXPECT_EQ(rocks[0], "rock-2");
    EXPECT_EQ(found("", {"lawn"}).size(), commands().size() + 1);
    EXPECT_EQ(found("", {"lawn"}).back(), "lawn");
}

TEST(Palette, WhatCannotRunNowIsNotListed) {
    EXPECT_NE(found("undo")[0].find("Undo"), std::string::npos);
    for (const std::string& label : found("undo", {}, "Undo")) EXPECT_EQ(label.find("Undo"), std::string::npos);
}

}  // namespace
}  // namespace sward
