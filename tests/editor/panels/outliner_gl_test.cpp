// The outliner in the editor: what it refuses is said under its field.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, ABadEntityNameIsRefusedUnderItsField) {
    EXPECT_FALSE(ui->set("Outliner/New entity", "no good"));
    EXPECT_TRUE(app->book.errors.count("Outliner/New entity"));
    EXPECT_EQ(doc.project().entities.count("no good"), 0u);
}

}  // namespace
}  // namespace sward
