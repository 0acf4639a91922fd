// The history's list: its steps, where the project stands among them, and a click that goes there.
#include "app/selection.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward::test {
namespace {

struct HistoryPanel : PanelStage {
    Selection selection;
};

TEST_F(HistoryPanel, AClickGoesToAStepAndBack) {
    size_t shownSteps = 0;
    draw = [&] { drawHistory(doc, selection, edits, messages, shownSteps); };
    frames(2);
    EXPECT_TRUE(shown("Panel/0 nothing was changed yet"));
    for (const char* height : {"0.1", "0.2", "0.3"})
        ASSERT_TRUE(doc.setField("lawn.GrassField.species[lawn].height", height));
    const std::string label = "set lawn.GrassField.species[lawn].height";
    frames(2);
    EXPECT_EQ(value("Panel/3 " + label), "true");
    click("Panel/1 " + label);
    EXPECT_EQ(field("lawn.GrassField.species[lawn].height"), "0.1");
    EXPECT_EQ(value("Panel/1 " + label), "true");
    EXPECT_EQ(value("Panel/3 " + label), "false") << "what was undone stays in the list";
    click("Panel/3 " + label);
    EXPECT_EQ(field("lawn.GrassField.species[lawn].height"), "0.3");
    click("Panel/0 as it was");
    EXPECT_EQ(doc.stepsDone(), 0u);
    EXPECT_FALSE(doc.canUndo());
    EXPECT_FALSE(doc.jumpTo(9)) << "there are three";
}

TEST_F(HistoryPanel, TheStepThatIsOnDiskIsMarked) {
    size_t shownSteps = 0;
    draw = [&] { drawHistory(doc, selection, edits, messages, shownSteps); };
    const auto set = [&](const char* height) {
        ASSERT_TRUE(doc.setField("lawn.GrassField.species[lawn].height", height));
    };
    frames(2);
    EXPECT_EQ(value("Panel/Saved"), "0");
    set("0.1"), set("0.2");
    ASSERT_TRUE(doc.save());
    set("0.3");
    frames(2);
    EXPECT_EQ(value("Panel/Saved"), "2");
    ASSERT_TRUE(doc.jumpTo(1));
    EXPECT_EQ(doc.savedStep(), 2u) << "it can be done again";
    set("0.4");
    frames(2);
    EXPECT_FALSE(shown("Panel/Saved")) << "no step leads there now";
    EXPECT_FALSE(doc.savedStep());
}

// Frames come only when they are wanted: under a pointer that rests, only while a tooltip is due.
TEST_F(HistoryPanel, ATooltipComesUnderAStillPointer) {
    draw = [] {
        ui::button("Save");
        ui::tooltip("Writes the project.");
    };
    frames(2);
    const ui::Widget w = book.widgets.at("Panel/Save");
    queue.push({InputKind::Move, static_cast<double>(w.x0 + w.x1) / 2, static_cast<double>(w.y0 + w.y1) / 2, 0, false});
    frames(1);
    int waited = 0;
    for (; book.tooltipDue && waited < 1000; ++waited) frames(1);
    EXPECT_EQ(value("Tooltip"), "Writes the project.");
    EXPECT_GT(waited, 10);
    EXPECT_LT(waited, 60);
}

}  // namespace
}  // namespace sward::test
