#include "model/path_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/ground_path.h"
#include "support.h"
#include "techniques.h"
#include "world/ground.h"

namespace sward {
namespace {

// 40 x 40 m, and a path from west to east.
struct PathGround : testing::Test {
    test::TempDir dir;
    Document doc{tables()};
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "p"));
        ASSERT_TRUE(doc.addEntity("way"));
        ASSERT_TRUE(doc.addComponent("way", "GroundPath"));
        for (int i = 0; i < 2; ++i) {
            ASSERT_TRUE(doc.addListElement("way.GroundPath.points"));
            ASSERT_TRUE(doc.setField(fmt::format("way.GroundPath.points[{}].at", i), i ? "[35, 20]" : "[5, 20]"));
        }
        ASSERT_TRUE(doc.setField("way.GroundPath.width", "2"));
        ASSERT_TRUE(doc.setField("way.GroundPath.falloff", "3"));
    }
    void setHeights(PixelType type) {
        Map map({400, 400, 1, type});
        for (int y = 0; y < 400; ++y)
            for (int x = 0; x < 400; ++x)
                map.set(x, y, 0, static_cast<float>(0.2 + 0.001 * x + 0.001 * y));  // up eastwards and southwards
        ASSERT_TRUE(doc.setMap("ground.Terrain.height", map, "heights"));
    }
    double height(double x, double z) { return terrainHeight(*findGround(doc.project()).terrain, x, z); }
};

TEST_F(PathGround, BecomesLevelAcrossThePathAndKeepsItsRiseAlong) {
    for (const PixelType type : {PixelType::F32, PixelType::U16}) {
        setHeights(type);
        const double scale = type == PixelType::F32 ? 1 : 10;
        const double here = height(20, 20), east = height(30, 20), beside = height(20, 25), half = height(20, 22.5);
        ASSERT_TRUE(flattenAlong(doc, "way"));
        EXPECT_NEAR(height(20, 20), here, 1e-3 * scale);
        EXPECT_NEAR(height(20, 20.8), here, 2e-3 * scale) << "level across";
        EXPECT_NEAR(height(20, 19.2), here, 2e-3 * scale);
        EXPECT_NEAR(height(30, 20.5), east, 2e-3 * scale) << "the hill is still climbed";
        EXPECT_NEAR(height(20, 25), beside, 1e-6) << "beyond the falloff nothing moved";
        EXPECT_NEAR(height(20, 22.5), (half + here) / 2, 2e-3 * scale) << "half-way down the falloff";
        EXPECT_EQ(doc.undoLabel(), "flatten along way");
        ASSERT_TRUE(doc.undo());
        EXPECT_NEAR(height(20, 20.8) - here, 0.008 * scale, 1e-3 * scale);
    }
}
TEST_F(PathGround, WhatCannotBeFlattenedIsSaid) {
    const auto told = [&](const std::string& entity) {
        const Status s = flattenAlong(doc, entity);
        return s ? std::string() : s.error().text();
    };
    EXPECT_NE(told("way").find("no map of heights"), std::string::npos);
    EXPECT_NE(told("lawn").find("\"lawn\" has no GroundPath"), std::string::npos);
    EXPECT_NE(told("nobody").find("has no GroundPath"), std::string::npos);
    setHeights(PixelType::F32);
    ASSERT_TRUE(doc.setField("ground.Terrain.heightTiling", "2"));
    EXPECT_NE(told("way").find("mirrored"), std::string::npos);
    ASSERT_TRUE(doc.setField("ground.Terrain.heightTiling", "1"));
    EXPECT_EQ(told("way"), "");
}

}  // namespace
}  // namespace sward
