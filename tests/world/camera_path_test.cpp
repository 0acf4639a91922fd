#include <gtest/gtest.h>

#include "world/camera_path.h"

namespace sward::test {
namespace {

CameraPath path(std::vector<std::pair<float, glm::dvec3>> stations) {
    CameraPath p;
    for (const auto& [seconds, eye] : stations) p.keys.push_back({"k", seconds, eye, eye + glm::dvec3(0, 0, -5), 50});
    return p;
}

TEST(CameraPath, MeetsItsKeysAndStandsAtItsEnds) {
    const CameraPath p = path({{1, {0, 2, 0}}, {2, {3, 2, 0}}, {5, {4, 1, 7}}});
    for (const CameraKey& k : p.keys)
        EXPECT_LT(glm::length(cameraOn(p, static_cast<double>(k.seconds)).eye - k.eye), 1e-9);
    EXPECT_EQ(cameraOn(p, 0).eye, p.keys.front().eye);
    EXPECT_EQ(cameraOn(p, 99).eye, p.keys.back().eye);
    EXPECT_EQ(secondsOf(p), 5);
}
TEST(CameraPath, GoesEvenlyWhereItsKeysDo) {
    const CameraPath p = path({{0, {0, 1, 0}}, {1, {2, 1, 0}}, {4, {8, 1, 0}}, {4.5f, {9, 1, 0}}});
    for (double t = 0; t <= 4.5; t += 0.05) EXPECT_NEAR(cameraOn(p, t).eye.x, 2 * t, 1e-9) << t;
}
TEST(CameraPath, NeverJumpsInPlaceOrSpeed) {
    const CameraPath p = path({{0, {0, 1, 0}}, {1, {2, 1, 5}}, {1.5f, {8, 3, 0}}, {9, {0, 1, 0}}});
    const double h = 1e-4;
    for (double t = 0.01; t < 8.9; t += 0.003) {
        const glm::dvec3 before = (cameraOn(p, t).eye - cameraOn(p, t - h).eye) / h,
                         after = (cameraOn(p, t + h).eye - cameraOn(p, t).eye) / h;
        EXPECT_LT(glm::length(after - before), 0.05) << t;
    }
}
TEST(CameraPath, CutsBetweenKeysOfOneSecond) {
    const CameraPath p = path({{0, {0, 1, 0}}, {2, {2, 1, 0}}, {2, {50, 1, 0}}, {4, {54, 1, 0}}});
    EXPECT_NEAR(cameraOn(p, 1.999).eye.x, 2, 0.01) << "no swing towards what lies behind the cut";
    EXPECT_NEAR(cameraOn(p, 2).eye.x, 50, 1e-9);
    EXPECT_NEAR(cameraOn(p, 3).eye.x, 52, 1e-9);
}
TEST(CameraPath, TakesKeysInAnyOrderAndLooksSomewhereAlways) {
    CameraPath p = path({{4, {8, 1, 0}}, {0, {0, 1, 0}}});
    EXPECT_NEAR(cameraOn(p, 2).eye.x, 4, 1e-9);
    p.keys[0].target = p.keys[0].eye;
    const Camera c = cameraOn(p, 4);
    EXPECT_GT(glm::length(c.target - c.eye), 0.5);
}

}  // namespace
}  // namespace sward::test
