// The table of commands: keys that can be read and belong to one command, menus in one piece.
#include "app/commands.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "ui/keys.h"

namespace sward {
namespace {

TEST(Commands, EveryKeyCanBeReadAndRunsOneCommand) {
    std::map<std::string, std::string> owners;
    for (const Command& c : commands())
        for (const std::string chord : {c.chord, c.chord2}) {
            if (chord.empty()) continue;
            EXPECT_TRUE(parseChord(chord)) << chord;
            EXPECT_TRUE(owners.emplace(chordText(chord), c.label).second)
                << chord << " is " << owners[chordText(chord)] << " and " << c.label;
        }
    EXPECT_EQ(owners["Ctrl+S"], "Save");
}

TEST(Commands, AMenusCommandsLieTogetherUnderNamesOfTheirOwn) {
    std::set<std::string> menus, labels;
    std::string last;
    for (const Command& c : commands()) {
        if (last != c.menu) EXPECT_TRUE(menus.insert(c.menu).second) << c.menu << " is in two pieces";
        last = c.menu;
        EXPECT_TRUE(labels.insert(last + "/" + c.label).second) << c.label;
        EXPECT_TRUE(c.run && c.enabled) << c.label;
    }
}

}  // namespace
}  // namespace sward
