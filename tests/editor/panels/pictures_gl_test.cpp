#include "editor/editor_fixture.h"

namespace sward::test {
namespace {

TEST_F(EditorUi, PicturesAreAcceptedAndCheckedFromTheMenu) {
    const std::string camera = accuracyCamera(doc, app->view.camera);
    ok(ui->click("Menu/Test/Accept Picture of This Camera"));
    ok(ui->wait(3));
    ASSERT_NE(acceptedPicture(doc.project(), camera), nullptr);
    ok(ui->click("Menu/Test/Check Pictures"));
    ok(ui->wait(6));
    EXPECT_EQ(get("Pictures/" + camera + "/Verdict").substr(0, 11), "as accepted");
    ok(Status(doc.setField(camera + ".Camera.fovDeg", "70")));
    ok(ui->click("Pictures/Check Pictures"));
    ok(ui->wait(6));
    EXPECT_EQ(get("Pictures/" + camera + "/Verdict").substr(0, 7), "differs");
    EXPECT_TRUE(ui->exists("Pictures/difference"));
    const size_t steps = doc.stepsDone();
    ok(ui->click("Pictures/" + camera + "/Accept"));
    ok(ui->wait(4));
    EXPECT_EQ(doc.stepsDone(), steps + 1);
    EXPECT_EQ(get("Pictures/" + camera + "/Verdict").substr(0, 11), "as accepted");
}

}  // namespace
}  // namespace sward::test
