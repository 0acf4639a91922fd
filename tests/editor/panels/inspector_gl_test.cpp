// The inspector in the editor: components and elements of lists come and go.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, EntitiesAndComponentsComeAndGo) {
    ok(ui->set("Outliner/New entity", "second"));
    EXPECT_TRUE(ui->exists("Outliner/second"));
    ok(ui->set("Inspector/Add component", "Camera"));
    EXPECT_EQ(field("second.Camera.fovDeg"), "55");
    ok(ui->click("Inspector/second.Camera/Remove"));
    EXPECT_FALSE(ui->exists("Inspector/second.Camera.fovDeg"));
    ok(ui->click("Outliner/second"));
    ok(ui->click("Outliner/Remove"));
    EXPECT_FALSE(ui->exists("Outliner/second"));
    ok(ui->click("Inspector/lawn.GrassField.species/Add species"));
    EXPECT_EQ(doc.project().registry.get<GrassField>(findEntity(doc.project(), "lawn"))->species.size(), 2u);
}

}  // namespace
}  // namespace sward
