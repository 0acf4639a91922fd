#include "project/packed_map.h"

#include <gtest/gtest.h>

#include "fields.h"
#include "maps/map_io.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

using namespace test;

using test::TempDir;

Map ramp(int side, PixelType type, int by) {
    Map m({side, side, 1, type});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) m.set(x, y, 0, static_cast<float>((x * by + y * 5) % 256) / 255.0f);
    return m;
}
FlatField grassIn(Project& p) { return flatField(p, "grass"); }
const auto kRows = tables().components;

TEST(PackedMap, ARoundTripKeepsDensityAndHeightsToTheBit) {
    const TempDir dir;
    Project p = test::lawn();
    FlatField f = grassIn(p);
    f.species[0].density = {"maps/d.png", ramp(70, PixelType::U16, 3)};
    f.bladeHeight = {"maps/h.png", ramp(70, PixelType::U8, 7)};
    f.species[0].densityTiling = f.bladeHeightTiling = 4;
    for (const char* file : {"packed.png", "packed.exr", "packed.tif"}) {
        ASSERT_TRUE(exportPacked(p, kRows, "density", dir / file)) << file;
        Project q = test::lawn();
        grassIn(q).species[0].densityTiling = 4;
        std::vector<std::string> said;
        const Status read = importPacked(q, kRows, "density", dir / file, {}, &said);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(grassIn(q).species[0].density.map.hash(), f.species[0].density.map.hash()) << file;
        EXPECT_EQ(grassIn(q).bladeHeight.map.hash(), f.bladeHeight.map.hash()) << file;
        EXPECT_EQ(grassIn(q).bladeHeightTiling, 4) << "heights repeat as the density does";
        EXPECT_TRUE(said.empty()) << said[0];
    }
}

TEST(PackedMap, ChannelsAreThePapers) {
    const TempDir dir;
    Project p = test::lawn();
    grassIn(p).species[0].density = {"maps/d.png", test::filled({8, 8, 1, PixelType::U16}, 0.8f)};
    grassIn(p).bladeHeight = {"maps/h.png", test::filled({4, 4, 1, PixelType::U8}, 0.6f)};
    ASSERT_TRUE(exportPacked(p, kRows, "density", dir / "packed.png"));
    const Result<Image> image = readImage(dir / "packed.png");
    ASSERT_TRUE(image);
    ASSERT_EQ(image->channels, 3);
    EXPECT_EQ(image->width, 8) << "of the density's size";
    EXPECT_NEAR(image->pixels[0], 0.8, 1e-4);
    EXPECT_NEAR(image->pixels[1], 0.8 * kCoarseShare, 1e-4);
    EXPECT_NEAR(image->pixels[2], 0.6, 1e-4);
}

TEST(PackedMap, AGreenChannelOfItsOwnIsReadOverAndSaid) {
    const TempDir dir;
    ASSERT_TRUE(writeMap(dir / "own.png", test::filled({4, 4, 4, PixelType::U8}, 0.5f)));
    Project p = test::lawn();
    std::vector<std::string> said;
    ASSERT_TRUE(importPacked(p, kRows, "density", dir / "own.png", {}, &said));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("green"), std::string::npos);
    EXPECT_NEAR(grassIn(p).bladeHeight.map.mean(), 0.5, 0.01);
}

TEST(PackedMap, WhatIsNoPackedMapIsRefusedAndChangesNothing) {
    const TempDir dir;
    ASSERT_TRUE(writeMap(dir / "grey.png", test::filled({4, 4, 1, PixelType::U8}, 0.5f)));
    Project p = test::lawn();
    const Status grey = importPacked(p, kRows, "density", dir / "grey.png");
    ASSERT_FALSE(grey);
    EXPECT_EQ(grey.error().code, ExitCode::Unsound);
    EXPECT_FALSE(importPacked(p, kRows, "vegetation", dir / "grey.png"));
    EXPECT_FALSE(grassIn(p).species[0].density.present() || grassIn(p).bladeHeight.present());
    EXPECT_FALSE(exportPacked(p, kRows, "density", dir / "none.png")) << "there is neither map";
    grassIn(p).species[0].density = {"maps/d.png", ramp(8, PixelType::U16, 3)};
    grassIn(p).bladeHeight = {"maps/h.png", ramp(8, PixelType::U8, 3)};
    grassIn(p).bladeHeightTiling = 2;
    const Status apart = exportPacked(p, kRows, "density", dir / "apart.png");
    ASSERT_FALSE(apart);
    EXPECT_EQ(apart.error().code, ExitCode::Usage);
}

}  // namespace
}  // namespace sward
