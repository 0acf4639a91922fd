// Trunks stop what walks and rolls at their distance, let it slide past, and are asked for by place.
#include "playtest/trunks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "editor/playtest/play_worlds.h"
#include "editor/playtest/played_project.h"
#include "playtest/path_walk.h"

namespace sward::test {
namespace {

constexpr double kDeepest = 1e-8;  // metres: of what touches

glm::dvec2 place(const PlayState& s) { return across(s.walker.position); }
double apart(const PlayState& s, double x, double z) { return glm::length(place(s) - glm::dvec2(x, z)); }
PlayInput runAt(double yaw = kRight) {
    PlayInput in = walk(yaw);
    in.run = true;
    return in;
}
PlayWorld oneTrunk(float size = 1) {
    PlayWorld world = worldOf();
    plant(world, {treeAt(30, 20, size)});
    return world;
}
// A wood of a square terrain, 400 trees a hectare.
PlayWorld wood(double metres, float density = 1) {
    PlayWorld world;
    world.terrain.size = {metres, metres};
    Forest forest;
    Map m({4, 4, 1, PixelType::U16});
    for (int i = 0; i < 16; ++i) m.set(i % 4, i / 4, 0, density);
    forest.density = {"maps/d.png", m};
    world.forests.push_back(playForest(forest, {&world.terrain, world.origin}));
    return world;
}

TEST(PlayTrunks, AWalkAtTheMiddleOfATrunkStopsAtItsDistance) {
    for (const float size : {0.5f, 1.0f, 3.0f})
        for (const PlayInput& in : {walk(), runAt()}) {
            const PlayWorld world = oneTrunk(size);
            PlayState s = stateAt(world, 20, 20);
            steps(s, world, in, 480);
            EXPECT_NEAR(apart(s, 30, 20), kTrunk * static_cast<double>(size) + kBodyRadius, 1e-6);
            EXPECT_NEAR(glm::length(s.walker.velocity), 0, 1e-6);
            EXPECT_LT(s.walker.position.x, 30);
        }
}

TEST(PlayTrunks, ATrunkIsAsThickAsItsSpeciesAndSizeWhateverItsHeight) {
    PlayWorld world = worldOf();
    Forest forest;
    forest.species.push_back({});
    forest.species[1].kind = TreeKind::Broadleaf;
    forest.species[1].height = 20;
    forest.verticalScale = 4;
    forest.placed = {treeAt(10, 10), treeAt(30, 10, 2)};
    forest.placed[1].species = 1;
    forest.perHectare = 0;
    world.forests.push_back(playForest(forest, {&world.terrain, world.origin}));
    EXPECT_NEAR(depthInTrunks(world, {10, 10}, 0), 0.014 * 12, 1e-6);
    EXPECT_NEAR(depthInTrunks(world, {30, 10}, 0), 0.026 * 20 * 2, 1e-6);
    EXPECT_EQ(depthInTrunks(world, {20, 10}, 0.3), 0);
}

TEST(PlayTrunks, OffTheMiddleItSlidesPastAndLosesOnlyWhatLeadsIn) {
    const PlayWorld world = oneTrunk(3);
    const double sum = 3 * kTrunk + kBodyRadius;
    for (const double z : {19.3, 19.9, 20.02, 20.4, 20.75})
        for (const PlayInput& in : {walk(), runAt()}) {
            PlayState s = stateAt(world, 20, z);
            double nearest = 99;
            for (int i = 0; i < 900; ++i) {
                stepPlay(s, world, in);
                nearest = std::min(nearest, apart(s, 30, 20));
            }
            EXPECT_GE(nearest, sum - 1e-8) << z;
            EXPECT_LT(nearest, sum + 5e-3) << z << ": it goes straight on for a step";
            EXPECT_GT(s.walker.position.x, 31) << z;
            EXPECT_GE(std::abs(s.walker.position.z - 20), sum - 1e-8) << "it leaves along the trunk's side";
        }
    const glm::dvec2 touching{30 - sum, 20};
    const glm::dvec2 past = pastTrunks(world, touching, touching + glm::dvec2(0.02, 0.03), kBodyRadius);
    EXPECT_NEAR(past.x, touching.x, 1e-12) << "what leads in is lost";
    EXPECT_NEAR(past.y, 20.03, 1e-12) << "what leads along is kept";
}

TEST(PlayTrunks, TwoThatLeaveNoRoomLetNothingThroughAndNothingShakes) {
    for (const double gap : {0.3, 0.8, 2 * (kTrunk + kBodyRadius) - 1e-6})
        for (const double z : {19.8, 20.0, 20.1})
            for (const PlayInput& in : {walk(), runAt()}) {
                PlayWorld world = worldOf();
                plant(world, {treeAt(30, 20 - gap / 2), treeAt(30, 20 + gap / 2)});
                PlayState s = stateAt(world, 20, std::clamp(z, 20 - gap * 0.3, 20 + gap * 0.3));
                steps(s, world, in, 1200);
                const glm::dvec2 at = place(s);
                EXPECT_LT(at.x, 30);
                EXPECT_NEAR(apart(s, 30, 20 - gap / 2), kTrunk + kBodyRadius, 1e-6) << gap << " " << z;
                EXPECT_NEAR(apart(s, 30, 20 + gap / 2), kTrunk + kBodyRadius, 1e-6) << gap << " " << z;
                for (int i = 0; i < 300; ++i) {
                    stepPlay(s, world, in);
                    ASSERT_LT(glm::length(place(s) - at), 1e-9);
                }
                steps(s, world, walk(-kRight), 120);
                EXPECT_LT(s.walker.position.x, at.x - 3) << "it gets away again";
            }
    PlayWorld world = worldOf();
    const double room = kTrunk + kBodyRadius + 1e-6;
    plant(world, {treeAt(30, 20 - room), treeAt(30, 20 + room)});
    PlayState s = stateAt(world, 20, 20);
    steps(s, world, walk(), 480);
    EXPECT_GT(s.walker.position.x, 31) << "where there is room, it goes through";
}

TEST(PlayTrunks, NoJumpPasses) {
    const PlayWorld world = oneTrunk();
    PlayState s = stateAt(world, 28, 20);
    PlayInput in = runAt();
    double top = 0;
    for (int i = 0; i < 200; ++i) {
        in.jump = i % 50 < 5;
        stepPlay(s, world, in);
        top = std::max(top, s.walker.position.y);
        ASSERT_LT(s.walker.position.x, 30);
    }
    EXPECT_GT(top, 0.4);
}

TEST(PlayTrunks, WhereDensityIsNoneItWalksAsIfThereWereNoForest) {
    const PlayWorld clearing = wood(64, 0), full = wood(64);
    PlayWorld bare;
    bare.terrain.size = {64, 64};
    PlayState a = stateAt(clearing, 3, 30), b = stateAt(bare, 3, 30), c = stateAt(full, 3, 30);
    steps(a, clearing, walk(), 1200);
    steps(b, bare, walk(), 1200);
    steps(c, full, walk(), 1200);
    EXPECT_EQ(hashPlay(a), hashPlay(b));
    EXPECT_NE(hashPlay(c), hashPlay(b));
}

TEST(PlayTrunks, AWalkThroughAWoodIsInNoTrunkAndTheSameTwice) {
    const PlayWorld world = wood(64);
    uint64_t hash[2];
    size_t met = 0;
    for (uint64_t& h : hash) {
        PlayState s = stateAt(world, 30, 30);
        s.rollers = {ball(33, 0.25, 30), ball(28, 0.4, 26, 0.4)};
        for (int64_t i = 0; i < 20000; ++i) {
            stepPlay(s, world, scripted(i));
            ASSERT_LT(depthInTrunks(world, place(s), kBodyRadius), kDeepest) << i;
            met += depthInTrunks(world, place(s), kBodyRadius + 1e-6) > 0;
            for (const Roller& r : s.rollers)
                ASSERT_LT(depthInTrunks(world, across(r.position), r.radius), kDeepest) << i;
        }
        h = hashPlay(s);
    }
    EXPECT_EQ(hash[0], hash[1]);
    EXPECT_GT(met, 20u) << "it met some";
}

TEST(PlayTrunks, WhoBeginsInATrunkIsPutBesideIt) {
    PlayWorld world = worldOf();
    plant(world, {treeAt(30, 20), treeAt(40, 20), treeAt(40, 20.5), treeAt(40.4, 20.2), treeAt(0.1, 40)});
    const double sum = kTrunk + kBodyRadius;
    const PlayState off = stateAt(world, 30.1, 20), middle = stateAt(world, 30, 20);
    EXPECT_NEAR(off.walker.position.x, 30 + sum, 1e-9);
    EXPECT_NEAR(off.walker.position.z, 20, 1e-9);
    EXPECT_NEAR(apart(middle, 30, 20), sum, 1e-9);
    for (const glm::dvec2 at :
         {glm::dvec2(40.1, 20.2), glm::dvec2(40, 20.25), glm::dvec2(0.3, 40), glm::dvec2(0, 40)}) {
        const PlayState s = stateAt(world, at.x, at.y);
        EXPECT_LT(depthInTrunks(world, place(s), kBodyRadius), kDeepest) << at.x;
        EXPECT_LT(glm::length(place(s) - at), 1.2);
        EXPECT_GE(s.walker.position.x, kBodyRadius);
    }
    EXPECT_EQ(place(stateAt(world, 30, 22)), glm::dvec2(30, 22));
}

TEST(PlayTrunks, FewTreesAreLookedAtHoweverManyThereAre) {
    size_t most[2] = {0, 0};
    int i = 0;
    for (const double metres : {64.0, 960.0}) {  // 160 and 37,000 trees
        const PlayWorld world = wood(metres);
        for (int k = 0; k < 2000; ++k) {
            size_t looked = 0;
            trunksNear(world, {0.0137 * metres / 64 * (k * 37 % 4001), metres * k / 2000.0}, kBodyRadius, &looked);
            most[i] = std::max(most[i], looked);
        }
        ++i;
    }
    EXPECT_LT(most[0], 130u);
    EXPECT_LT(most[1], 130u);
}

TEST(PlayTrunks, BallsBounceOffThemAndNoneIsTooFast) {
    const PlayWorld world = oneTrunk();
    for (const double speed : {2.0, 20.0, 59.0}) {
        PlayState s = stateAt(world, 5, 50);
        s.rollers = {ball(22, 0.25, 20)};
        s.rollers[0].velocity = {speed, 0, 0};
        s.rollers[0].friction = 0;
        double back = 0;
        for (int i = 0; i < 300; ++i) {
            stepPlay(s, world, {});
            ASSERT_LT(s.rollers[0].position.x, 30 - kTrunk - 0.25 + kDeepest) << speed;
            back = std::min(back, s.rollers[0].velocity.x);
        }
        EXPECT_NEAR(back, speed > 2 ? -0.3 * speed : 0.0, speed > 2 ? 0.1 * speed : 2) << speed;
    }
}

TEST(PlayTrunks, ABallRestsAgainstATrunkDownASlopeAndIsNoWayThroughForTheWalker) {
    PlayWorld world = worldOf([](double x, double) { return 20 - 0.2 * x; });
    plant(world, {treeAt(30, 20)});
    PlayState s = stateAt(world, 20, 20);
    s.rollers = {ball(27, 16, 20, 0.4)};
    steps(s, world, {}, 900);
    const glm::dvec3 rest = s.rollers[0].position;
    EXPECT_NEAR(glm::length(across(rest) - glm::dvec2(30, 20)), kTrunk + 0.4, 0.01);
    steps(s, world, {}, 300);
    EXPECT_LT(glm::length(s.rollers[0].position - rest), 1e-6);
    for (int i = 0; i < 600; ++i) {
        stepPlay(s, world, walk());
        ASSERT_LT(depthInTrunks(world, place(s), kBodyRadius), kDeepest);
        ASSERT_LT(depthInTrunks(world, across(s.rollers[0].position), 0.4), kDeepest);
    }
}

TEST(PlayTrunks, AWalkAlongAPathGoesAroundThoseOnIt) {
    GroundPath path;
    path.points = {{"", {10, 20}}, {"", {50, 20}}};
    for (const float size : {1.0f, 8.0f}) {
        PlayWorld world = worldOf();
        plant(world, {treeAt(20, 20, size), treeAt(30, 20.3, size), treeAt(50.2, 20, size)});
        PlayState s = stateAt(world, 5, 20);
        PathWalk along = pathWalk(path, {0, 0, 0});
        PlayInput in;
        int taken = 0;
        for (; taken < 3600 && steer(along, world, s.walker, in); ++taken) {
            stepPlay(s, world, in);
            ASSERT_LT(depthInTrunks(world, place(s), kBodyRadius), kDeepest);
        }
        EXPECT_LT(taken, 60 * 32) << size;
        EXPECT_LT(apart(s, 50.2, 20), kTrunk * static_cast<double>(size) + kBodyRadius + 0.6);
    }
}

TEST(PlayTrunks, APlaytestKnowsTheForestsOfItsProject) {
    Fixture f;
    f.ok(f.doc.addEntity("wood"));
    f.ok(f.doc.addComponent("wood", "Forest"));
    f.ok(f.doc.startPlay(f.start()));
    ASSERT_EQ(f.doc.play()->world().forests.size(), 1u);
    EXPECT_GT(f.doc.play()->world().forests[0].thickest, kTrunk);
    for (int i = 0; i < 20; ++i) {
        f.doc.play()->hold(scripted(i * 200));
        f.doc.play()->step(100);
        EXPECT_LT(depthInTrunks(f.doc.play()->world(), place(f.doc.play()->state()), kBodyRadius), kDeepest);
    }
    f.doc.stopPlay();
}

}  // namespace
}  // namespace sward::test
