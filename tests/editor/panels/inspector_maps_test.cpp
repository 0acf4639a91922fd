// The inspector's maps and files: what is said of them, and what their buttons ask for.
#include "panels/inspector_maps.h"

#include "app/file_tasks.h"
#include "app/image_tasks.h"
#include "app/thumbnails.h"
#include "editor/panels/panel_stage.h"
#include "model/layer_edits.h"
#include "tools/brush_book.h"

namespace sward {
namespace {

constexpr const char* kMap = "lawn.GrassField.bladeHeight";  // that a new project has none of

class InspectorMaps : public test::PanelStage {
  protected:
    void SetUp() override {
        PanelStage::SetUp();
        thumbnails.tables = &doc.tables();
        draw = [this] {
            FieldParts parts = fieldParts();
            parts.files = &files, parts.images = &images, parts.brushes = &brushes, parts.waiting = &waiting;
            drawMapField(parts, *findField(doc.project(), doc.tables().components, path));
        };
    }
    std::string texels() { return frames(2), value("Panel/" + path + "/Texels"); }
    FileDialog files;
    ImageDialog images;
    BrushBook brushes;
    Thumbnails thumbnails;
    std::string path = kMap;
};

TEST_F(InspectorMaps, AMapThatIsNotThereCanBeFilledButNotExported) {
    EXPECT_EQ(texels(), "none");
    EXPECT_FALSE(shown("Panel/" + path + "/Export"));
    click("Panel/" + path + "/Fill");
    frames(2);
    EXPECT_NE(texels(), "none");
    EXPECT_TRUE(shown("Panel/" + path + "/Export"));
    EXPECT_TRUE(doc.undo());
    EXPECT_EQ(texels(), "none");
}

TEST_F(InspectorMaps, WhatLiesOverAMapIsSaidWithIt) {
    ASSERT_TRUE(addLayer(doc, kMap, LayerKind::Rule));
    EXPECT_EQ(texels(), "none, 1 layer over it");
    ASSERT_TRUE(doc.undo());
    ASSERT_TRUE(doc.addComponent("lawn", "Flowers"));
    ASSERT_TRUE(doc.setMap("lawn.Flowers.density", Map({8, 8, 1, PixelType::U8}), "bare"));
    path = "lawn.Flowers.density";
    EXPECT_EQ(texels(), "nothing painted yet");
    ASSERT_TRUE(addLayer(doc, path, LayerKind::Rule));
    ASSERT_TRUE(addLayer(doc, path, LayerKind::Painted));
    EXPECT_EQ(texels(), "nothing painted, 2 layers over it");
}

TEST_F(InspectorMaps, ImportAndExportAskForTheFileOfThisMap) {
    click("Panel/" + path + "/Import");
    EXPECT_EQ(images.task, ImageTask::Map);
    EXPECT_EQ(images.map, kMap);
    click("Panel/" + path + "/Fill");
    click("Panel/" + path + "/Export");
    EXPECT_EQ(files.task, FileTask::ExportMap);
    EXPECT_EQ(files.field, kMap);
}

TEST_F(InspectorMaps, HeightsAreNotFilled) {
    path = "ground.Terrain.height";
    frames(2);
    EXPECT_TRUE(shown("Panel/" + path + "/Import"));
    EXPECT_FALSE(shown("Panel/" + path + "/Fill"));
}

}  // namespace
}  // namespace sward
