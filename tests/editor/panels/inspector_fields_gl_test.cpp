// The inspector's rows: every type of field is edited by its own widget.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, TheInspectorTypesPastTheSliderAndStopsAtTheHardRange) {
    const std::string path = "lawn.HybridTiers.maxGeom", label = "Inspector/" + path;
    ok(ui->set("Inspector/lawn.GrassField.species[lawn].bladesPerM2", "20"));  // blades to the horizon are many
    ok(ui->set(label, "750"));
    EXPECT_EQ(field(path), "750");
    ok(ui->set(label, "inf"));
    EXPECT_EQ(field(path), "inf");
    EXPECT_FALSE(ui->set(label, "-4"));
    EXPECT_EQ(field(path), "inf");
    EXPECT_TRUE(app->book.errors.count(label));
    ok(ui->click(label + "/Reset"));
    EXPECT_EQ(field(path), "12");
    EXPECT_FALSE(app->book.errors.count(label));
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(field(path), "inf");
}

TEST_F(EditorUi, VectorsColoursTextsAndChoicesAreEditedInTheInspector) {
    ok(ui->set("Inspector/camera.Camera.eye", "[1, 2.5, 3]"));
    EXPECT_EQ(field("camera.Camera.eye"), "[1, 2.5, 3]");
    ok(ui->set("Inspector/lawn.GrassField.species[lawn].tipColor", "[0.1, 0.2, 0.05]"));
    EXPECT_EQ(field("lawn.GrassField.species[lawn].tipColor"), "[0.1, 0.2, 0.05]");
    ok(ui->set("Inspector/lawn.GrassField.technique", "flat"));
    EXPECT_EQ(field("lawn.GrassField.technique"), "flat");
    ok(ui->set("Inspector/lawn.GrassField.species[lawn].name", "clover"));
    EXPECT_EQ(field("lawn.GrassField.species[clover].name"), "clover");
}

}  // namespace
}  // namespace sward
