// The brush bar in the editor: settings stay with their tool and map, angles and colours have widgets of their own.
#include "editor/editor_fixture.h"
#include "tools/brush_target.h"

namespace sward {
namespace {

using test::EditorTools;
using test::EditorUi;

constexpr const char* kOrientation = "lawn.GrassField.orientation";
constexpr const char* kVegetation = "lawn.GrassField.vegetation";

TEST_F(EditorUi, TypedBrushSettingsStayWithTheirTool) {
    ok(ui->set("Brush/Mode", "Add"));
    ok(ui->set("Brush/Radius", "7.5"));
    EXPECT_EQ(get("Brush/Radius"), "7.5");
    ok(ui->set("Brush/Mode", "Smooth"));
    EXPECT_NE(get("Brush/Radius"), "7.5");
    ok(ui->set("Brush/Mode", "Add"));
    EXPECT_EQ(get("Brush/Radius"), "7.5");
    ok(ui->key("["));
    EXPECT_LT(currentBrush(app->brushes).radius, 7.5f);
    const Status refused = ui->set("Brush/Radius", "-3");
    EXPECT_FALSE(refused);
    EXPECT_LT(0, currentBrush(app->brushes).radius);
    ok(ui->set("Brush/Radius", "2"));
}

TEST_F(EditorTools, TheDialAndTheNumberSetTheAngle) {
    ok(ui->click("Tools/Direction"));
    ok(ui->set("Brush/Angle", "135"));
    EXPECT_EQ(currentBrush(app->brushes).angleDeg, 135);
    ok(ui->click("Tools/Comb"));
    EXPECT_FALSE(ui->exists("Brush/Angle"));
}

TEST_F(EditorTools, TheSwatchShowsForMapsOfColoursOnly) {
    for (const ConstFieldRef& map : paintableMaps(doc)) {
        ok(ui->set("Brush/Map", map.path));
        const std::string name = map.row->name;
        const bool colours = name == "terrainMap" || name == "vegetation";
        EXPECT_EQ(ui->exists("Brush/Colour"), colours) << name;
        EXPECT_EQ(ui->exists("Brush/Colour/Swatch"), colours) << name;
        EXPECT_EQ(ui->exists("Brush/Opacity"), colours) << name;
    }
    ok(ui->set("Brush/Map", kVegetation));
    EXPECT_EQ(app->brushes.tool, "add");
    ok(ui->click("Tools/Subtract"));
    EXPECT_FALSE(ui->exists("Brush/Opacity"));
    ok(ui->click("Tools/Comb"));
    EXPECT_EQ(app->brushes.map, kOrientation);
    ok(ui->click("Tools/Add"));
    EXPECT_EQ(app->brushes.map, kVegetation) << "the last map that it paints";
    ok(ui->set("Brush/Colour", "#8020a0"));
    EXPECT_EQ(get("Brush/Colour"), "#8020a0");
    EXPECT_FALSE(ui->set("Brush/Colour", "purple"));
    EXPECT_EQ(get("Brush/Colour"), "#8020a0");
    ok(ui->set("Brush/Map", "terrainMap"));
    EXPECT_EQ(get("Brush/Colour"), "#ffffff");
    ok(ui->click("Brush/Colour/Swatch"));
    EXPECT_TRUE(app->book.widgets.at("Brush/Colour/Swatch").open);
    ok(ui->key("escape"));
}

TEST_F(EditorUi, AToolOfHeightsSaysHowManyLayersLieOverThem) {
    ok(ui->click("Tools/Flatten"));
    EXPECT_FALSE(ui->exists("Brush/Below"));
    ok(ui->click("Layers/Add rule"));
    EXPECT_EQ(get("Brush/Below"), "below 1 layer");
    ok(ui->click("Layers/Add painted"));
    ok(ui->click("Layers/ground.MapLayers.layers[painted]/Paint"));
    ok(ui->wait(2));
    EXPECT_FALSE(ui->exists("Brush/Below")) << "the brush is on the topmost";
}

TEST_F(EditorUi, ThePathToolSaysWhatClicksDoAndHasNoSteps) {
    ok(ui->key("p"));
    EXPECT_EQ(get("Brush/Mode"), "Path");
    EXPECT_TRUE(ui->exists("Brush/Path Help"));
    EXPECT_FALSE(ui->exists("Brush/Grid"));
    ok(ui->set("Brush/Mode", "Select"));
    EXPECT_TRUE(ui->exists("Brush/Grid"));
    EXPECT_EQ(app->objects.mode, GizmoMode::Move);
    ok(ui->set("Brush/Mode", "Path"));
    EXPECT_EQ(app->objects.mode, GizmoMode::Path);
}

}  // namespace
}  // namespace sward
