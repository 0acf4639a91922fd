// Unsaved work is asked about before it would be lost.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, UnsavedWorkIsAskedAboutBeforeQuitting) {
    ok(ui->set("Inspector/sun.Light.elevationDeg", "20"));
    ok(ui->click("Menu/File/Quit"));
    EXPECT_FALSE(app->quit);
    ok(ui->click("Unsaved/Cancel"));
    EXPECT_FALSE(app->quit);
    EXPECT_FALSE(ui->exists("Unsaved/Cancel"));
    ok(ui->key("ctrl+q"));
    ok(ui->click("Unsaved/Save"));
    EXPECT_TRUE(app->quit);
    EXPECT_FALSE(doc.dirty());
}

}  // namespace
}  // namespace sward
