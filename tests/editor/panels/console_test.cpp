// The console panel: the log, and the line for Lua.
#include "app/console.h"

#include <deque>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
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

TEST_F(ConsolePanel, ArrowsAndTabChangeTheLineBeingTyped) {
    console.runLua = [](const std::string&) { return Status{}; };
    console.completions = [](const std::string& word) { return std::vector<std::string>{word + "e"}; };
    const auto tap = [&](int key) {
        queue.push({InputKind::Key, 0, 0, key, true});
        queue.push({InputKind::Key, 0, 0, key, false});
        frames(3);
    };
    type("Panel/Command", "first()");
    click("Panel/Command");
    queue.push({InputKind::Char, 0, 0, 'm', false});
    frames(2);
    tap(GLFW_KEY_TAB);
    EXPECT_EQ(console.line, "me");
    tap(GLFW_KEY_UP);
    EXPECT_EQ(console.line, "first()");
    tap(GLFW_KEY_DOWN);
    EXPECT_EQ(console.line, "me");
}

}  // namespace
}  // namespace sward
