// Panels are hidden and shown.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, PanelsAreHiddenAndShownFromTheViewMenu) {
    ok(ui->click("Menu/View/Inspector"));
    EXPECT_FALSE(ui->exists("Inspector/lawn.GrassField.maxGeom"));
    ok(ui->click("Menu/View/Inspector"));
    EXPECT_TRUE(ui->exists("Inspector/lawn.GrassField.maxGeom"));
}

}  // namespace
}  // namespace sward
