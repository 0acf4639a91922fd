// The inspector's tools for cameras: to the view and from it.
#include "panels/inspector_camera.h"

#include "editor/panels/panel_stage.h"
#include "techniques.h"

namespace sward {
namespace {

class CameraTools : public test::PanelStage {
  protected:
    CameraTools() {
        draw = [this] {
            const ComponentRow* row = findComponent(doc.tables().components, component);
            const void* value = row->get(doc.project().registry, findEntity(doc.project(), "camera"));
            drawCameraTools(fieldParts(), view, "camera", *row, value);
        };
    }
    ViewState view;
    std::string component = "Camera";
};

TEST_F(CameraTools, TheViewGoesToTheCamera) {
    ASSERT_TRUE(doc.setField("camera.Camera.eye", "[1, 2, 3]"));
    click("Panel/camera.Camera/Look through it");
    EXPECT_EQ(view.camera.eye, glm::dvec3(1, 2, 3));
}

TEST_F(CameraTools, TheCameraTakesTheViewInOneStep) {
    const std::string before = field("camera.Camera.target");
    view.camera.eye = {4, 5, 6};
    click("Panel/camera.Camera/Take the view");
    EXPECT_EQ(field("camera.Camera.eye"), "[4, 5, 6]");
    EXPECT_NE(field("camera.Camera.target"), before);
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(field("camera.Camera.target"), before);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(CameraTools, NoNumberIsLessThanNothing) {
    view.camera.eye = {-1e-6, 5, -0.0};
    click("Panel/camera.Camera/Take the view");
    EXPECT_EQ(field("camera.Camera.eye"), "[0, 5, 0]");
}

TEST_F(CameraTools, APathGetsAKeyWhereTheViewIsTwoSecondsAfterTheLast) {
    ASSERT_TRUE(doc.addComponent("camera", "CameraPath"));
    component = "CameraPath";
    frames(2);
    EXPECT_FALSE(shown("Panel/camera.CameraPath/Second")) << "there is no way to look along";
    view.camera.eye = {1, 1, 1};
    click("Panel/camera.CameraPath/Key from view");
    view.camera.eye = {2, 1, 1};
    click("Panel/camera.CameraPath/Key from view");
    const auto* path = doc.project().registry.get<CameraPath>(findEntity(doc.project(), "camera"));
    ASSERT_EQ(path->keys.size(), 2u);
    EXPECT_EQ(path->keys[0].eye, glm::dvec3(1, 1, 1));
    EXPECT_EQ(path->keys[1].eye, glm::dvec3(2, 1, 1));
    EXPECT_EQ(path->keys[1].seconds - path->keys[0].seconds, 2);
    EXPECT_TRUE(shown("Panel/camera.CameraPath/Second"));
}

}  // namespace
}  // namespace sward
