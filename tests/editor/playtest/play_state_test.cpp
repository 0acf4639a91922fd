// The simulation by itself: equal inputs give equal bits, however long and wherever it runs.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "editor/playtest/play_worlds.h"

namespace sward::test {
namespace {

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
}  // namespace sward::test
