// Integer heights made floats.
#include "editor/model/float_heights.h"

#include <gtest/gtest.h>

#include "support.h"
#include "techniques.h"
#include "world/ground.h"

namespace sward {
namespace {

TEST(FloatHeights, StandWhereTheIntegersStoodAndAreOneStep) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    const auto none = heightsAsFloats(doc);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text().find("no map of heights"), std::string::npos);
    Map map({200, 130, 1, PixelType::U16});
    for (int y = 0; y < 130; ++y)
        for (int x = 0; x < 200; ++x) map.set(x, y, 0, static_cast<float>((x * 7 + y * 13) % 100) / 100.0f);
    ASSERT_TRUE(doc.setField("ground.Terrain.heightRange", "-20 300"));
    ASSERT_TRUE(doc.setMap("ground.Terrain.height", map, "heights"));
    const auto height = [&](double x, double z) { return terrainHeight(*findGround(doc.project()).terrain, x, z); };
    const double here = height(11.3, 27.2), corner = height(0, 0);
    ASSERT_TRUE(heightsAsFloats(doc));
    EXPECT_EQ(findGround(doc.project()).terrain->height.map.info().type, PixelType::F32);
    EXPECT_NEAR(height(11.3, 27.2), here, 1e-4);
    EXPECT_NEAR(height(0, 0), corner, 1e-4);
    EXPECT_FALSE(heightsAsFloats(doc)) << "they are";
    ASSERT_TRUE(doc.save());
    Document again(tables());
    ASSERT_TRUE(again.open(dir / "p"));
    EXPECT_NEAR(terrainHeight(*findGround(again.project()).terrain, 11.3, 27.2), here, 1e-4);
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(findGround(doc.project()).terrain->height.map.hash(), map.hash());
}

}  // namespace
}  // namespace sward
