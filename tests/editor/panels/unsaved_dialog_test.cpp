// The question what becomes of unsaved work: each answer, and a save that fails.
#include "app/file_tasks.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

class UnsavedQuestion : public test::PanelStage {
  protected:
    UnsavedQuestion() {
        draw = [this] { drawUnsavedDialog(unsaved, doc, outside, edits, waiting); };
    }
    void SetUp() override {
        PanelStage::SetUp();
        ASSERT_TRUE(doc.addEntity("second"));
        askFirst(unsaved, doc, [this] { gone = true; });
        frames(4);
    }
    UnsavedDialog unsaved;
    OutsideDialog outside;
    bool gone = false;
};

TEST_F(UnsavedQuestion, CancelKeepsEverything) {
    click("Panel/Cancel");
    EXPECT_FALSE(gone);
    EXPECT_TRUE(doc.dirty());
    EXPECT_FALSE(unsaved.then);
    EXPECT_FALSE(shown("Panel/Cancel"));
}

TEST_F(UnsavedQuestion, DiscardGoesOnUnsaved) {
    click("Panel/Discard");
    EXPECT_TRUE(gone);
    EXPECT_TRUE(doc.dirty());
}

TEST_F(UnsavedQuestion, SaveGoesOnOnceItIsSaved) {
    click("Panel/Save");
    EXPECT_TRUE(gone);
    EXPECT_FALSE(doc.dirty());
}

}  // namespace
}  // namespace sward
