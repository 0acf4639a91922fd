// The inspector in the editor: components and elements of lists come and go.
#include <algorithm>

#include "editor/editor_fixture.h"
#include "scene/ground_path.h"

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

TEST_F(EditorUi, OfALongListOnlyTheRowsInSightAreBuilt) {
    GroundPath path;
    for (int i = 0; i < 300; ++i) path.points.push_back({std::to_string(i), {1 + 0.1 * i, 20}});
    ASSERT_TRUE(doc.addEntity("path"));
    ASSERT_TRUE(doc.assignComponent("path", *findComponent(doc.tables().components, "GroundPath"), &path));
    choose(app->selection, "path");
    ok(ui->wait(4));
    const auto rows = [&] {
        return std::count_if(app->book.widgets.begin(), app->book.widgets.end(), [](const auto& w) {
            return w.first.starts_with("Inspector/path.GroundPath.points[") && w.first.ends_with("]");
        });
    };
    EXPECT_GT(rows(), 3);
    EXPECT_LT(rows(), 64);
    ok(ui->click("Inspector/path.GroundPath.points[0]"));
    EXPECT_TRUE(ui->exists("Inspector/path.GroundPath.points[0].at"));
    EXPECT_TRUE(ui->exists("Inspector/path.GroundPath.points/Add point")) << "what follows the rows is there";
}

}  // namespace
}  // namespace sward
