// Layers in files: what is written, read, refused and spared.
#include "scene/map_layers.h"

#include <gtest/gtest.h>

#include "maps/map_io.h"
#include "project/import.h"
#include "project/project_files.h"
#include "tests/rows.h"
#include "tests/support.h"
#include "tests/world/layered.h"

namespace sward {
namespace {

using namespace test;
namespace fs = std::filesystem;

Project saved(const TempDir& dir, std::vector<MapLayer> layers) {
    Project p = rampLawn(40);
    p.dir = dir / "p";
    lay(p, std::move(layers));
    const auto written = saveProject(p, rows());
    EXPECT_TRUE(written) << (written ? "" : written.error().text());
    return p;
}
MapLayer notSteep() { return ruleLayer("not steep", {maskBy(MaskBy::Slope, 0, 35)}); }
MapLayer image(const char* file) {
    MapLayer layer = ruleLayer("image", {});
    layer.kind = LayerKind::Image;
    layer.amounts = field(filled({64, 32, 1, PixelType::U16}, 0.5f), file);
    return layer;
}

TEST(MapLayers, AreReadableTextInTheProjectFileAndComeBackFromIt) {
    TempDir dir;
    MapLayer muted = notSteep();
    muted.muted = true;
    muted.masks[0].to = std::numeric_limits<float>::infinity();
    saved(dir, {muted, image("maps/image.png")});
    const std::string text = readText(dir / "p/project.json");
    for (const char* line :
         {"\"muted\": true", "\"kind\": \"rule\"", "\"operation\": \"multiply\"", "\"by\": \"slope\"",
          "\"to\": \"inf\"", "\"amounts\": \"maps/image.png\"", "\"map\": \"GrassField.species[lawn].density\""})
        EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
    const Result<Project> back = loadProject(dir / "p", rows());
    ASSERT_TRUE(back) << back.error().text();
    const MapLayers& layers = *back->registry.get<MapLayers>(findEntity(*back, "grass"));
    ASSERT_EQ(layers.layers.size(), 2u);
    EXPECT_TRUE(layers.layers[0].muted);
    EXPECT_EQ(layers.layers[0].masks[0].by, MaskBy::Slope);
    EXPECT_TRUE(std::isinf(layers.layers[0].masks[0].to));
    EXPECT_EQ(layers.layers[1].amounts.map.info(), (MapInfo{64, 32, 1, PixelType::U16}));
    EXPECT_NEAR(layers.layers[1].amounts.map.at(5, 5), 0.5f, 1e-4f);
}

TEST(MapLayers, OfNobodyLeaveNoTrace) {
    TempDir dir;
    Project p = rampLawn(40);
    p.dir = dir / "p";
    ASSERT_TRUE(saveProject(p, rows()));
    EXPECT_EQ(readText(dir / "p/project.json").find("ayers"), std::string::npos);
    EXPECT_FALSE(hasLayers(p));
    lay(p, {notSteep()});
    EXPECT_TRUE(hasLayers(p));
}

// A project file whose grass has these layers, from line 3 on.
std::string withLayersText(const std::string& layers) {
    return "{\"format\": 2, \"entities\": {\"grass\": {\"GrassField\": {}, \"MapLayers\": {\n\"layers\": [\n" + layers +
           "\n]}}}}";
}

struct Refused {
    const char* layers;
    const char* message;
};
TEST(MapLayers, OfBadFilesAreRefusedNamingFilePlaceAndRemedy) {
    for (const Refused& row :
         {Refused{"{\"name\": \"a\", \"kind\": \"fill\"}",
                  "grass.MapLayers.layers[a].kind: \"fill\" is none of its values (it takes \"rule\", \"image\", "
                  "\"painted\", \"path\")"},
          Refused{"{\"name\": \"a\", \"opacity\": 1.5}",
                  "grass.MapLayers.layers[a].opacity: 1.5 is out of range (it takes 0 to 1)"},
          Refused{"{\"name\": \"a\", \"operation\": \"xor\"}",
                  "grass.MapLayers.layers[a].operation: \"xor\" is none of its values (it takes \"multiply\", \"add\", "
                  "\"subtract\", \"replace\", \"minimum\", \"maximum\")"},
          Refused{"{\"name\": \"a\", \"masks\": [{\"name\": \"m\", \"by\": \"colour\"}]}",
                  "grass.MapLayers.layers[a].masks[m].by: \"colour\" is none of its values"},
          Refused{"{\"name\": \"a\", \"masks\": [{\"name\": \"m\", \"falloff\": -1}]}",
                  "grass.MapLayers.layers[a].masks[m].falloff: -1 must not be negative"},
          Refused{"{\"name\": \"a\", \"amounts\": \"../out.png\"}", "grass.MapLayers.layers[a].amounts:"}}) {
        TempDir dir;
        writeText(dir / "p/project.json", withLayersText(row.layers));
        const Result<Project> p = loadProject(dir / "p", rows());
        ASSERT_FALSE(p) << row.layers;
        EXPECT_EQ(p.error().code, ExitCode::Unsound);
        EXPECT_EQ(p.error().text().find((dir / "p/project.json").string() + ":3:"), 0u) << p.error().text();
        EXPECT_NE(p.error().text().find(row.message), std::string::npos) << p.error().text();
    }
}

TEST(MapLayers, WhoseImageIsGoneAreKeptAndSaidAndWorkOnceItIsBack) {
    TempDir dir;
    saved(dir, {image("maps/image.png")});
    fs::rename(dir / "p/maps/image.png", dir / "image.png");
    LoadReport report;
    Result<Project> p = loadProject(dir / "p", rows(), &report);
    ASSERT_TRUE(p) << p.error().text();
    ASSERT_EQ(report.repaired.size(), 1u);
    EXPECT_EQ(report.repaired[0].where, (dir / "p/maps/image.png").string());
    EXPECT_EQ(report.repaired[0].message,
              "grass.MapLayers.layers[image].amounts: the file is not there; the layer does nothing until it is back");
    const CheckReport check = checkProject(dir / "p", rows());
    EXPECT_TRUE(check.refused.empty());
    ASSERT_EQ(check.noticed.size(), 1u) << (check.noticed.size() > 1 ? check.noticed[1].message : "");
    EXPECT_NE(check.noticed[0].message.find("its file maps/image.png is not there"), std::string::npos);
    const std::string text = readText(dir / "p/project.json");
    p->name = "renamed";
    ASSERT_TRUE(saveProject(*p, rows()));
    EXPECT_NE(readText(dir / "p/project.json").find("maps/image.png"), std::string::npos) << "kept in the file";
    fs::rename(dir / "image.png", dir / "p/maps/image.png");
    p->name = "again";
    ASSERT_TRUE(saveProject(*p, rows()));
    EXPECT_TRUE(fs::exists(dir / "p/maps/image.png")) << "saving leaves it where it is";
    p = loadProject(dir / "p", rows(), &report);
    ASSERT_TRUE(p);
    EXPECT_TRUE(p->registry.get<MapLayers>(findEntity(*p, "grass"))->layers[0].amounts.present());
}

TEST(MapLayers, WhoseImageIsDamagedAreRefused) {
    TempDir dir;
    saved(dir, {image("maps/image.png")});
    writeText(dir / "p/maps/image.png", "no image");
    const Result<Project> p = loadProject(dir / "p", rows());
    ASSERT_FALSE(p);
    EXPECT_EQ(p.error().file, (dir / "p/maps/image.png").string());
    EXPECT_EQ(p.error().message.find("grass.MapLayers.layers[image].amounts: "), 0u) << p.error().message;
}

TEST(MapLayers, MasksWithTheirEndsSwappedArePulledInOrder) {
    TempDir dir;
    writeText(dir / "p/project.json",
              withLayersText("{\"name\": \"a\", \"masks\": [{\"name\": \"m\", \"from\": 9, \"to\": 2}]}"));
    LoadReport report;
    const Result<Project> p = loadProject(dir / "p", rows(), &report);
    ASSERT_TRUE(p) << p.error().text();
    ASSERT_EQ(report.repaired.size(), 1u);
    EXPECT_EQ(report.repaired[0].message,
              "grass.MapLayers: mask \"m\" of layer \"a\": from lay above to; they are swapped now");
    EXPECT_EQ(p->registry.get<MapLayers>(findEntity(*p, "grass"))->layers[0].masks[0].to, 9);
}

TEST(MapLayers, AreInTheMapThatIsExported) {
    TempDir dir;
    const Project p = saved(dir, {notSteep()});
    ASSERT_TRUE(exportMap(p, rows(), "density", dir / "out.png"));
    const Result<Map> out = readMap(dir / "out.png", {});
    ASSERT_TRUE(out);
    EXPECT_EQ(at(*out, 15, 5), 0);
    EXPECT_NEAR(at(*out, 5, 5), 0.8f, 1e-4f);
}

TEST(MapLayers, AnImageIsImportedIntoItsLayerFlippedAndRanged) {
    TempDir dir;
    Project p = saved(dir, {image("maps/image.png")});
    Map steps({1, 2, 1, PixelType::F32});
    steps.set(0, 0, 0, 10), steps.set(0, 1, 0, 30);
    ASSERT_TRUE(writeMap(dir / "in.exr", steps));
    ImportOptions options;
    options.flip = true;
    options.range = {10.0, 50.0};
    ASSERT_TRUE(importMap(p, rows(), "layers[image].amounts", dir / "in.exr", options));
    const Map& map = p.registry.get<MapLayers>(findEntity(p, "grass"))->layers[0].amounts.map;
    EXPECT_NEAR(map.at(0, 0), 0.5f, 1e-4f);
    EXPECT_EQ(map.at(0, 1), 0);
    EXPECT_EQ(p.imports.at("grass.MapLayers.layers[image].amounts").flip, true);
}

TEST(MapLayers, HaveOnePathEach) {
    MapLayers of;
    of.layers.resize(3);
    of.layers[0].name = "a", of.layers[1].name = "b", of.layers[2].name = "b";
    EXPECT_EQ(layerPaths("grass", of),
              (std::vector<std::string>{"grass.MapLayers.layers[a]", "grass.MapLayers.layers[1]",
                                        "grass.MapLayers.layers[2]"}));
    of.layers[0].map = "GrassField.bladeHeight";
    EXPECT_EQ(layeredPath("grass", of.layers[0]), "grass.GrassField.bladeHeight");
}

}  // namespace
}  // namespace sward
