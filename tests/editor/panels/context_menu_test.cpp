// The context menu: every command of the menu Object once, most of them in menus of their own.
#include "app/commands.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

class ContextMenu : public test::PanelStage {
  protected:
    ContextMenu() {
        name = "Context";
        for (const Command& c : commands()) states.push_back({&c, c.chord, true, false});
        draw = [this] {
            if (const Command* c = drawContextMenu(states, "bench", opening)) chosen = c;
        };
    }
    std::vector<CommandState> states;
    bool opening = true;
    const Command* chosen = nullptr;
};

TEST_F(ContextMenu, IsShortAndHoldsEveryCommandOnce) {
    frames(3);
    int top = 0, menus = 0;
    std::map<std::string, int> found;
    for (const auto& [path, w] : book.widgets) {
        top += w.kind == ui::Kind::Button;
        menus += w.kind == ui::Kind::Menu;
        if (w.kind == ui::Kind::Button) ++found[path.substr(path.rfind('/') + 1)];
    }
    EXPECT_LE(top + menus, 10) << "it fits 560 points";
    for (const char* menu : {"Sight and Lock", "Scatter", "Paths", "Tool"}) {
        click(std::string("Context/") + menu);
        for (const auto& [path, w] : book.widgets)
            if (path.starts_with(std::string("Context/") + menu + "/")) ++found[path.substr(path.rfind('/') + 1)];
    }
    for (const Command& c : commands())
        if (std::string(c.menu) == "Object") EXPECT_EQ(found[c.label], 1) << c.label;
}

TEST_F(ContextMenu, ACommandOfAMenuIsHandedBack) {
    frames(3);
    click("Context/Sight and Lock");
    click("Context/Sight and Lock/Hide or Show");
    ASSERT_NE(chosen, nullptr);
    EXPECT_STREQ(chosen->label, "Hide or Show");
}

}  // namespace
}  // namespace sward
