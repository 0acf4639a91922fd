// The file dialog in the editor.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, TheFileDialogSavesAsAndOpensAndSaysWhatWentWrong) {
    const std::string copy = (dir / "copy").string();
    ok(ui->click("Menu/File/Save As..."));
    ok(ui->set("Files/Path", copy));
    EXPECT_FALSE(ui->exists("Files/Path"));
    EXPECT_EQ(doc.project().dir, copy);
    ok(ui->click("Menu/File/Open..."));
    EXPECT_TRUE(ui->exists("Files/meadow"));
    ok(ui->set("Files/Path", (dir / "nowhere").string()));
    EXPECT_TRUE(ui->exists("Files/Error"));
    ok(ui->click("Files/meadow"));
    ok(ui->click("Files/Open"));
    EXPECT_FALSE(ui->exists("Files/Open"));
    EXPECT_EQ(doc.project().dir, dir / "meadow");
}

}  // namespace
}  // namespace sward
