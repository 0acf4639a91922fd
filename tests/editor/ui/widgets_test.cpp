// What widgets write down, and what they hand back.
#include "ui/widgets.h"

#include "editor/panels/panel_stage.h"

namespace sward {
namespace {

class Widgets : public test::PanelStage {};

TEST_F(Widgets, PathsJoinScopesAndTellWhatIsGreyed) {
    draw = [] {
        const ui::Scope inner("Inner");
        ui::button("Free");
        const ui::Disabled off(true);
        const ui::Disabled again(false);
        ui::button("Greyed");
    };
    frames(2);
    EXPECT_TRUE(book.widgets.at("Panel/Inner/Free").enabled);
    EXPECT_FALSE(book.widgets.at("Panel/Inner/Greyed").enabled) << "what is around counts";
}

TEST_F(Widgets, WhatFindsNoRoomBesideGoesBelowInAColumnToo) {
    draw = [] {
        if (!ImGui::BeginTable("two", 2, ImGuiTableFlags_SizingFixedFit)) return;
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 200);
        ImGui::TableNextColumn();
        ui::button("First", 100);
        ui::beside(80);
        ui::button("Beside", 80);
        ui::beside(80);
        ui::button("Below", 80);
        ImGui::EndTable();
    };
    frames(2);
    const auto at = [&](const char* path) { return book.widgets.at(path); };
    EXPECT_EQ(at("Panel/Beside").y0, at("Panel/First").y0);
    EXPECT_GT(at("Panel/Below").y0, at("Panel/First").y1);
    EXPECT_EQ(at("Panel/Below").x0, at("Panel/First").x0);
}

TEST_F(Widgets, AComboHandsBackAnotherChoiceAlone) {
    const std::vector<std::string> items{"one", "two"};
    int chosen = 0, changes = 0;
    draw = [&] { changes += ui::combo("Pick", items, chosen); };
    click("Panel/Pick");
    click("Panel/Pick/two");
    EXPECT_EQ(chosen, 1);
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(value("Panel/Pick"), "two");
    click("Panel/Pick");
    click("Panel/Pick/two");
    EXPECT_EQ(changes, 1) << "the choice is what it was";
}

TEST_F(Widgets, ATextThatIsTypedComesOnceWithEnter) {
    std::vector<std::string> typed;
    draw = [&] {
        if (const auto text = ui::textField("Line", "")) typed.push_back(*text);
    };
    type("Panel/Line", "abc");
    EXPECT_EQ(typed, (std::vector<std::string>{"abc"}));
}

TEST_F(Widgets, WhatIsNoItemIsFoundByItsWholePathAndScrolledToOnce) {
    int scrolled = 0;
    draw = [&] {
        scrolled += ui::takeReveal("Elsewhere/Grip");
        ui::Widget grip;
        grip.value = "held";
        ui::recordAt("Elsewhere/Grip", grip);
    };
    frames(2);
    EXPECT_EQ(value("Elsewhere/Grip"), "held");
    EXPECT_EQ(scrolled, 0);
    book.reveal = "Elsewhere/Grip";
    frames(3);
    EXPECT_EQ(scrolled, 1);
}

TEST_F(Widgets, ErrorsStandAtTheirPathsUntilTheyAreTakenAway) {
    std::string seen;
    draw = [&] {
        ui::setError("Field", seen.empty() ? "too large" : "");
        seen = ui::errorAt("Field") ? *ui::errorAt("Field") : "none";
    };
    frames();
    EXPECT_EQ(seen, "too large");
    EXPECT_TRUE(book.errors.contains("Panel/Field"));
    frames();
    EXPECT_EQ(seen, "none");
}

}  // namespace
}  // namespace sward
