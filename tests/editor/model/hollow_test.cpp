// Hollows: as deep as asked, bare below the waterline, one undo step.
#include "model/hollow.h"

#include <gtest/gtest.h>

#include "model/field_walk.h"
#include "support.h"
#include "techniques.h"
#include "world/ground.h"

namespace sward {
namespace {

class Hollows : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(doc.create(dir / "p")); }
    double height(double x, double z) { return terrainHeight(*findGround(doc.project()).terrain, x, z); }
    float density(double x, double z) {
        const GrassField& f = *doc.project().registry.get<GrassField>(findEntity(doc.project(), "lawn"));
        return f.species[0].density.map.sample(x / 40, z / 40);
    }
    test::TempDir dir;
    Document doc{tables()};
};

TEST_F(Hollows, LevelGroundIsLoweredWithinTheRimAloneAndBareBelowTheWater) {
    const Project before = snapshot(doc.project(), tables().components);
    ASSERT_TRUE(digHollow(doc, {{20, 15}, 6, -1.5, -0.2}));
    EXPECT_NEAR(height(20, 15), -1.5, 0.02);
    EXPECT_NEAR(height(26.2, 15), 0, 1e-6);
    EXPECT_LT(height(23, 15), -0.2);
    EXPECT_EQ(density(20, 15), 0);
    EXPECT_EQ(density(25.7, 15), 1) << "above the waterline";
    EXPECT_EQ(density(30, 30), 1);
    ASSERT_TRUE(doc.undo());
    EXPECT_TRUE(sameProject(doc.project(), before, tables().components));
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(Hollows, WithoutGroundOrWithHeightsThatRepeatItSaysSo) {
    ASSERT_TRUE(doc.setField("ground.Terrain.mapSize", "10"));
    const Status repeats = digHollow(doc, {{20, 15}, 6, -1.5, -0.2});
    ASSERT_FALSE(repeats);
    EXPECT_NE(repeats.error().text().find("repeat"), std::string::npos);
    ASSERT_TRUE(doc.removeEntity("ground"));
    EXPECT_FALSE(digHollow(doc, {{20, 15}, 6, -1.5, -0.2}));
}

}  // namespace
}  // namespace sward
