// The walker: closed forms of speed, jump and slope.
#include <gtest/gtest.h>

#include <cmath>

#include "editor/playtest/play_worlds.h"

namespace sward::test {
namespace {

TEST(PlayWalker, WalksAndRunsAtItsSpeedsOverFlatGround) {
    const PlayWorld world = worldOf();
    for (const bool run : {false, true}) {
        PlayState s = stateAt(world, 5, 20);
        PlayInput in = walk();
        in.run = run;
        steps(s, world, in, 60);
        const double x = s.walker.position.x;
        steps(s, world, in, 300);
        EXPECT_NEAR(s.walker.position.x - x, 5 * (run ? kRunSpeed : kWalkSpeed), 1e-9);
        EXPECT_NEAR(s.walker.position.z, 20, 1e-9);
        EXPECT_EQ(s.walker.position.y, 0);
        EXPECT_EQ(s.tick, 360);
    }
}

TEST(PlayWalker, YawTurnsClockwiseFromNorthAndSidewaysIsRight) {
    const PlayWorld world = worldOf();
    PlayState north = stateAt(world, 32, 32), right = north;
    steps(north, world, walk(0), 60);
    EXPECT_LT(north.walker.position.z, 31);
    EXPECT_NEAR(north.walker.position.x, 32, 1e-9);
    PlayInput in;
    in.move = {1, 0};
    steps(right, world, in, 60);
    EXPECT_GT(right.walker.position.x, 33);
    in.move = {30, 40};  // longer than 1 is 1
    steps(right, world, in, 60);
    EXPECT_NEAR(glm::length(right.walker.velocity), kWalkSpeed, 1e-9);
}

TEST(PlayWalker, AJumpIsAThrowAndNeedsANewPress) {
    const PlayWorld world = worldOf();
    PlayState s = stateAt(world, 32, 32);
    PlayInput in;
    in.jump = true;
    double top = 0;
    int air = 0, jumps = 0;
    for (int i = 0; i < 120; ++i) {
        const bool before = s.walker.onGround;
        stepPlay(s, world, in);
        jumps += before && !s.walker.onGround;
        air += !s.walker.onGround;
        top = std::max(top, s.walker.position.y);
    }
    EXPECT_NEAR(top, kJumpSpeed * kJumpSpeed / (2 * kGravity), 1e-3);
    EXPECT_NEAR(air * kTickSeconds, 2 * kJumpSpeed / kGravity, 2 * kTickSeconds);
    EXPECT_EQ(jumps, 1) << "held, it jumps once";
    in.jump = false;
    stepPlay(s, world, in);
    in.jump = true;
    stepPlay(s, world, in);
    EXPECT_FALSE(s.walker.onGround);
}

TEST(PlayWalker, StopsAtTheEdgeWhateverItDoes) {
    const PlayWorld world = hills();
    for (const double yaw : {0.0, 0.7, kRight, 2.5, 3.14, 4.0, 5.5}) {
        PlayState s = stateAt(world, 60, 60);
        PlayInput in = walk(yaw);
        in.run = true;
        for (int i = 0; i < 3000; ++i) {
            in.jump = i % 50 < 5;
            stepPlay(s, world, in);
            const glm::dvec3 p = s.walker.position;
            ASSERT_TRUE(p.x >= kBodyRadius && p.z >= kBodyRadius && p.x <= 64 - kBodyRadius && p.z <= 64 - kBodyRadius);
            ASSERT_GE(p.y, groundHeight(world, {p.x, p.z}) - 1e-9);
            for (const Contact& c : s.contacts)
                ASSERT_TRUE(c.position.x >= 0 && c.position.z >= 0 && c.position.x <= 64 && c.position.z <= 64);
        }
    }
    PlayState s = stateAt(worldOf(), 60, 32);
    steps(s, worldOf(), walk(), 600);
    EXPECT_EQ(s.walker.position.x, 64 - kBodyRadius);
    EXPECT_EQ(s.walker.velocity.x, 0) << "it stands there";
    EXPECT_EQ(stateAt(worldOf(), 1e6, -1e6).walker.position, glm::dvec3(64 - kBodyRadius, 0, kBodyRadius));
}

TEST(PlayWalker, ClimbsTo45DegreesAndNoSteeper) {
    for (const auto& [rise, climbs] : {std::pair(0.9, true), std::pair(1.2, false)}) {
        const PlayWorld world = worldOf([&](double x, double) { return std::clamp(x - 20, 0.0, 20.0) * rise; });
        PlayState s = stateAt(world, 15, 32);
        steps(s, world, walk(), 900);
        EXPECT_EQ(s.walker.position.x > 39, climbs) << rise;
        if (!climbs) {
            EXPECT_LT(s.walker.position.y, 1);
        }
    }
}

TEST(PlayWalker, SlidesDownWhatIsTooSteepAndStaysOnWhatIsNot) {
    for (const auto& [rise, slides] : {std::pair(0.7, false), std::pair(1.5, true)}) {
        const PlayWorld world = worldOf([&](double x, double) { return x * rise; });
        PlayState s = stateAt(world, 32, 32);
        steps(s, world, {}, 120);
        EXPECT_EQ(s.walker.position.x < 30, slides) << rise;
        if (!slides) {
            EXPECT_EQ(s.walker.position.x, 32);
        }
    }
}

TEST(PlayWalker, AlongAWallItSlidesInsteadOfSticking) {
    const PlayWorld world = worldOf([](double x, double) { return std::clamp(x - 20, 0.0, 1.0) * 8; });
    PlayState s = stateAt(world, 18, 20);
    steps(s, world, walk(kRight + 0.6), 300);  // into the wall, a little south
    EXPECT_LT(s.walker.position.x, 21);
    EXPECT_GT(s.walker.position.z, 23);
}

TEST(PlayWalker, FeetAlternateByTheStride) {
    const PlayWorld world = worldOf();
    for (const bool run : {false, true}) {
        PlayState s = stateAt(world, 2, 32);
        PlayInput in = walk();
        in.run = run;
        steps(s, world, in, 120);
        std::vector<double> falls;
        int stance = s.walker.stance, first = -1;
        for (int i = 0; i < 480; ++i) {
            stepPlay(s, world, in);
            ASSERT_EQ(s.contacts.size(), 1u);
            const Contact& c = s.contacts[0];
            EXPECT_EQ(c.radius, kFootRadius);
            EXPECT_EQ(c.pressed, 1);
            EXPECT_NEAR(c.direction.x, 1, 1e-9);
            if (s.walker.stance == stance) continue;
            stance = s.walker.stance;
            if (first < 0) first = i;
            falls.push_back(c.position.x);
            EXPECT_NEAR(c.position.z, 32 + (stance == 0 ? -kFootApart : kFootApart), 1e-9);
        }
        ASSERT_GT(falls.size(), 10u);
        const double stride = (falls.back() - falls.front()) / static_cast<double>(falls.size() - 1);
        EXPECT_NEAR(stride, run ? kRunStride : kWalkStride, 0.02);
        steps(s, world, {}, 60);
        EXPECT_EQ(s.contacts.size(), 2u) << "who stands has both feet down";
        in.jump = true;
        stepPlay(s, world, in);
        EXPECT_TRUE(s.contacts.empty()) << "no foot is down in the air";
    }
}

}  // namespace
}  // namespace sward::test
