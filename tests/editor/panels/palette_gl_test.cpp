// The palette and the list of keys, opened by their keys and used by mouse and keyboard.
#include "editor/editor_fixture.h"
#include "tools/brush_target.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, ThePaletteRunsWhatIsTypedAndGoesToObjects) {
    ok(doc.addEntity("far-stone"));
    ok(doc.addComponent("far-stone", "Transform"));
    ok(ui->key("ctrl+shift+p"));
    EXPECT_TRUE(app->palette.open);
    ok(ui->set("Palette/Search", "overlay"));  // Enter runs the first line
    EXPECT_FALSE(app->palette.open);
    EXPECT_TRUE(overlayShown(doc, app->brushes));
    ok(ui->key("f3"));
    ok(ui->set("Palette/Search", "far-stone"));
    EXPECT_EQ(shownEntity(app->selection), "far-stone");
    ok(ui->key("f3"));
    ok(ui->key("down"));
    ok(ui->key("down"));
    EXPECT_EQ(app->palette.chosen, 2);
    ok(ui->key("up"));
    EXPECT_EQ(app->palette.chosen, 1);
    ok(ui->key("escape"));
    EXPECT_FALSE(app->palette.open);
}

TEST_F(EditorUi, KeysAreBoundInTheirListAndRunTheCommand) {
    ok(ui->key("f1"));
    ASSERT_TRUE(app->keys.open);
    EXPECT_EQ(get("Keys/Brush/Larger/Keys"), "]");
    ok(ui->click("Keys/Brush/Larger/Bind"));
    ok(ui->key("ctrl+up"));
    EXPECT_EQ(get("Keys/Brush/Larger/Keys"), "Ctrl+Up");
    ok(ui->click("Keys/Brush/Smaller/Bind"));
    ok(ui->key("ctrl+up"));
    EXPECT_NE(get("Keys/Error").find("Brush/Larger"), std::string::npos) << get("Keys/Error");
    EXPECT_EQ(get("Keys/Brush/Smaller/Keys"), "[");
    ok(ui->click("Keys/Brush/Weaker/Bind"));
    ok(ui->key("backspace"));
    EXPECT_EQ(get("Keys/Brush/Weaker/Keys"), "");
    ok(ui->click("Keys/Brush/Stronger/Bind"));
    ok(ui->key("escape"));
    EXPECT_TRUE(app->keys.open) << "it only ended the wait";
    EXPECT_EQ(get("Keys/Brush/Stronger/Keys"), "=");
    ok(ui->key("escape"));
    EXPECT_FALSE(app->keys.open);
    const float before = currentBrush(app->brushes).radius;
    ok(ui->key("]"));
    EXPECT_EQ(currentBrush(app->brushes).radius, before);
    ok(ui->key("ctrl+up"));
    EXPECT_GT(currentBrush(app->brushes).radius, before);
    ok(ui->key("f1"));
    ok(ui->click("Keys/Brush/Larger/Reset"));
    EXPECT_EQ(get("Keys/Brush/Larger/Keys"), "]");
    ok(ui->click("Keys/Close"));
}

}  // namespace
}  // namespace sward
