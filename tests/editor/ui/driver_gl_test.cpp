// The driver of scripts and tests: widgets by their paths, and what is said of those that are not there.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

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
                              "Tools/Select",
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
                              "Inspector/lawn.HybridTiers.maxGeom",
                              "Inspector/ground.Terrain.size",
                              "Inspector/sun.Light.elevationDeg",
                              "Tabs/Console",
                              "Profiler/Measure",
                              "Status/Blades",
                              "Status/Saved"})
        EXPECT_TRUE(ui->exists(label)) << label;
    EXPECT_FALSE(ui->exists("Brush/Nothing"));
    EXPECT_FALSE(ui->exists("Inspector/nobody.HybridTiers.maxGeom"));
    const Status missing = ui->click("Nowhere/Nothing");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ExitCode::Usage);
}

}  // namespace
}  // namespace sward
