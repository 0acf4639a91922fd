// Keys that the person bound: no two commands of one chord, kept and read again, bad lines told and left out.
#include "app/bindings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/commands.h"
#include "support.h"

namespace sward {
namespace {

const Command& named(const std::string& name) {
    for (const Command& c : commands())
        if (commandName(c) == name) return c;
    ADD_FAILURE() << name;
    return commands()[0];
}
bool runs(const Bindings& b, const std::string& command, const std::string& chord) {
    return runsBy(b, named(command), *parseChord(chord));
}

TEST(Bindings, ACommandRunsByTheTablesKeysUntilOthersAreBound) {
    Bindings b;
    EXPECT_TRUE(runs(b, "Edit/Redo", "ctrl+y"));
    EXPECT_TRUE(runs(b, "Edit/Redo", "ctrl+shift+z"));
    ASSERT_TRUE(bindKey(b, named("Edit/Redo"), "ctrl+alt+y"));
    EXPECT_TRUE(runs(b, "Edit/Redo", "ctrl+alt+y"));
    EXPECT_FALSE(runs(b, "Edit/Redo", "ctrl+y"));
    EXPECT_FALSE(runs(b, "Edit/Redo", "ctrl+shift+z"));
    EXPECT_EQ(chordOf(b, named("Edit/Redo")), "ctrl+alt+y");
    ASSERT_TRUE(unbindKey(b, named("Edit/Redo")));
    EXPECT_TRUE(runs(b, "Edit/Redo", "ctrl+y"));
    EXPECT_TRUE(b.own.empty());
}

TEST(Bindings, KeysOfAnotherCommandAreRefusedByItsName) {
    Bindings b;
    const Status taken = bindKey(b, named("File/Open..."), "Ctrl+S");
    ASSERT_FALSE(taken);
    EXPECT_NE(taken.error().text().find("File/Save"), std::string::npos) << taken.error().text();
    EXPECT_FALSE(bindKey(b, named("File/Open..."), "ctrl+nokey"));
    ASSERT_TRUE(bindKey(b, named("File/Save"), ""));
    EXPECT_FALSE(runs(b, "File/Save", "ctrl+s"));
    ASSERT_TRUE(bindKey(b, named("File/Open..."), "ctrl+s"));
    EXPECT_FALSE(unbindKey(b, named("File/Save"))) << "its keys are another's now";
    EXPECT_FALSE(runs(b, "File/Save", "ctrl+s"));
}

TEST(Bindings, AreReadAsTheyWereWritten) {
    const test::TempDir dir;
    Bindings b;
    ASSERT_TRUE(bindKey(b, named("File/Save As..."), "ctrl+alt+="));
    ASSERT_TRUE(bindKey(b, named("Object/Delete"), ""));
    ASSERT_TRUE(saveBindings(dir / "deep/keys.txt", b));
    EXPECT_EQ(loadBindings(dir / "deep/keys.txt").own, b.own);
    EXPECT_TRUE(loadBindings(dir / "none.txt").own.empty());
    EXPECT_FALSE(saveBindings("/proc/none/keys.txt", b));
}

TEST(Bindings, LinesThatCannotBeAreLeftOut) {
    const test::TempDir dir;
    std::ofstream(dir / "keys.txt") << "File/Fly = ctrl+9\nnonsense\nFile/Open... = ctrl+s\nFile/Quit = ctrl+\n"
                                       "Edit/Undo =\nView/Focus = ctrl+9\n";
    const Bindings b = loadBindings(dir / "keys.txt");
    EXPECT_EQ(b.own, (std::map<std::string, std::string>{{"Edit/Undo", ""}, {"View/Focus", "ctrl+9"}}));
}

}  // namespace
}  // namespace sward
