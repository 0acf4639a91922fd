// An object in the hand: a click on the ground is one entity and one undo step; a click into the sky is none.
#include "panels/viewport_place.h"

#include "editor/panels/panel_stage.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"

namespace sward {
namespace {

class Placing : public test::PanelStage {
  protected:
    void SetUp() override {
        PanelStage::SetUp();
        const Solid box{SolidKind::Box, glm::vec3(1)};
        test::writeText(dir / "meadow" / "models" / "box.glb", *encodeGlb(makeMesh({&box, 1})));
        camera.eye = {20, 6, 34}, camera.pitch = -0.3;
        tool.placing = "models/box.glb";
    }
    bool place(double x, double y) {
        return placeObject({doc, selection, tool, edits, messages, camera, view, 0, true, true}, x, y);
    }
    Selection selection;
    ObjectTool tool;
    FlyCamera camera;
    Rect view{0, 0, 400, 300};
};

TEST_F(Placing, AClickOnTheGroundIsOneStepAndChoosesWhatItPlaced) {
    ASSERT_TRUE(place(200, 200));
    EXPECT_EQ(field("box.StaticMesh.file"), "models/box.glb");
    EXPECT_EQ(selection.entities, std::vector<std::string>{"box"});
    EXPECT_EQ(messages.status, "placed box; Escape ends placing");
    EXPECT_EQ(field("box.StaticMesh.rotationDeg"), "[0, 0, 0]");
    tool.randomTurn = true;
    ASSERT_TRUE(place(150, 220));
    EXPECT_NE(field("box-2.StaticMesh.rotationDeg"), "[0, 0, 0]");
    EXPECT_EQ(doc.stepsDone(), 2u);
    EXPECT_EQ(doc.undoLabel(), "place box-2");
    ASSERT_TRUE(doc.undo());
    ASSERT_TRUE(doc.undo());
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(Placing, AClickIntoTheSkyPlacesNothing) {
    camera.pitch = 1.2;
    EXPECT_FALSE(place(200, 20));
    EXPECT_FALSE(doc.canUndo());
}

}  // namespace
}  // namespace sward
