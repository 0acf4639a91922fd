// Balls that roll: closed forms of slopes and throws, and what they push.
#include <gtest/gtest.h>

#include <cmath>

#include "editor/playtest/play_worlds.h"

namespace sward::test {
namespace {

TEST(PlayRollers, RollDownASlopeAsSolidBallsDo) {
    const double rise = 0.2;
    const PlayWorld world = worldOf([&](double x, double) { return x * rise; });
    PlayState s = stateAt(world, 2, 60);
    s.rollers = {ball(40, 40 * rise, 32)};
    s.rollers[0].friction = 0;
    settleRoller(s.rollers[0], world);
    steps(s, world, {}, 30);
    const double from = s.rollers[0].position.x, speed = -s.rollers[0].velocity.x;
    steps(s, world, {}, 120);
    const double pull = 5.0 / 7 * kGravity * rise / (1 + rise * rise);  // along x
    EXPECT_NEAR(from - s.rollers[0].position.x, speed * 2 + pull * 2, 0.05);
    EXPECT_TRUE(s.rollers[0].onGround);
    EXPECT_NEAR(glm::length(s.rollers[0].spin) * s.rollers[0].radius, glm::length(s.rollers[0].velocity), 1e-9);
    EXPECT_GT(s.rollers[0].spin.z, 0) << "rolling towards -x turns about +z";
}

TEST(PlayRollers, RestWhereFrictionHoldsAndStopAtTheEdge) {
    const PlayWorld world = worldOf([](double x, double) { return x * 0.1; });
    PlayState s = stateAt(world, 2, 60);
    s.rollers = {ball(30, 0, 32), ball(20, 0, 30)};
    s.rollers[0].friction = 0.15;
    s.rollers[1].friction = 0.02;
    for (Roller& r : s.rollers) settleRoller(r, world);
    steps(s, world, {}, 1800);
    EXPECT_NEAR(s.rollers[0].position.x, 30, 0.1);
    EXPECT_EQ(glm::length(s.rollers[0].velocity), 0);
    EXPECT_NEAR(s.rollers[1].position.x, 0.25, 1e-9) << "at the terrain's edge";
    EXPECT_LT(glm::length(s.rollers[1].velocity), 0.05);
    EXPECT_EQ(s.contacts.size(), 4u);  // two feet, two balls
}

TEST(PlayRollers, FallFreelyThenBounceAndComeToRestOnTheGround) {
    const PlayWorld world = worldOf();
    PlayState s = stateAt(world, 2, 60);
    s.rollers = {ball(32, 5.25, 32)};
    steps(s, world, {}, 30);
    EXPECT_NEAR(s.rollers[0].position.y, 5.25 - kGravity * 0.25 / 2, 0.06);
    EXPECT_FALSE(s.rollers[0].onGround);
    steps(s, world, {}, 300);
    EXPECT_NEAR(s.rollers[0].position.y, 0.25, 1e-9);
    EXPECT_TRUE(s.rollers[0].onGround);
}

TEST(PlayRollers, TheWalkerPushesThemByTheirShare) {
    for (const double push : {1.0, 0.3, 0.0}) {
        const PlayWorld world = worldOf();
        PlayState s = stateAt(world, 10, 32);
        s.rollers = {ball(14, 0.5, 32, 0.5)};
        s.rollers[0].push = push;
        steps(s, world, walk(), 360);
        const double moved = s.rollers[0].position.x - 14, gap = s.rollers[0].position.x - s.walker.position.x;
        EXPECT_GE(gap, 0.5 + kBodyRadius - 0.02) << push;
        if (push == 0) {
            EXPECT_NEAR(moved, 0, 1e-9);
            EXPECT_NEAR(s.walker.position.x, 14 - 0.8, 0.02) << "it stands like a wall";
        } else {
            EXPECT_GT(moved, push);
        }
    }
}

TEST(PlayRollers, WhatLiesAtTheEdgeHoldsTheWalkerBack) {
    const PlayWorld world = worldOf();
    PlayState s = stateAt(world, 58, 32);
    s.rollers = {ball(61, 0.5, 32, 0.5)};
    s.rollers[0].push = 1;
    PlayInput in = walk();
    in.run = true;
    steps(s, world, in, 600);
    EXPECT_NEAR(s.rollers[0].position.x, 63.5, 1e-9);
    EXPECT_NEAR(s.walker.position.x, 63.5 - 0.5 - kBodyRadius, 0.02);
}

TEST(PlayRollers, TheLargerMovesTheSmallerAndNoneLieInEachOther) {
    const PlayWorld world = worldOf();
    PlayState s = stateAt(world, 2, 60);
    s.rollers = {ball(30, 1, 32, 1), ball(34, 0.25, 32, 0.25)};
    s.rollers[0].velocity = {4, 0, 0};
    steps(s, world, {}, 90);
    EXPECT_GT(s.rollers[1].position.x, 34.5);
    EXPECT_GT(s.rollers[0].velocity.x, 1) << "the large one goes on";
    PlayState heap = stateAt(world, 2, 60);
    for (int i = 0; i < 12; ++i) heap.rollers.push_back(ball(32 + 0.1 * (i % 3), 0.3 + 0.2 * i, 32 + 0.05 * i));
    steps(heap, world, {}, 900);
    for (size_t i = 0; i < heap.rollers.size(); ++i) {
        EXPECT_LT(glm::length(heap.rollers[i].velocity), 0.2);
        for (size_t k = i + 1; k < heap.rollers.size(); ++k)
            EXPECT_GT(glm::distance(heap.rollers[i].position, heap.rollers[k].position), 0.5 - 0.02);
    }
}

}  // namespace
}  // namespace sward::test
