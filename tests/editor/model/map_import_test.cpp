// Images into maps and files into fields: one undo step, or nothing.
#include "model/map_import.h"

#include <gtest/gtest.h>

#include "maps/map_io.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

class MapImports : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(doc.create(dir / "p")); }
    std::string text(const std::string& path) {
        const auto f = findField(doc.project(), tables().components, path);
        return f ? fieldText(*f) : f.error().message;
    }
    test::TempDir dir;
    Document doc{tables()};
};

TEST_F(MapImports, HeightsOfIntegersBringTheirRangeInTheSameStep) {
    Map ramp({8, 8, 1, PixelType::U16});
    ramp.set(7, 7, 0, 1);
    ASSERT_TRUE(writeMap(dir / "h.png", ramp));
    ImportOptions options;
    options.range = {-2, 30};
    ASSERT_TRUE(importIntoMap(doc, "ground.Terrain.height", dir / "h.png", options));
    EXPECT_EQ(text("ground.Terrain.heightRange"), "[-2, 30]");
    EXPECT_EQ(doc.project().imports.at("ground.Terrain.height").file, "h.png");
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(text("ground.Terrain.heightRange"), "[0, 10]");
    EXPECT_FALSE(doc.canUndo());
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
