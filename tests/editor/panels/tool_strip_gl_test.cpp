// The tool strip in the editor: looking paints nothing.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, NothingIsPaintedWithTheLookTool) {
    const uint64_t before = density();
    ok(ui->click("Tools/Subtract"));
    ok(ui->click("Tools/Select"));
    paint();
    EXPECT_EQ(density(), before);
    EXPECT_FALSE(doc.canUndo());
}

}  // namespace
}  // namespace sward
