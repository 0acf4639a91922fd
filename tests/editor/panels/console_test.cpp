// The console panel: the log, and the line for Lua.
#include "app/console.h"

#include <deque>
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

class ConsolePanel : public test::PanelStage {
  protected:
    ConsolePanel() {
        draw = [this] { drawConsole(console, false); };
    }
    Console console;
};

TEST_F(ConsolePanel, WithoutLuaItOnlyShowsTheLog) {
    console.log.lines.push_back({LogLevel::Warning, "the pond is dry"});
    frames(2);
    EXPECT_EQ(value("Panel/Log"), "the pond is dry");
    EXPECT_FALSE(shown("Panel/Command"));
}

TEST_F(ConsolePanel, AnEnteredLineWaitsToBeRunAndIsRemembered) {
    console.runLua = [](const std::string&) { return Status{}; };
    type("Panel/Command", "x=1");
    EXPECT_EQ(console.luaLines, (std::deque<std::string>{"x=1"}));
    EXPECT_EQ(console.history, (std::vector<std::string>{"x=1"}));
    EXPECT_EQ(console.line, "");
    type("Panel/Command", "");
    EXPECT_EQ(console.luaLines.size(), 1u) << "an empty line is none";
}

}  // namespace
}  // namespace sward
