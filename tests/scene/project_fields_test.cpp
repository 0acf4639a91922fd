// Fields and maps by PATH, their values as text, snapshots, imports.
#include <gtest/gtest.h>

#include "fields.h"
#include "maps/map_io.h"
#include "project/import.h"
#include "project/project_files.h"
#include "scene/project.h"
#include "tests/maps/images.h"
#include "tests/rows.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {
// Ground and a meadow of two species.
Project fieldsMeadow() {
    Project p;
    p.registry.add<Terrain>(*addEntity(p, "ground"));
    GrassField field;
    field.species.resize(2);
    field.species[0].name = "lawn";
    field.species[1].name = "weeds";
    p.registry.add<GrassField>(*addEntity(p, "meadow"), std::move(field));
    return p;
}
FlatField grassOf(Project& p) { return flatField(p, "meadow"); }
std::string pathOf(Project& p, const std::string& path) {
    const Result<FieldRef> f = findField(p, rows(), path);
    return f ? f->path : f.error().text();
}
std::string mapOf(Project& p, const std::string& name) {
    const Result<FieldRef> f = findMap(p, rows(), name);
    return f ? f->path : f.error().text();
}
}  // namespace

TEST(Fields, AreAsChangeableAsTheProjectThatTheyAreFoundIn) {
    Project p = fieldsMeadow();
    const Result<FieldRef> ours = findField(p, rows(), "ground.Terrain.gridSpacing");
    const Result<ConstFieldRef> read = findField(std::as_const(p), rows(), "ground.Terrain.gridSpacing");
    ASSERT_TRUE(ours && read);
    ASSERT_TRUE(setFieldText(*ours, "0.5"));
    EXPECT_EQ(fieldText(*read), "0.5");
    EXPECT_EQ(fieldText(*ours), "0.5") << "what may be changed may be read";
    EXPECT_EQ(allMaps(std::as_const(p), rows(), true).size(), allMaps(p, rows(), true).size());
}

TEST(Entities, AreNamedOnceAndWithPlainNames) {
    Project p;
    ASSERT_TRUE(addEntity(p, "a-1_B"));
    EXPECT_NE(addEntity(p, "a-1_B").error().message.find("already"), std::string::npos);
    for (const char* bad : {"", "a b", "a.b", "a[0]", "\u00e4"}) EXPECT_FALSE(addEntity(p, bad)) << bad;
    EXPECT_TRUE(p.registry.valid(findEntity(p, "a-1_B")));
    EXPECT_EQ(findEntity(p, "none"), kNoEntity);
    EXPECT_TRUE(removeEntity(p, "a-1_B"));
    EXPECT_FALSE(removeEntity(p, "a-1_B"));
    EXPECT_EQ(p.registry.size(), 0u);
}

TEST(Fields, AreFoundByPathAndCanonicalPathsUseNames) {
    Project p = fieldsMeadow();
    EXPECT_EQ(pathOf(p, "ground.Terrain.size"), "ground.Terrain.size");
    EXPECT_EQ(pathOf(p, "meadow.GrassField.species[1].height"), "meadow.GrassField.species[weeds].height");
    EXPECT_EQ(pathOf(p, "meadow.GrassField.species[weeds].height"), "meadow.GrassField.species[weeds].height");
    EXPECT_EQ(pathOf(p, "meadow.GrassField.species"), "meadow.GrassField.species");
    grassOf(p).species[1].name = "lawn";
    EXPECT_EQ(pathOf(p, "meadow.GrassField.species[1].height"), "meadow.GrassField.species[1].height")
        << "a name that repeats selects none";
    grassOf(p).species[1].name = "7";
    EXPECT_EQ(pathOf(p, "meadow.GrassField.species[1].height"), "meadow.GrassField.species[1].height")
        << "a number is no name";
}

TEST(Fields, WhatIsNotThereIsAUsageErrorThatListsWhatIs) {
    Project p = fieldsMeadow();
    for (const char* bad :
         {"", "ground", "ground.Terrain", "none.Terrain.size", "ground.Light.intensity", "ground.Terrain.sise",
          "ground.Terrain.size.x", "meadow.GrassField.species.height", "meadow.GrassField.species[none].height",
          "meadow.GrassField.species[2].height", "meadow.GrassField.species[lawn", "meadow.GrassField.species[lawn]",
          "ground..size", "ground.Terrain.size.", "ground.Terrain.[0]"}) {
        const Result<FieldRef> f = findField(p, rows(), bad);
        ASSERT_FALSE(f) << bad;
        EXPECT_EQ(f.error().code, ExitCode::Usage) << bad;
    }
    EXPECT_NE(pathOf(p, "none.Terrain.size").find("there are: ground, meadow"), std::string::npos);
    EXPECT_NE(pathOf(p, "ground.Light.intensity").find("it has: Terrain"), std::string::npos);
    EXPECT_NE(pathOf(p, "ground.Terrain.sise").find("gridSpacing"), std::string::npos);
    EXPECT_NE(pathOf(p, "meadow.GrassField.species[none].height").find("there are: lawn, weeds"), std::string::npos);
}

TEST(Maps, AreFoundByAnyTailThatMeansOne) {
    Project p = fieldsMeadow();
    EXPECT_NE(mapOf(p, "density").find("more than one map"), std::string::npos);
    EXPECT_EQ(mapOf(p, "height"), "ground.Terrain.height");
    EXPECT_EQ(mapOf(p, "[weeds].density"), "meadow.GrassField.species[weeds].density");
    EXPECT_EQ(mapOf(p, "meadow.GrassField.species[1].density"), "meadow.GrassField.species[weeds].density");
    EXPECT_NE(mapOf(p, "ensity").find("no map is called"), std::string::npos);
    EXPECT_NE(mapOf(p, "").find("no map is called"), std::string::npos);
    grassOf(p).species[0].density = {"maps/a.png", patternMap({4, 4, 1, PixelType::U16})};
    EXPECT_EQ(mapOf(p, "density"), "meadow.GrassField.species[lawn].density")
        << "one that is there goes before one that is not";
    EXPECT_EQ(allMaps(p, rows()).size(), 1u);
    EXPECT_EQ(allMaps(p, rows(), true).size(), 9u);
}

TEST(Maps, FilesAreNamedAfterEntitySpeciesAndMap) {
    Project p = fieldsMeadow();
    EXPECT_EQ(mapFileFor(*findMap(p, rows(), "[weeds].density"), {1, 1, 1, PixelType::U16}),
              "maps/meadow.weeds.density.png");
    EXPECT_EQ(mapFileFor(*findMap(p, rows(), "height"), {1, 1, 1, PixelType::F32}), "maps/ground.height.exr");
    grassOf(p).species[1].name = "../../etc x";
    EXPECT_EQ(mapFileFor(*findMap(p, rows(), "species[1].density"), {1, 1, 1, PixelType::U16}),
              "maps/meadow.1.density.png");
    p.registry.get<Terrain>(findEntity(p, "ground"))->height.file = "maps/dem.tif";
    EXPECT_EQ(mapFileFor(*findMap(p, rows(), "height"), {1, 1, 1, PixelType::F32}), "maps/dem.tif");
    p.registry.get<Terrain>(findEntity(p, "ground"))->height.file = "maps/dem.png";
    EXPECT_EQ(mapFileFor(*findMap(p, rows(), "height"), {1, 1, 1, PixelType::F32}), "maps/dem.exr")
        << "PNG holds no floats";
}

TEST(Snapshots, ShareTilesAndNothingElse) {
    Project p = fieldsMeadow();
    p.unknown["meadow.Wings"] = "1";
    grassOf(p).species[0].density = {"maps/a.png", patternMap({300, 300, 1, PixelType::U16})};
    Project copy = snapshot(p, rows());
    EXPECT_TRUE(grassOf(copy).species[0].density.map.sameTiles(grassOf(p).species[0].density.map));
    EXPECT_EQ(copy.unknown, p.unknown);
    grassOf(copy).species[0].density.map.set(0, 0, 0, 0.5f);
    grassOf(copy).seed = 77;
    EXPECT_NE(grassOf(copy).species[0].density.map.hash(), grassOf(p).species[0].density.map.hash());
    EXPECT_EQ(grassOf(p).seed, GrassField().seed);
    EXPECT_TRUE(removeEntity(copy, "meadow"));
    EXPECT_TRUE(p.registry.valid(findEntity(p, "meadow")));
}

TEST(Population, IsDensityTimesAreaOverAllSpecies) {
    Project p = fieldsMeadow();
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {10, 20};
    grassOf(p).species[0].bladesPerM2 = 100;
    grassOf(p).species[1].bladesPerM2 = 50;
    EXPECT_DOUBLE_EQ(virtualBlades(p), 150.0 * 200);
    Map half({4, 4, 1, PixelType::F32});
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 2; ++y) half.set(x, y, 0, 1);
    grassOf(p).species[0].density = {"maps/a.exr", half};
    EXPECT_DOUBLE_EQ(virtualBlades(p), (50.0 + 50) * 200);
    removeEntity(p, "ground");
    EXPECT_EQ(virtualBlades(p), 0);
}
