// What presses on the grass, and what it does to a blade.
#include "world/forces.h"

#include <gtest/gtest.h>

#include "core/numerics.h"
#include "scenes.h"

namespace sward {
using namespace test;
namespace {

ForceSource source(ForceShape shape, float radius) {
    ForceSource s;
    s.shape = shape, s.radius = radius;
    return s;
}

TEST(Forces, PressUnderneathAndPushAwayAround) {
    const Force round{{5, 5}, {5, 5}, 1, 3, 1};
    const auto at = [&](double x, double z) { return forceAt(std::span(&round, 1), {x, z}); };
    EXPECT_EQ(at(5, 5), glm::vec3(0, 0, 1)) << "in the middle there is no way out";
    EXPECT_FLOAT_EQ(at(5.7, 5).z, 1);
    EXPECT_GT(at(5.7, 5).x, 0.9f);
    EXPECT_EQ(at(6.5, 5).z, 0);
    EXPECT_GT(at(6.5, 5).x, at(7.5, 5).x) << "less with the distance";
    EXPECT_LT(at(5, 3.5).y, -0.5f) << "away from the middle";
    EXPECT_EQ(at(8.01, 5), glm::vec3(0));
}

TEST(Forces, ALongOnePushesAwayFromItsLine) {
    const Force wheel{{0, 0}, {4, 0}, 0.5f, 2, 1};
    for (const double x : {0.5, 2.0, 3.5}) {
        const glm::vec3 f = forceAt(std::span(&wheel, 1), {x, 0.7});
        EXPECT_NEAR(f.x, 0, 1e-6);
        EXPECT_GT(f.y, 0.4f);
    }
}

TEST(Forces, SeveralAddUpToNoMoreThanOneAndNaNIsNone) {
    const Force all[] = {{{0, 0}, {0, 0}, 1, 4, 1}, {{0.1, 0}, {0.1, 0}, 1, 4, 1}, {{-0.1, 0}, {-0.1, 0}, 1, 4, 1}};
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 f = forceAt(all, {0.04 * i, 0.02 * i});
        EXPECT_LE(glm::length(glm::vec2(f)), 1.000001f);
        EXPECT_LE(f.z, 1);
    }
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const glm::vec3 bad : {glm::vec3(nan, 0, 0), glm::vec3(0, nan, 0), glm::vec3(0, 0, nan), glm::vec3(inf, 0, 0),
                                glm::vec3(0, 0, inf), glm::vec3(1e30f, 1e30f, 0)})
        EXPECT_EQ(f32::forceOf(bad), glm::vec3(0));
    EXPECT_EQ(forceAt(std::span(all, 1), {std::numeric_limits<double>::quiet_NaN(), 0}), glm::vec3(0));
}

// J-8: whatever presses, the tip stays above the root and the blade as long as it is.
TEST(Forces, ABladeStaysAboveItsRootAndAsLongAsItIs) {
    for (uint32_t i = 0; i < 5000; ++i) {
        const auto number = [&](uint32_t k) { return 2 * f32::hashUnit(f32::hash3(i, k, 6)) - 1; };
        const glm::vec3 tip(0.1f * number(0), 0.3f + 0.2f * number(1), 0.1f * number(2)),
            control(0.3f * tip.x, 0.6f * tip.y, 0.3f * tip.z);
        const glm::vec2 facing(std::cos(3 * number(3)), std::sin(3 * number(3)));
        const glm::vec3 force = f32::forceOf({100 * number(4), 100 * number(5), 50 * number(6)});
        const glm::vec2 lean = f32::forcedLean({number(7), number(8)}, {force.x, force.y}, force.z, facing);
        const f32::BladePose pose = f32::poseBlade(control, tip, facing, {1, 1}, lean, 1);
        EXPECT_GE(pose.tip.y, 0);
        EXPECT_NEAR(glm::length(pose.tip), glm::length(tip), 1e-5f);
        EXPECT_TRUE(std::isfinite(pose.control.x + pose.control.y + pose.control.z));
    }
}

TEST(Forces, WhatIsPressedLies) {
    const glm::vec3 tip(0.02f, 0.3f, 0), control(0.005f, 0.2f, 0);
    const glm::vec2 lean = f32::forcedLean({0, 0}, {0, 0}, 1, {1, 0});
    const f32::BladePose pose = f32::poseBlade(control, tip, {1, 0}, {1, 1}, lean, 1);
    EXPECT_LT(pose.tip.y, 0.06f * glm::length(tip));
    EXPECT_GT(pose.tip.x, 0.29f);
}

TEST(Forces, TracksRecoverAndAreForgotten) {
    ForceSource foot = source(ForceShape::Foot, 0.1f);
    foot.recovery = 10;
    EXPECT_EQ(trackLeft(0, 10), 1);
    EXPECT_EQ(trackLeft(10, 10), 0);
    EXPECT_EQ(trackLeft(3600, std::numeric_limits<float>::infinity()), 1);
    EXPECT_EQ(trackLeft(1, 0), 0);
    double before = 2;
    for (int i = 0; i <= 100; ++i) {
        EXPECT_LE(trackLeft(0.1 * i, 10), before);
        before = trackLeft(0.1 * i, 10);
    }
    for (int i = 0; i < 100000; ++i) leaveTrack(foot, {0.01 * i, 0}, {0.01 * i, 0}, 0.5 * i);
    EXPECT_LE(foot.tracks.size(), 21u) << "twenty a recovery";
    leaveTrack(foot, {std::numeric_limits<double>::quiet_NaN(), 0}, {0, 0}, 50000);
    EXPECT_LE(foot.tracks.size(), 21u);
}

TEST(Forces, ListHasWhatStandsAndWhatWasLeftRelativeToTheTerrain) {
    Project p;
    put(p, "ground", Terrain{});
    p.registry.add<Transform>(p.entities.at("ground"), Transform{{100, 0, 50}});
    ForceSource wheel = source(ForceShape::Wheel, 0.2f);
    wheel.length = 1, wheel.headingDeg = 90;
    leaveTrack(wheel, {101, 51}, {103, 51}, 2);
    put(p, "wheel", wheel);
    EXPECT_EQ(forcesOf(p, 2).size(), 1u) << "nowhere without a Transform, but its track is there";
    p.registry.add<Transform>(p.entities.at("wheel"), Transform{{110, 3, 60}});
    const auto forces = forcesOf(p, 2);
    ASSERT_EQ(forces.size(), 2u);
    EXPECT_EQ(forces[0].from, glm::dvec2(1, 1));
    EXPECT_NEAR(forces[1].to.x - forces[1].from.x, 0.6, 1e-6) << "a metre less its round ends";
    EXPECT_NEAR(forces[1].from.x, 9.7, 1e-6);
    EXPECT_EQ(forcesOf(p, 100).size(), 1u) << "the track has recovered";
    p.registry.get<ForceSource>(p.entities.at("wheel"))->strength = 0;
    EXPECT_TRUE(forcesOf(p, 2).empty());
}

}  // namespace
}  // namespace sward
