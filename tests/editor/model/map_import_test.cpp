// Images into maps: whole, flipped, one step; heights into a rectangle of the ground; files into fields.
#include "model/map_import.h"

#include <gtest/gtest.h>

#include "maps/map_io.h"
#include "support.h"
#include "techniques.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr const char* kImportedMap = "lawn.GrassField.species[lawn].density";
constexpr const char* kHeight = "ground.Terrain.height";

class MapImports : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(doc.create(dir / "p")); }
    const Map& map(const std::string& path) {
        return static_cast<const MapField*>(findField(doc.project(), tables().components, path)->value)->map;
    }
    double height(double x, double z) { return terrainHeight(*findGround(doc.project()).terrain, x, z); }
    // 16 bits, rising from 0 at the left to full scale at the right.
    std::string slope() {
        Map ramp({64, 32, 1, PixelType::U16});
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x) ramp.set(x, y, 0, (static_cast<float>(x) + 0.5f) / 64);
        EXPECT_TRUE(writeMap(dir / "slope.png", ramp));
        return (dir / "slope.png").string();
    }
    std::string text(const std::string& path) {
        const auto f = findField(doc.project(), tables().components, path);
        return f ? fieldText(*f) : f.error().message;
    }
    test::TempDir dir;
    Document doc{tables()};
};

TEST_F(MapImports, AnImageBecomesAMapFlippedAsAskedInOneStep) {
    Map image({4, 2, 1, PixelType::U16});
    image.set(0, 0, 0, 1);
    ASSERT_TRUE(writeMap(dir / "a.png", image));
    for (const bool x : {false, true})
        for (const bool z : {false, true}) {
            ASSERT_TRUE(importIntoMap(doc, kImportedMap, dir / "a.png", {.flip = z, .range = {}}, x));
            EXPECT_EQ(map(kImportedMap).at(x ? 3 : 0, z ? 1 : 0), 1) << x << z;
            EXPECT_EQ(map(kImportedMap).mean(), 1 / 8.0);
        }
    EXPECT_EQ(doc.stepsDone(), 4u);
    const Status missing = importIntoMap(doc, kImportedMap, dir / "none.png");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().text().find("none.png"), std::string::npos);
    EXPECT_EQ(doc.stepsDone(), 4u);
}

TEST_F(MapImports, HeightsBringTheirRange) {
    ImportOptions options;
    options.range = {{-10, 30}};
    ASSERT_TRUE(importIntoMap(doc, kHeight, slope(), options));
    EXPECT_EQ(doc.project().imports.at(kHeight).file, "slope.png");
    EXPECT_NEAR(height(39.5, 20), -10 + 40 * 39.5 / 40, 0.05);
    ASSERT_TRUE(doc.undo());
    EXPECT_FALSE(doc.canUndo());
    EXPECT_FALSE(findGround(doc.project()).terrain->height.present());
}

TEST_F(MapImports, HeightsComeIntoARectangleAndFadeAtItsRim) {
    const Result<Map> source = readHeights(slope());
    ASSERT_TRUE(source);
    HeightPlace place;
    place.at = {8, 12}, place.size = {16, 8}, place.low = 2, place.high = 6, place.falloff = 0;
    ASSERT_TRUE(placeHeights(doc, *source, place));
    EXPECT_EQ(doc.stepsDone(), 1u);
    for (const double x : {9.0, 16.0, 23.0}) EXPECT_NEAR(height(x, 16), 2 + 4 * (x - 8) / 16, 0.02) << x;
    for (const auto& [x, z] : {std::pair{7.0, 16.0}, {25.0, 16.0}, {16.0, 11.0}, {16.0, 21.0}})
        EXPECT_EQ(height(x, z), 0) << x << " " << z;
    ASSERT_TRUE(doc.undo());
    EXPECT_FALSE(findGround(doc.project()).terrain->height.present());
    place.falloff = 0.5f, place.flipX = true;
    ASSERT_TRUE(placeHeights(doc, *source, place));
    EXPECT_NEAR(height(16, 16), 4, 0.02) << "the middle, beyond the rim of 2 m";
    EXPECT_NEAR(height(9, 16), 0.5 * (6 - 4.0 / 16), 0.05) << "half way into the rim, turned round";
    EXPECT_LT(height(8.2, 16), 0.3);
}

TEST_F(MapImports, WhatIsPreviewedIsWhatIsPlaced) {
    const Result<Map> source = readHeights(slope());
    HeightPlace place;
    place.at = {5, 5}, place.size = {20, 25}, place.low = -3, place.high = 9;
    std::vector<double> before;
    ASSERT_TRUE(doc.createMap(kHeight));
    const double texel = 40.0 / map(kHeight).info().width;
    const auto at = [&](int i) { return glm::dvec2((i * 7 % 160 + 0.5) * texel, (i * 13 % 160 + 0.5) * texel); };
    for (int i = 0; i < 40; ++i) before.push_back(placedHeight(*source, place, at(i).x, at(i).y, 0, texel));
    ASSERT_TRUE(placeHeights(doc, *source, place));
    for (int i = 0; i < 40; ++i) EXPECT_NEAR(height(at(i).x, at(i).y), before[static_cast<size_t>(i)], 1e-4) << i;
}

TEST_F(MapImports, AFinePictureIsAveragedAndACoarseOneSmooth) {
    Map checks({256, 256, 1, PixelType::F32});
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) checks.set(x, y, 0, (x + y) % 2 ? 10.0f : 0.0f);
    HeightPlace place;
    place.at = {10, 10}, place.size = {10, 10}, place.falloff = 0;  // 25 texels a metre, the ground has 6
    ASSERT_TRUE(placeHeights(doc, checks, place));
    EXPECT_NEAR(height(15, 15), 5, 0.5);
    EXPECT_NEAR(height(15.3, 14.7), 5, 0.5);
}

TEST_F(MapImports, BadPlacesAreRefusedAndWhatIsBeyondTheRangeIsTold) {
    const Result<Map> source = readHeights(slope());
    HeightPlace place;
    place.size = {0, 5};
    EXPECT_FALSE(placeHeights(doc, *source, place));
    place.size = {5, 5}, place.at = {50, 0};
    const Status beside = placeHeights(doc, *source, place);
    ASSERT_FALSE(beside);
    EXPECT_NE(beside.error().text().find("beside the terrain"), std::string::npos);
    place.at = {NAN, 0};
    EXPECT_FALSE(placeHeights(doc, *source, place));
    place.at = {0, 0}, place.falloff = 2;
    EXPECT_FALSE(placeHeights(doc, *source, place));
    EXPECT_FALSE(doc.canUndo());
    Map low({256, 256, 1, PixelType::U16});
    ASSERT_TRUE(doc.setMap(kHeight, low, "heights"));
    place.falloff = 0, place.low = -100, place.high = 1000;
    size_t beyond = 0;
    ASSERT_TRUE(placeHeights(doc, *source, place, &beyond));
    EXPECT_GT(beyond, 100u);
    Map image({8, 8, 1, PixelType::U8});
    ASSERT_TRUE(writeMap(dir / "8.png", image));
    EXPECT_FALSE(readHeights((dir / "8.png").string())) << "never 8 bits";
    ASSERT_TRUE(doc.setField("ground.Terrain.heightTiling", "2"));
    const Status repeats = placeHeights(doc, *source, place);
    ASSERT_FALSE(repeats);
    EXPECT_NE(repeats.error().text().find("repeats"), std::string::npos);
}

TEST_F(MapImports, WhatCannotBeReadChangesNothing) {
    test::writeText(dir / "h.png", "no image");
    EXPECT_FALSE(importIntoMap(doc, "ground.Terrain.height", dir / "h.png"));
    EXPECT_FALSE(importIntoMap(doc, "ground.Terrain.nothing", dir / "h.png"));
    EXPECT_FALSE(chooseFile(doc, "ground.Terrain.groundTexture", dir / "h.png"));
    EXPECT_FALSE(chooseFile(doc, "ground.Terrain.size", dir / "h.png"));
    EXPECT_FALSE(doc.canUndo());
    EXPECT_FALSE(std::filesystem::exists(dir / "p" / "images"));
}

TEST_F(MapImports, AnImageFromElsewhereIsCopiedOnceAndOneOfTheProjectStays) {
    ASSERT_TRUE(writeImagePng(dir / "soil.png", 2, 2, 4, std::vector<uint8_t>(16, 9)));
    ASSERT_TRUE(chooseFile(doc, "ground.Terrain.groundTexture", dir / "soil.png"));
    EXPECT_EQ(text("ground.Terrain.groundTexture"), "images/soil.png");
    EXPECT_TRUE(std::filesystem::exists(dir / "p" / "images" / "soil.png"));
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(text("ground.Terrain.groundTexture"), "");
    ASSERT_TRUE(chooseFile(doc, "ground.Terrain.groundTexture", dir / "p" / "images" / "soil.png"));
    EXPECT_EQ(text("ground.Terrain.groundTexture"), "images/soil.png");
}

}  // namespace
}  // namespace sward
