// Thumbnails in the editor: asked for by panels, made beside, followed as files and maps change.
#include "app/thumbnails.h"

#include "core/file.h"
#include "editor/editor_fixture.h"
#include "maps/map_io.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"

namespace sward {
namespace {

using test::EditorUi;

std::vector<uint8_t> pixelsOf(const Thumbnail& t) {
    std::vector<uint8_t> pixels(static_cast<size_t>(t.texture.width) * static_cast<size_t>(t.texture.height) * 4);
    glGetTextureImage(t.texture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size()), pixels.data());
    return pixels;
}

TEST_F(EditorUi, ThumbnailsOfFilesFollowThemAndSayWhatIsWrong) {
    Thumbnails t;
    t.tables = &tables();
    ASSERT_TRUE(writeImagePng(dir / "a.png", 2, 2, 4, std::vector<uint8_t>(16, 90)));
    test::writeText(dir / "bad.png", "nothing");
    EXPECT_EQ(fileThumbnail(t, dir.path, "a.png").texture.id(), 0u) << "not at once";
    followThumbnails(t, *gpu, true);
    ASSERT_NE(fileThumbnail(t, dir.path, "a.png").texture.id(), 0u);
    EXPECT_EQ(pixelsOf(fileThumbnail(t, dir.path, "a.png"))[0], 90);
    ASSERT_TRUE(writeImagePng(dir / "a.png", 2, 2, 4, std::vector<uint8_t>(16, 30)));
    EXPECT_EQ(fileThumbnail(t, dir.path, "a.png").texture.id(), 0u) << "another file of the same name";
    fileThumbnail(t, dir.path, "bad.png");
    followThumbnails(t, *gpu, true);
    EXPECT_EQ(pixelsOf(fileThumbnail(t, dir.path, "a.png"))[0], 30);
    EXPECT_EQ(fileThumbnail(t, dir.path, "bad.png").texture.id(), 0u);
    EXPECT_NE(fileThumbnail(t, dir.path, "bad.png").error, "");
    EXPECT_FALSE(makingThumbnails(t));
}

TEST_F(EditorUi, AFrameNeverWaitsForAThumbnailAndOneIsMadeAtATime) {
    Thumbnails t;
    for (int i = 0; i < 5; ++i)
        t.all["slow " + std::to_string(i)].make = [](JobControl& c) -> Result<Rgba8> {
            while (!c.cancelled()) std::this_thread::yield();
            return failed("cancelled");
        };
    EXPECT_FALSE(followThumbnails(t, *gpu, false)) << "returns though none is done";
    EXPECT_FALSE(followThumbnails(t, *gpu, false));
    const auto waits = std::count_if(t.all.begin(), t.all.end(), [](const auto& one) { return bool(one.second.make); });
    EXPECT_EQ(waits, 4);
    t.job.cancel();
}

TEST_F(EditorUi, AMapsThumbnailFollowsTheBrushAndLetsGoOfItsTiles) {
    Thumbnails t;
    Map map({4, 4, 1, PixelType::U8});
    const auto shown = [&]() -> const Thumbnail& { return mapThumbnail(t, "x.density", map, MapKind::Amounts); };
    shown();
    followThumbnails(t, *gpu, false);
    EXPECT_EQ(pixelsOf(shown())[0], 0);
    map.set(0, 0, 0, 1);
    shown();
    followThumbnails(t, *gpu, false);
    EXPECT_EQ(pixelsOf(shown())[0], 255);
    for (int i = 0; i < 4; ++i) followThumbnails(t, *gpu, false);
    EXPECT_TRUE(t.all.empty()) << "not shown any more";
}

TEST_F(EditorUi, TheObjectsTabShowsAPictureOfEachAndAClickTakesIt) {
    const Solid box;
    test::writeText(doc.project().dir / "models" / "box.glb", *encodeGlb(makeMesh({&box, 1})));
    app->layout.tab = "Objects";
    ok(ui->wait(4));
    const Thumbnail& picture = fileThumbnail(app->thumbnails, doc.project().dir, "models/box.glb");
    EXPECT_NE(picture.texture.id(), 0u) << picture.error;
    ok(ui->click("Objects/box.glb"));
    EXPECT_EQ(app->objects.placing, "models/box.glb");
    ok(ui->key("escape"));
}

TEST_F(EditorUi, TheInspectorShowsMapsAndFillsImportsAndExportsThem) {
    const std::string path = "lawn.GrassField.species[lawn].density", at = "Inspector/" + path;
    ok(ui->click("Outliner/lawn"));
    ok(ui->wait(2));
    EXPECT_EQ(get(at + "/Picture"), "true");
    const std::string file = (dir / "density.png").string();
    ok(ui->click(at + "/Export"));
    ok(ui->set("Files/Path", file));
    EXPECT_TRUE(std::filesystem::exists(file));
    const uint64_t before = density();
    ok(ui->click("Menu/Brush/Clear Map"));
    EXPECT_NE(density(), before);
    ok(ui->click(at + "/Import"));
    ok(ui->wait(2));
    ok(ui->set("Image/Path", file));
    ok(ui->click("Image/Import"));
    EXPECT_EQ(density(), before) << "what was exported came back";
    ok(ui->click("Menu/Edit/Undo"));
    EXPECT_NE(density(), before) << "in one step";
    ok(ui->click(at + "/Fill"));
    EXPECT_EQ(density(), before) << "ones everywhere, as a new project has them";
}

TEST_F(EditorUi, TheFileDialogTakesAnImageAndAnObjectFromElsewhere) {
    ASSERT_TRUE(writeImagePng(dir / "soil.png", 4, 4, 4, std::vector<uint8_t>(64, 255)));
    const Solid box;
    test::writeText(dir / "crate.glb", *encodeGlb(makeMesh({&box, 1})));
    ok(ui->click("Outliner/ground"));
    ok(ui->click("Inspector/ground.Terrain.groundTexture/Browse"));
    ok(ui->click("Files/Up"));
    ok(ui->wait(2));
    EXPECT_TRUE(ui->exists("Files/soil.png"));
    EXPECT_FALSE(ui->exists("Files/crate.glb"));
    EXPECT_NE(fileThumbnail(app->thumbnails, dir.path, "soil.png").texture.id(), 0u);
    ok(ui->click("Files/soil.png"));
    ok(ui->click("Files/Choose"));
    EXPECT_EQ(app->files.task, FileTask::None) << app->files.error;
    EXPECT_EQ(field("ground.Terrain.groundTexture"), "images/soil.png");
    ASSERT_TRUE(doc.addEntity("crate"));
    ASSERT_TRUE(doc.addComponent("crate", "StaticMesh"));
    ok(ui->click("Outliner/crate"));
    ok(ui->click("Inspector/crate.StaticMesh.file/Browse"));
    ok(ui->click("Files/Up"));
    ok(ui->click("Files/crate.glb"));
    ok(ui->click("Files/Choose"));
    EXPECT_EQ(field("crate.StaticMesh.file"), "models/crate.glb");
    ok(ui->wait(3));
    EXPECT_EQ(get("Inspector/crate.StaticMesh.file/Picture"), "true");
}

}  // namespace
}  // namespace sward
