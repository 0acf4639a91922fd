// Titles of fields, and the row of one.
#include "panels/inspector_fields.h"

#include "app/viewport.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"
#include "techniques.h"

namespace sward {
namespace {

TEST(FieldTitle, HasWordsForHumpsAndLeavesDegreesToTheUnit) {
    EXPECT_EQ(fieldTitle("bladesPerM2"), "Blades per m2");
    EXPECT_EQ(fieldTitle("elevationDeg"), "Elevation");
    EXPECT_EQ(fieldTitle("Deg"), "Deg");
    EXPECT_EQ(fieldTitle("seed"), "Seed");
    EXPECT_EQ(fieldTitle(""), "");
}

TEST(FieldTitle, IsSpeltAsElsewhere) {
    EXPECT_EQ(fieldTitle("rootColor"), "Root colour");
    EXPECT_EQ(fieldTitle("color"), "Colour");
    EXPECT_EQ(fieldTitle("centerColor"), "Centre colour");
}

TEST(ElementTitle, IsOneOfTheList) {
    EXPECT_EQ(elementTitle("meshes"), "Mesh");
    EXPECT_EQ(elementTitle("species"), "Species");
    EXPECT_EQ(elementTitle("keys"), "Key");
    EXPECT_EQ(elementTitle("layers"), "Layer");
    EXPECT_EQ(elementTitle("points"), "Point");
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

class InspectorOfLights : public test::PanelStage {};

TEST_F(InspectorOfLights, ShowsWhatActsOnTheirType) {
    ViewState looking;
    name = "Inspector";
    draw = [&] { drawInspector(fieldParts(), "sun", looking); };
    frames(2);
    EXPECT_TRUE(shown("Inspector/sun.Light.elevationDeg"));
    EXPECT_FALSE(shown("Inspector/sun.Light.attenuation"));
    EXPECT_FALSE(shown("Inspector/sun.Light.orbitRadius"));
    ASSERT_TRUE(doc.setField("sun.Light.type", "point"));
    frames(2);
    EXPECT_FALSE(shown("Inspector/sun.Light.elevationDeg"));
    EXPECT_TRUE(shown("Inspector/sun.Light.attenuation"));
    EXPECT_TRUE(shown("Inspector/sun.Light.orbitRadius"));
}

}  // namespace
}  // namespace sward
