// Cameras: which one is meant, and where on the ground a place of the picture lies.
#include "world/view_camera.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

// Level ground of 40 x 40 m, and an eye 10 m above its middle that looks a little past straight down, north up.
Project levelGround() {
    Project p;
    Terrain t;
    t.size = {40, 40};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    return p;
}
const ViewCamera kAbove{{20, 10, 20}, {20, 0, 19.999}, 90, 0};

TEST(ViewCameras, AreFoundByNameOrTheFirst) {
    Project p;
    EXPECT_EQ(findCamera(p, ""), nullptr);
    for (const char* name : {"b", "a"}) p.registry.add<Camera>(*addEntity(p, name))->fovDeg = name[0] == 'a' ? 30 : 60;
    ASSERT_NE(findCamera(p, "b"), nullptr);
    EXPECT_EQ(findCamera(p, "b")->fovDeg, 60);
    ASSERT_NE(findCamera(p, ""), nullptr);
    EXPECT_EQ(findCamera(p, "")->fovDeg, 30) << "the first by name";
    EXPECT_EQ(findCamera(p, "c"), nullptr);
}

TEST(ViewCameras, SeeAsTheirComponentSays) {
    const Camera c{{1, 2, 3}, {4, 5, 6}, 70, 1.5f};
    const ViewCamera v = viewOf(c);
    EXPECT_EQ(v.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(v.target, glm::dvec3(4, 5, 6));
    EXPECT_EQ(v.fovDeg, 70);
    EXPECT_EQ(v.exposure, 1.5f);
}

TEST(PickGround, StraightDownIsBelowTheEyeAndTheEdgeAsFarAsTheFieldOfViewSays) {
    const Project p = levelGround();
    const auto middle = pickGround(p, kAbove, 200, 200, 100, 100);
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->x, 20, 0.02);
    EXPECT_NEAR(middle->y, 0, 1e-3);
    EXPECT_NEAR(middle->z, 20, 0.02);
    const auto edge = pickGround(p, kAbove, 200, 200, 200, 100);  // 45 degrees off: as far aside as the eye is high
    ASSERT_TRUE(edge);
    EXPECT_NEAR(std::hypot(edge->x - 20, edge->z - 20), 10, 0.05);
}

TEST(PickGround, NothingLiesInTheSkyBeyondTheLandOrWithoutIt) {
    const ViewCamera level{{20, 10, 20}, {20, 10, 0}, 60, 0}, outward{{20, 10, 20}, {20, 9, -80}, 60, 0};
    EXPECT_FALSE(pickGround(levelGround(), level, 200, 200, 100, 20)) << "above the horizon";
    EXPECT_FALSE(pickGround(levelGround(), outward, 200, 200, 100, 100)) << "past the terrain's edge";
    EXPECT_FALSE(pickGround(Project(), kAbove, 200, 200, 100, 100));
}

}  // namespace
}  // namespace sward
