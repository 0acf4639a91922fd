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

TEST(CameraPath, AlongAGroundPathItKeepsEyeHeightAndWalkingSpeed) {
    GroundPath ground;
    ground.points = {{"", {2, 3}}, {"", {12, 3}}, {"", {12, 13}}};
    Terrain t;
    t.size = {20, 20};
    const Ground on{&t, {100, 5, -50}};
    const CameraPath way = cameraAlong(ground, on, 1.7, 1.8);
    ASSERT_GT(way.keys.size(), 10u);
    EXPECT_LT(glm::length(way.keys.front().eye - glm::dvec3(102, 6.7, -47)), 1e-6);
    EXPECT_LT(glm::length(way.keys.back().eye - glm::dvec3(112, 6.7, -37)), 1e-6);
    const double length = stationsOn(groundCurve(ground)).back().metres;
    EXPECT_NEAR(secondsOf(way), length / 1.8, 1e-4);
    for (double s = 0; s < secondsOf(way); s += 0.1) {
        const Camera c = cameraOn(way, s), next = cameraOn(way, s + 0.05);
        EXPECT_NEAR(c.eye.y, 6.7, 1e-6);
        EXPECT_LT(nearestOn(groundCurve(ground), {c.eye.x - 100, c.eye.z + 50}).distance, 0.1);
        EXPECT_NEAR(glm::length(next.eye - c.eye) / 0.05, 1.8, 0.3);
        EXPECT_GT(glm::dot(glm::normalize(c.target - c.eye), glm::normalize(next.eye - c.eye)), 0.7)
            << "it looks ahead";
    }
}
TEST(CameraPath, RoundAClosedPathItComesBackAndWithoutLengthThereIsNone) {
    GroundPath ground;
    ground.points = {{"", {2, 3}}, {"", {12, 3}}, {"", {12, 13}}};
    ground.closed = true;
    Terrain t;
    t.size = {20, 20};
    const CameraPath way = cameraAlong(ground, {&t}, 1.7, 1.8);
    EXPECT_EQ(way.keys.front().eye, way.keys.back().eye);
    EXPECT_EQ(way.keys.front().target, way.keys.back().target);
    ground.points.resize(1);
    EXPECT_TRUE(cameraAlong(ground, {&t}, 1.7, 1.8).keys.empty());
    EXPECT_TRUE(cameraAlong({}, {&t}, 1.7, 1.8).keys.empty());
    ground.points = {{"", {0, 0}}, {"", {1e6, 0}}};
    EXPECT_EQ(cameraAlong(ground, {&t}, 1.7, 1.8).keys.size(), 400u) << "a long one has its keys farther apart";
    EXPECT_LE(secondsOf(cameraAlong(ground, {&t}, 1.7, 1.8)), 86400);
}

}  // namespace
}  // namespace sward::test
