// The dialog of names: what is refused is said in it, and fields that name the entity follow.
#include "app/object_actions.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

class RenamePanel : public test::PanelStage {
  protected:
    RenamePanel() {
        name = "Rename";
        draw = [this] { drawRenameDialog(dialog, doc, edits, [this](const std::string& n) { renamed = n; }); };
    }
    void open(const std::string& entity) {
        Selection selection{{entity}, "", ""};
        askName(dialog, selection);
        frames(4);
    }
    // Into the dialog as it opens: its line has the keyboard, and what stands there is selected.
    void enter(const std::string& text) {
        for (const char c : text) queue.push({InputKind::Char, 0, 0, c, false});
        frames(2);
        queue.push({InputKind::Key, 0, 0, GLFW_KEY_ENTER, true});
        queue.push({InputKind::Key, 0, 0, GLFW_KEY_ENTER, false});
        frames(4);
    }
    RenameDialog dialog;
    std::string renamed;
};

TEST_F(RenamePanel, ANewNameIsOneStepAndTold) {
    open("lawn");
    EXPECT_EQ(value("Rename/Name"), "lawn");
    enter("meadow");
    EXPECT_EQ(renamed, "meadow");
    EXPECT_NE(findEntity(doc.project(), "meadow"), kNoEntity);
    EXPECT_FALSE(shown("Rename/Name")) << "it has closed";
    EXPECT_EQ(doc.stepsDone(), 1u);
}

TEST_F(RenamePanel, ANameThatCannotBeStaysInTheDialogWithTheReason) {
    for (const char* wrong : {"two words", "sun"}) {
        open("lawn");
        enter(wrong);
        EXPECT_NE(value("Rename/Error"), "not there") << wrong;
    }
    EXPECT_EQ(renamed, "");
    click("Rename/Cancel");
    EXPECT_FALSE(doc.canUndo());
    EXPECT_FALSE(shown("Rename/Name"));
}

}  // namespace
}  // namespace sward
