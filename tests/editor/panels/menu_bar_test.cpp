// The menu bar over commands and panels of the test's own choosing.
#include "app/commands.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

constexpr Command kSave{"File", "Save", "ctrl+s", "", nullptr, nullptr},
    kQuit{"File", "Quit", "", "", nullptr, nullptr}, kFocus{"View", "Focus", "f", "", nullptr, nullptr};

class MenuBar : public test::PanelStage {
  protected:
    MenuBar() {
        name = "Menu";
        draw = [this] {
            if (const Command* c = drawMenuBar(doc, states, mode, layout)) chosen = c;
        };
    }
    std::vector<CommandState> states{
        {&kSave, kSave.chord, true, false}, {&kQuit, kQuit.chord, false, false}, {&kFocus, kFocus.chord, true, true}};
    ViewMode mode = ViewMode::Final;
    Layout layout;
    const Command* chosen = nullptr;
};

TEST_F(MenuBar, ACommandThatIsChosenIsHandedBack) {
    click("Menu/File");
    click("Menu/File/Save");
    EXPECT_EQ(chosen, &kSave);
    EXPECT_FALSE(shown("Menu/File/Save")) << "the menu has closed";
}

TEST_F(MenuBar, WhatIsDisabledIsNotChosenAndWhatIsOnIsTicked) {
    click("Menu/File");
    click("Menu/File/Quit");
    EXPECT_EQ(chosen, nullptr);
    EXPECT_FALSE(book.widgets.at("Menu/File/Quit").enabled);
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_ESCAPE, true});
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_ESCAPE, false});
    frames(4);
    click("Menu/View");
    EXPECT_EQ(value("Menu/View/Focus"), "true");
}

TEST_F(MenuBar, TheViewMenuChangesTheModeAndHidesPanels) {
    click("Menu/View");
    click("Menu/View/Normals");
    EXPECT_EQ(mode, ViewMode::Normals);
    click("Menu/View");
    click("Menu/View/Inspector");
    EXPECT_TRUE(layout.hidden.contains("Inspector"));
    layout.hidden.insert("Profiler");
    click("Menu/View");
    click("Menu/View/Profiler");
    EXPECT_FALSE(layout.hidden.contains("Profiler"));
    EXPECT_EQ(layout.tab, "Profiler") << "what is shown again is in front";
}

TEST_F(MenuBar, TheThemeIsChosenInTheViewMenu) {
    click("Menu/View");
    click("Menu/View/Theme");
    click("Menu/View/Theme/Light");
    EXPECT_TRUE(layout.lightTheme);
    click("Menu/View");
    click("Menu/View/Theme");
    EXPECT_EQ(value("Menu/View/Theme/Light"), "true");
    click("Menu/View/Theme/Dark");
    EXPECT_FALSE(layout.lightTheme);
}

}  // namespace
}  // namespace sward
