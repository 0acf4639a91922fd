// A whole walk in the editor: drawn picture by picture, judged beside, shown as bars, and the view taken to the worst.
#include "editor/editor_fixture.h"

namespace sward::test {
namespace {

TEST_F(EditorUi, AWalkFindsItsStepsAndTakesTheViewToTheWorst) {
    const std::string keys = "camera.CameraPath.keys";
    ok(Status(doc.addComponent("camera", "CameraPath")));
    for (int key = 0; key < 2; ++key) ok(Status(doc.addListElement(keys)));
    ok(Status(doc.setField(keys + "[0].eye", "[4, 0.6, 4]")));
    ok(Status(doc.setField(keys + "[0].target", "[8, 0, 8]")));
    ok(Status(doc.setField(keys + "[1].eye", "[5, 0.6, 5]")));
    ok(Status(doc.setField(keys + "[1].target", "[9, 0, 9]")));
    ok(Status(doc.setField(keys + "[1].seconds", "2")));
    app->transitions.plan.width = 48, app->transitions.plan.height = 32;
    app->transitions.plan.pictures = 4;
    ok(ui->click("Tabs/Transitions"));
    ok(ui->click("Transitions/Walk"));
    ok(ui->wait(12));
    ASSERT_TRUE(app->transitions.result) << app->transitions.error;
    const Transitions& t = *app->transitions.result;
    ASSERT_EQ(t.drawn.steps.size(), 3u);
    for (const double step : t.drawn.steps) EXPECT_GT(step, 0);
    for (const double step : t.floor.steps) EXPECT_GT(step, 0);
    EXPECT_NE(get("Transitions/Summary").find("of 3 steps"), std::string::npos);
    ok(ui->click("Transitions/Go to worst"));
    ok(ui->wait(2));
    const glm::dvec3 eye = t.views[static_cast<size_t>(t.drawn.worstStep)].eye;
    EXPECT_NEAR(glm::distance(viewOf(app->view.camera).eye, eye), 0, 1e-6);
    EXPECT_FALSE(walking(app->transitions));
    ok(Status(doc.create(dir / "another")));
    ok(ui->wait(3));
    EXPECT_FALSE(app->transitions.result) << "it was of another project";
}

}  // namespace
}  // namespace sward::test
