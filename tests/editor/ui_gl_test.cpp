// The editor without a window: real widgets, real input queue, real renderer.
#include <gtest/gtest.h>

#include "editor_fixture.h"
#include "maps/map_io.h"

namespace sward {
namespace {

class EditorUi : public test::EditorFixture {};

TEST_F(EditorUi, EveryWidgetThatScriptsNameIsThere) {
    for (const char* label : {"Menu/File/New...",
                              "Menu/File/Open...",
                              "Menu/File/Save",
                              "Menu/File/Save As...",
                              "Menu/File/Quit",
                              "Menu/Edit/Undo",
                              "Menu/Edit/Redo",
                              "Menu/View/Tiers",
                              "Menu/View/Profiler",
                              "Tools/Look",
                              "Tools/Add",
                              "Tools/Smooth",
                              "Brush/Mode",
                              "Brush/Map",
                              "Brush/Radius",
                              "Brush/Strength",
                              "Brush/Falloff",
                              "Viewport",
                              "Viewport/Camera",
                              "Outliner/lawn",
                              "Outliner/New entity",
                              "Inspector/lawn.GrassField.maxGeom",
                              "Inspector/ground.Terrain.size",
                              "Inspector/sun.Light.elevationDeg",
                              "Tabs/Console",
                              "Profiler/Measure",
                              "Status/Blades",
                              "Status/Saved"})
        EXPECT_TRUE(ui->exists(label)) << label;
    EXPECT_FALSE(ui->exists("Brush/Nothing"));
    EXPECT_FALSE(ui->exists("Inspector/nobody.GrassField.maxGeom"));
    const Status missing = ui->click("Nowhere/Nothing");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ExitCode::Usage);
}

TEST_F(EditorUi, AStrokeInTheViewportPaintsAndIsOneUndoStep) {
    const uint64_t before = density();
    ok(ui->set("Brush/Mode", "Subtract"));
    paint();
    const uint64_t painted = density();
    EXPECT_NE(painted, before);
    EXPECT_EQ(get("Status/Saved"), "false");
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(density(), before);
    EXPECT_EQ(get("Status/Saved"), "true");
    ok(ui->key("ctrl+y"));
    EXPECT_EQ(density(), painted);
    ok(ui->key("ctrl+z"));
    ok(ui->key("ctrl+shift+z"));
    EXPECT_EQ(density(), painted);
    EXPECT_FALSE(doc.canRedo());
}

TEST_F(EditorUi, NothingIsPaintedWithTheLookTool) {
    const uint64_t before = density();
    ok(ui->click("Tools/Subtract"));
    ok(ui->click("Tools/Look"));
    paint();
    EXPECT_EQ(density(), before);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(EditorUi, SavingAndReopeningFindsTheSamePaint) {
    ok(ui->click("Tools/Subtract"));
    paint();
    const uint64_t painted = density();
    ok(ui->key("ctrl+s"));
    EXPECT_EQ(get("Status/Saved"), "true");
    Document again(tables());
    ASSERT_TRUE(again.open(dir / "meadow"));
    const Result<ConstFieldRef> map = findMap(again.project(), tables().components, "density");
    ASSERT_TRUE(map);
    EXPECT_EQ(static_cast<const MapField*>(map->value)->map.hash(), painted);
}

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

TEST_F(EditorUi, TheInspectorTypesPastTheSliderAndStopsAtTheHardRange) {
    const std::string path = "lawn.GrassField.maxGeom", label = "Inspector/" + path;
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

TEST_F(EditorUi, DraggingASliderIsOneUndoStep) {
    const std::string path = "lawn.GrassField.species[lawn].bend", label = "Inspector/" + path;
    ASSERT_TRUE(ui->exists(label));
    ASSERT_TRUE(ui->get(label));
    const std::string before = field(path);
    const ui::Widget w = app->book.widgets.at(label);
    const double y = static_cast<double>(w.y0 + w.y1) / 2;
    ok(ui->drag(static_cast<double>(w.x0) + 10, y, static_cast<double>(w.x1) - 10, y));
    EXPECT_NE(field(path), before);
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(field(path), before);
    EXPECT_FALSE(doc.canUndo());
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

TEST_F(EditorUi, ABadEntityNameIsRefusedUnderItsField) {
    EXPECT_FALSE(ui->set("Outliner/New entity", "no good"));
    EXPECT_TRUE(app->book.errors.count("Outliner/New entity"));
    EXPECT_EQ(doc.project().entities.count("no good"), 0u);
}

TEST_F(EditorUi, UnsavedWorkIsAskedAboutBeforeQuitting) {
    ok(ui->set("Inspector/sun.Light.elevationDeg", "20"));
    ok(ui->click("Menu/File/Quit"));
    EXPECT_FALSE(app->quit);
    ok(ui->click("Unsaved/Cancel"));
    EXPECT_FALSE(app->quit);
    EXPECT_FALSE(ui->exists("Unsaved/Cancel"));
    ok(ui->key("ctrl+q"));
    ok(ui->click("Unsaved/Save"));
    EXPECT_TRUE(app->quit);
    EXPECT_FALSE(doc.dirty());
}

TEST_F(EditorUi, TheFileDialogSavesAsAndOpensAndSaysWhatWentWrong) {
    const std::string copy = (dir / "copy").string();
    ok(ui->click("Menu/File/Save As..."));
    ok(ui->set("Files/Path", copy));
    EXPECT_FALSE(ui->exists("Files/Path"));
    EXPECT_EQ(doc.project().dir, copy);
    ok(ui->click("Menu/File/Open..."));
    EXPECT_TRUE(ui->exists("Files/meadow"));
    ok(ui->set("Files/Path", (dir / "nowhere").string()));
    EXPECT_TRUE(ui->exists("Files/Error"));
    ok(ui->click("Files/meadow"));
    ok(ui->click("Files/Open"));
    EXPECT_FALSE(ui->exists("Files/Open"));
    EXPECT_EQ(doc.project().dir, dir / "meadow");
}

TEST_F(EditorUi, AnErrorStandsOverTheViewportUntilDismissed) {
    showError(*app, failed("the disk is full", "free some space").at("maps/a.png"));
    EXPECT_NE(get("Viewport/Error").find("disk is full"), std::string::npos);
    ok(ui->click("Viewport/Dismiss"));
    EXPECT_FALSE(ui->exists("Viewport/Error"));
}

TEST_F(EditorUi, WhatKeepsTheSceneFromBeingDrawnIsSaidUntilItIsMended) {
    ok(doc.setField("lawn.GrassField.population", "unique"));
    ok(ui->wait(3));
    EXPECT_NE(get("Viewport/Error").find("lawn.GrassField.population: 3200000 blades"), std::string::npos)
        << get("Viewport/Error");
    ok(doc.setField("lawn.GrassField.species[lawn].bladesPerM2", "1500"));
    ok(ui->wait(3));
    EXPECT_NE(get("Viewport/Error").find("2400000 blades"), std::string::npos) << get("Viewport/Error");
    ok(doc.setField("lawn.GrassField.population", "patch"));
    ok(ui->wait(3));
    EXPECT_FALSE(ui->exists("Viewport/Error"));
    showError(*app, failed("the disk is full"));
    ok(doc.setField("lawn.GrassField.seed", "7"));
    ok(ui->wait(3));
    EXPECT_TRUE(ui->exists("Viewport/Error")) << "another error is not drawing's to take away";
    ok(ui->click("Viewport/Dismiss"));
}

TEST_F(EditorUi, TheViewportIsNotDrawnAgainWhenNothingChanged) {
    ok(ui->wait(3));
    app->viewport.lastMs = -1;
    ok(ui->wait(5));
    EXPECT_EQ(app->viewport.lastMs, -1);
    ASSERT_TRUE(doc.setField("sun.Light.elevationDeg", "30"));
    ok(ui->wait(2));
    EXPECT_GT(app->viewport.lastMs, 0);
}

TEST_F(EditorUi, AScreenshotShowsTheWholeWindow) {
    ok(ui->screenshot(dir / "editor.png"));
    const Result<Image> image = readImage(dir / "editor.png");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, 800);
    EXPECT_EQ(image->height, 600);
    const auto at = [&](int x, int y) {
        return image
            ->pixels[(static_cast<size_t>(y) * 800 + static_cast<size_t>(x)) * static_cast<size_t>(image->channels)];
    };
    const Rect& r = app->viewport.rect;
    EXPECT_GT(at(static_cast<int>(r.x + r.w / 2), static_cast<int>(r.y + 10)), 0.4f);  // sky
    EXPECT_LT(at(790, 300), 0.35f);                                                    // a dark panel
}

TEST_F(EditorUi, PanelsAreHiddenAndShownFromTheViewMenu) {
    ok(ui->click("Menu/View/Inspector"));
    EXPECT_FALSE(ui->exists("Inspector/lawn.GrassField.maxGeom"));
    ok(ui->click("Menu/View/Inspector"));
    EXPECT_TRUE(ui->exists("Inspector/lawn.GrassField.maxGeom"));
}

TEST_F(EditorUi, AmbientOcclusionIsBakedBesideTheEditorAndCanBeCancelled) {
    setenv("XDG_CACHE_HOME", (dir / "cache").c_str(), 1);
    const auto baked = [&] { return field("lawn.GrassField.ambientOcclusion") != ""; };
    ok(ui->click("Menu/Bake/Ambient Occlusion"));
    ASSERT_TRUE(app->occlusion);
    EXPECT_TRUE(ui->exists("Status/Baking"));
    ok(ui->click("Status/Cancel"));
    for (int i = 0; i < 500 && app->occlusion; ++i) ok(ui->wait(1));
    EXPECT_FALSE(baked());
    EXPECT_NE(app->notice.find("cancelled"), std::string::npos);
    app->notice.clear();
    ok(ui->click("Menu/Bake/Ambient Occlusion"));
    for (int i = 0; i < 3000 && app->occlusion; ++i) ok(ui->wait(1));
    EXPECT_TRUE(baked());
    EXPECT_FALSE(ui->exists("Status/Baking"));
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(baked());
}

}  // namespace
}  // namespace sward
