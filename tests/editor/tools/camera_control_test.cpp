#include "editor/tools/camera_control.h"
#include "world/view_camera.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

void expectNear(glm::dvec3 a, glm::dvec3 b, double tolerance = 1e-9) {
    EXPECT_NEAR(glm::length(a - b), 0, tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(CameraControl, AViewSurvivesTheRoundTrip) {
    const ViewCamera view{{3, 1.7, 9}, {20, 0.5, -4}, 60, 0.5f};
    const ViewCamera back = viewOf(flyFrom(view));
    expectNear(back.eye, view.eye);
    expectNear(back.target, view.target);
    EXPECT_EQ(back.fovDeg, 60);
    EXPECT_EQ(back.exposure, 0.5f);
}

TEST(CameraControl, AViewWithoutDirectionLooksSomewhere) {
    const ViewCamera back = viewOf(flyFrom({{1, 1, 1}, {1, 1, 1}, 55, 0}));
    EXPECT_GT(glm::length(back.target - back.eye), 0.1);
}

TEST(CameraControl, OrbitKeepsThePivotAndTheDistance) {
    FlyCamera c = flyFrom({{0, 5, 10}, {0, 0, 0}, 55, 0});
    orbit(c, 120, -35);
    expectNear(pivotOf(c), {0, 0, 0});
    EXPECT_GT(glm::length(c.eye - glm::dvec3(0, 5, 10)), 1);
}

TEST(CameraControl, LookingUpStopsBeforeTheZenith) {
    FlyCamera c;
    look(c, 0, -1e6);
    EXPECT_LT(c.pitch, 1.5708);
    EXPECT_GT(forwardOf(c).y, 0.99);
}

TEST(CameraControl, FlyingForwardCoversSpeedTimesTime) {
    FlyCamera c = flyFrom({{0, 2, 0}, {0, 2, -10}, 55, 0});
    c.speed = 4;
    fly(c, {0, 0, 1}, 0.5);
    expectNear(c.eye, {0, 2, -2});
    fly(c, {1, 0, 1}, 1);  // diagonals are no faster
    EXPECT_NEAR(glm::length(c.eye - glm::dvec3(0, 2, -2)), 4, 1e-9);
}

TEST(CameraControl, DollyNeverPassesItsTarget) {
    FlyCamera c = flyFrom({{0, 0, 10}, {0, 0, 0}, 55, 0});
    for (int i = 0; i < 500; ++i) dolly(c, {0, 0, 0}, 1);
    EXPECT_GT(c.eye.z, 0);
    EXPECT_LT(c.eye.z, 0.2);
}

TEST(CameraControl, PanMovesThePivotWithThePointer) {
    FlyCamera c = flyFrom({{0, 0, 10}, {0, 0, 0}, 90, 0});
    pan(c, 100, 0, 200);  // half the height, which spans 20 m at the pivot
    expectNear(pivotOf(c), {-10, 0, 0}, 1e-6);
}

}  // namespace
}  // namespace sward
