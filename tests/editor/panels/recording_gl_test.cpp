#include "editor/editor_fixture.h"
#include "project/project_files.h"
#include "script/script.h"

namespace sward::test {
namespace {

TEST_F(EditorUi, ARecordedSessionRunsOnACopyToTheSameProject) {
    ASSERT_TRUE(doc.save());
    std::filesystem::copy(doc.project().dir, dir / "copy", std::filesystem::copy_options::recursive);
    ok(ui->click("Menu/Edit/Start Recording"));
    ok(ui->click("Tools/Subtract"));
    paint();
    ok(ui->wait(10));
    ok(Status(doc.setField("lawn.GrassField.seed", "3")));
    paint();
    ok(ui->wait(10));
    ok(ui->key("ctrl+z"));
    ok(ui->wait(3));
    ok(ui->click("Menu/Edit/Stop and Save Recording..."));
    ok(ui->wait(4));
    const std::string file = (doc.project().dir.parent_path() / (doc.project().name + "-session.lua")).string();
    EXPECT_EQ(get("Files/Path"), file);
    ok(ui->click("Files/Save"));
    ok(ui->wait(4));
    EXPECT_FALSE(app->recorder.recording());
    const std::string text = readText(file);
    EXPECT_NE(text.find("brush.stroke("), std::string::npos) << text;
    EXPECT_NE(text.find("edit.undo()"), std::string::npos) << text;
    Document other{tables()};
    ASSERT_TRUE(other.open(dir / "copy"));
    ScriptHost host{other};
    const Status ran = runScript(file, host);
    EXPECT_TRUE(ran) << ran.error().text() << text;
    EXPECT_EQ(projectHash(other.project(), tables().components), projectHash(doc.project(), tables().components));
}

}  // namespace
}  // namespace sward::test
