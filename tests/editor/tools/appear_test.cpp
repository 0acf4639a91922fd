// New things appear where the middle of the view meets the ground.
#include "tools/appear.h"

#include <gtest/gtest.h>

#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

class Appears : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "p"));
        ASSERT_TRUE(doc.setField("ground.Terrain.height", ""));
        ASSERT_TRUE(doc.addComponent("ground", "Transform"));
        ASSERT_TRUE(doc.setField("ground.Transform.position", "[0, 3, 0]"));
        ASSERT_TRUE(doc.addEntity("thing"));
    }
    template <class C>
    const C& own() {
        return *doc.project().registry.get<C>(findEntity(doc.project(), "thing"));
    }
    ViewCamera down{{10, 13, 10}, {12, 3, 15}};
    ViewCamera sky{{10, 13, 10}, {10, 20, 12}};
    test::TempDir dir;
    Document doc{tables()};
};

TEST_F(Appears, ATransformOnTheGroundAndWaterAtItsHeight) {
    const std::string before = doc.undoLabel();
    ASSERT_TRUE(addInView(doc, down, "thing", "Transform"));
    EXPECT_LT(glm::length(own<Transform>().position - glm::dvec3(12, 3, 15)), 2e-3);
    EXPECT_EQ(doc.undoLabel(), "add thing.Transform");
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(doc.undoLabel(), before) << "one step";
    ASSERT_TRUE(doc.setField("ground.Transform.position", "[0, 0, 0]"));
    ASSERT_TRUE(addInView(doc, {{10, 10, 10}, {12, 0, 15}}, "thing", "Water"));
    EXPECT_NEAR(own<Water>().level, 0, 1e-3);
}

TEST_F(Appears, AnObjectOnTheGroundCountsItsHeightFromThere) {
    ASSERT_TRUE(addInView(doc, down, "thing", "StaticMesh"));
    ASSERT_TRUE(addInView(doc, down, "thing", "Transform"));
    EXPECT_NEAR(own<Transform>().position.y, 0, 1e-6);
    ASSERT_TRUE(doc.removeComponent("thing", "StaticMesh"));
    ASSERT_TRUE(doc.setField("thing.Transform.position", "[12, 4, 15]"));
    ASSERT_TRUE(addInView(doc, down, "thing", "StaticMesh"));
    EXPECT_NEAR(own<Transform>().position.y, 1, 1e-6) << "it stays where it was";
}

TEST_F(Appears, ACameraSeesWhatIsSeenNow) {
    ASSERT_TRUE(addInView(doc, down, "thing", "Camera"));
    EXPECT_EQ(own<Camera>().eye, down.eye);
    EXPECT_EQ(own<Camera>().target, down.target);
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(doc.project().registry.get<Camera>(findEntity(doc.project(), "thing")), nullptr) << "one step";
}

TEST_F(Appears, BesideASunALightIsALampAboveTheGround) {
    ASSERT_TRUE(addInView(doc, down, "thing", "Transform"));
    ASSERT_TRUE(addInView(doc, down, "thing", "Light"));
    EXPECT_EQ(own<Light>().type, LightType::Point);
    EXPECT_NEAR(own<Transform>().position.y, 5, 1e-3) << "the ground lies at 3";
    ASSERT_TRUE(doc.removeComponent("thing", "Transform"));
    ASSERT_TRUE(addInView(doc, down, "thing", "Transform"));
    EXPECT_NEAR(own<Transform>().position.y, 5, 1e-3) << "in whichever order";
    ASSERT_TRUE(doc.removeEntity("sun"));
    ASSERT_TRUE(doc.removeComponent("thing", "Light"));
    ASSERT_TRUE(addInView(doc, down, "thing", "Light"));
    EXPECT_EQ(own<Light>().type, LightType::Directional);
}

TEST_F(Appears, UnderTheSkyAndElsewhereDefaultsHold) {
    ASSERT_TRUE(addInView(doc, sky, "thing", "Transform"));
    EXPECT_EQ(own<Transform>().position, glm::dvec3(0));
    ASSERT_TRUE(addInView(doc, down, "thing", "Wind"));
    EXPECT_FALSE(addInView(doc, down, "thing", "Wind")) << "it has one";
    EXPECT_FALSE(addInView(doc, down, "nobody", "Transform"));
}

}  // namespace
}  // namespace sward
