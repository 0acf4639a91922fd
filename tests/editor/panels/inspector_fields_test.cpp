// Titles of fields, and the row of one.
#include "panels/inspector_fields.h"

#include "editor/panels/panel_stage.h"

namespace sward {
namespace {

TEST(FieldTitle, HasWordsForHumpsAndLeavesDegreesToTheUnit) {
    EXPECT_EQ(fieldTitle("bladesPerM2"), "Blades per m2");
    EXPECT_EQ(fieldTitle("elevationDeg"), "Elevation");
    EXPECT_EQ(fieldTitle("Deg"), "Deg");
    EXPECT_EQ(fieldTitle("seed"), "Seed");
    EXPECT_EQ(fieldTitle(""), "");
}

class FieldRowOfInspector : public test::PanelStage {};

TEST_F(FieldRowOfInspector, AClickOnTheLabelGoesBackToTheDefault) {
    const std::string path = "camera.Camera.exposure";
    ASSERT_TRUE(doc.setField(path, "1.5"));
    name = "Inspector";
    draw = [&] {
        const auto f = findField(doc.project(), doc.tables().components, path);
        drawField(fieldParts(), *f, static_cast<const char*>(f->component->defaults()) + f->row->offset);
    };
    click("Inspector/" + path + "/Reset");
    EXPECT_EQ(field(path), "0");
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(field(path), "1.5");
}

}  // namespace
}  // namespace sward
