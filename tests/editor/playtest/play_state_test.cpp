// The simulation by itself: closed forms first, then what must never happen.
#include "playtest/play_state.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace sward {
namespace {

constexpr double kRight = 3.14159265358979 / 2;  // yaw towards +x

// 64 x 64 m; heights in metres by place.
PlayWorld worldOf(const std::function<double(double, double)>& height = nullptr, int texels = 256) {
    PlayWorld world;
    world.terrain.size = {64, 64};
    if (!height) return world;
    world.terrain.height.file = "maps/h.exr";
    world.terrain.height.map = Map({texels, texels, 1, PixelType::F32});
    for (int y = 0; y < texels; ++y)
        for (int x = 0; x < texels; ++x)
            world.terrain.height.map.set(x, y, 0,
                                         static_cast<float>(height((x + 0.5) * 64 / texels, (y + 0.5) * 64 / texels)));
    return world;
}
PlayWorld hills() {
    return worldOf(
        [](double x, double z) { return 3 * std::sin(x / 5) * std::cos(z / 7) + 0.2 * std::sin(x * 1.7 + z); });
}
PlayState stateAt(const PlayWorld& world, double x, double z, double yaw = kRight) {
    PlayState s;
    placeWalker(s, world, x, z, yaw, 0);
    return s;
}
PlayInput walk(double yaw = kRight) {
    PlayInput in;
    in.move = {0, 1};
    in.yaw = yaw;
    return in;
}
void steps(PlayState& s, const PlayWorld& world, const PlayInput& in, int n) {
    for (int i = 0; i < n; ++i) stepPlay(s, world, in);
}
Roller ball(double x, double y, double z, double radius = 0.25) {
    Roller r;
    r.name = "ball";
    r.radius = radius;
    r.position = {x, y, z};
    return r;
}
// A walk that turns, runs, jumps and stands by turns.
PlayInput scripted(int64_t i) {
    PlayInput in;
    in.yaw = 0.002 * static_cast<double>(i % 5000) + std::sin(static_cast<double>(i) * 0.01);
    in.move = {std::sin(static_cast<double>(i) * 0.003), i % 700 < 600 ? 1.0 : 0.0};
    in.run = i % 1000 < 500;
    in.jump = i % 120 < 10;
    return in;
}

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

TEST(PlayState, TheSameInputsGiveTheSameBitsStepForStep) {
    const PlayWorld world = hills();
    PlayState a = stateAt(world, 32, 32), b = a;
    for (int i = 0; i < 5; ++i) a.rollers.push_back(ball(20 + i, 8, 30 + i));
    b.rollers = a.rollers;
    std::set<uint64_t> seen;
    for (int i = 0; i < 2000; ++i) {
        stepPlay(a, world, scripted(i));
        stepPlay(b, world, scripted(i));
        ASSERT_EQ(hashPlay(a), hashPlay(b)) << i;
        seen.insert(hashPlay(a));
    }
    EXPECT_EQ(seen.size(), 2000u);
    b.walker.position.x = std::nextafter(b.walker.position.x, 1e9);
    EXPECT_NE(hashPlay(a), hashPlay(b)) << "the hash sees the last bit";
}

// 36,000 steps; what they take is seen in the time of this test: a fraction of a second.
TEST(PlayState, TenMinutesOfWalkingAreReproducibleAndGrowNothing) {
    const PlayWorld world = hills();
    const auto play = [&] {
        PlayState s = stateAt(world, 32, 32);
        for (int i = 0; i < 8; ++i) s.rollers.push_back(ball(16 + 4 * i, 8, 30));
        size_t most = 0;
        for (int64_t i = 0; i < 36000; ++i) {
            stepPlay(s, world, scripted(i));
            most = std::max(most, s.contacts.capacity());
            for (const Roller& r : s.rollers)
                EXPECT_TRUE(std::isfinite(r.position.x + r.position.y + r.position.z)) << i;
        }
        EXPECT_LE(most, 32u) << "contacts are of one step";
        EXPECT_EQ(s.rollers.size(), 8u);
        return hashPlay(s);
    };
    EXPECT_EQ(play(), play());
}

TEST(PlayState, AfterAMonthStepsAreAsLongAsAtTheStart) {
    const PlayWorld world = hills();
    PlayState now = stateAt(world, 32, 32), late = now;
    late.tick = int64_t(30) * 86400 * kTicksPerSecond;
    for (int i = 0; i < 3600; ++i) {
        const glm::dvec3 a = now.walker.position, b = late.walker.position;
        stepPlay(now, world, scripted(i));
        stepPlay(late, world, scripted(i));
        const double early = glm::distance(a, now.walker.position), later = glm::distance(b, late.walker.position);
        ASSERT_NEAR(early, later, 0.01 * early) << i;
    }
    EXPECT_EQ(late.tick, int64_t(30) * 86400 * kTicksPerSecond + 3600);
    const double before = static_cast<double>(late.tick - 1) / kTicksPerSecond,
                 after = static_cast<double>(late.tick) / kTicksPerSecond;
    EXPECT_NEAR(after - before, kTickSeconds, 0.01 * kTickSeconds) << "scene time moves on as evenly";
}

TEST(PlayState, FarFromTheOriginItWalksTheSame) {
    PlayWorld here = hills(), far = here;
    far.origin = {1e6, 500, -1e6};
    PlayState a = stateAt(here, 32, 32), b = stateAt(far, 1e6 + 32, -1e6 + 32);
    for (int i = 0; i < 600; ++i) stepPlay(a, here, scripted(i)), stepPlay(b, far, scripted(i));
    EXPECT_LT(glm::distance(a.walker.position + far.origin, b.walker.position), 1e-4);
}

TEST(PlayState, WhatIsNotFiniteInTheInputIsNothing) {
    const PlayWorld world = hills();
    PlayState s = stateAt(world, 32, 32);
    PlayInput bad;
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    bad.move = {nan, inf};
    bad.yaw = inf;
    bad.pitch = nan;
    steps(s, world, bad, 10);
    EXPECT_EQ(s.walker.yaw, 0);
    EXPECT_EQ(s.walker.position.x, 32);
    PlayWorld tiny = worldOf();
    tiny.terrain.size = {0.1, 0.1};
    PlayState small = stateAt(tiny, 3, 3);
    small.rollers = {ball(0, 0, 0, 2)};
    steps(small, tiny, walk(), 100);
    EXPECT_NEAR(small.walker.position.x, 0.05, 1e-9);
    EXPECT_NEAR(small.rollers[0].position.z, 0.05, 1e-9);
}

}  // namespace
}  // namespace sward
