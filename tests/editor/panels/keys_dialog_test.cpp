// The dialog of keys: one close closes it, and a key that is pressed is bound.
#include "app/bindings.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

class KeysDialogPanel : public test::PanelStage {
  protected:
    KeysDialogPanel() {
        name = "Keys";
        draw = [this] { changed |= drawKeysDialog(dialog, bindings, in); };
    }
    void open() {
        openKeys(dialog);
        frames(4);
        ASSERT_TRUE(shown("Keys/Search"));
    }
    void press(int key) {
        queue.push({InputKind::Key, 0, 0, key, true});
        queue.push({InputKind::Key, 0, 0, key, false});
        frames(4);
    }
    KeysDialog dialog;
    Bindings bindings;
    bool changed = false;
};

TEST_F(KeysDialogPanel, OneCloseClosesIt) {
    open();
    click("Keys/Close");
    EXPECT_FALSE(dialog.open);
    EXPECT_FALSE(shown("Keys/Search"));
    EXPECT_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
}

TEST_F(KeysDialogPanel, OneClickOnTheCrossOfItsTitleClosesIt) {
    open();
    const ui::Widget close = book.widgets.at("Keys/Close");  // the cross is above it
    const float y = close.y0 - ImGui::GetStyle().WindowPadding.y - ImGui::GetFrameHeight() / 2;
    queue.push({InputKind::Move, static_cast<double>(close.x1) - 4, static_cast<double>(y), 0, false});
    frames(2);
    queue.push({InputKind::Button, 0, 0, 0, true});
    frames();
    queue.push({InputKind::Button, 0, 0, 0, false});
    frames(4);
    EXPECT_FALSE(dialog.open);
    EXPECT_FALSE(shown("Keys/Search"));
    EXPECT_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
}

TEST_F(KeysDialogPanel, OneEscapeClosesItAlsoAfterSearching) {
    open();
    for (const char c : std::string("undo")) queue.push({InputKind::Char, 0, 0, c, false});
    frames(3);
    EXPECT_TRUE(shown("Keys/Edit/Undo/Bind"));
    EXPECT_FALSE(shown("Keys/File/Save/Bind"));
    press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(dialog.open);
    EXPECT_FALSE(shown("Keys/Search"));
    open();
    EXPECT_TRUE(shown("Keys/File/Save/Bind")) << "it opens with everything listed";
}

TEST_F(KeysDialogPanel, OneCloseClosesItWhileACommandWaitsForKeys) {
    open();
    click("Keys/Edit/Undo/Bind");
    EXPECT_EQ(dialog.waiting, "Edit/Undo");
    click("Keys/Close");
    EXPECT_FALSE(dialog.open);
    EXPECT_FALSE(shown("Keys/Search"));
}

TEST_F(KeysDialogPanel, KeysThatArePressedAreBoundAndResetGoesBack) {
    open();
    click("Keys/Edit/Undo/Bind");
    press(GLFW_KEY_F9);
    EXPECT_TRUE(changed);
    EXPECT_EQ(bindings.own.at("Edit/Undo"), "f9");
    click("Keys/Edit/Undo/Reset");
    EXPECT_TRUE(bindings.own.empty());
}

}  // namespace
}  // namespace sward
