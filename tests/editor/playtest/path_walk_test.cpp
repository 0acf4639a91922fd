#include "playtest/path_walk.h"

#include <gtest/gtest.h>

#include "editor/playtest/play_worlds.h"
#include "editor/playtest/played_project.h"

namespace sward::test {
namespace {

GroundPath bent(bool closed = false) {
    GroundPath p;
    p.points = {{"", {10, 10}}, {"", {25, 12}}, {"", {28, 30}}, {"", {12, 28}}};
    p.closed = closed;
    return p;
}

// Walks until the path ends, or so many steps; the farthest that the walker was from the curve once on it.
double walkAlong(PathWalk walk, const GroundCurve& curve, const PlayWorld& world, PlayState& s, int most, int& taken) {
    PlayInput in;
    double farthest = 0;
    bool on = false;
    for (taken = 0; taken < most; ++taken) {
        if (!steer(walk, world, s.walker, in)) break;
        stepPlay(s, world, in);
        const double off = nearestOn(curve, {s.walker.position.x, s.walker.position.z}).distance;
        on = on || off < 0.1;
        if (on) farthest = std::max(farthest, off);
    }
    return farthest;
}

TEST(PathWalk, GoesToTheBeginningAndAlongToTheEnd) {
    const PlayWorld world = worldOf();
    PlayState s = stateAt(world, 5, 5);
    int taken = 0;
    const double length = stationsOn(groundCurve(bent())).back().metres;
    EXPECT_LT(walkAlong(pathWalk(bent(), {0, 0, 0}), groundCurve(bent()), world, s, 6000, taken), 0.4);
    EXPECT_NEAR(s.walker.position.x, 12, 0.2);
    EXPECT_NEAR(s.walker.position.z, 28, 0.2);
    EXPECT_NEAR(taken * kTickSeconds, (length + glm::length(glm::dvec2(5, 5))) / kWalkSpeed, 1.5);
}
TEST(PathWalk, RunsWhereTheInputRunsAndGoesRoundAClosedOne) {
    const PlayWorld world = hills();
    PlayState s = stateAt(world, 10, 10);
    int taken = 0;
    PathWalk walk = pathWalk(bent(true), {0, 0, 0});
    EXPECT_LT(walkAlong(walk, groundCurve(bent(true)), world, s, 6000, taken), 0.5);
    EXPECT_EQ(taken, 6000) << "it has no end";
    PlayInput in;
    in.run = true;
    EXPECT_TRUE(steer(walk, world, s.walker, in));
    EXPECT_TRUE(in.run);
}
TEST(PathWalk, OnATerrainThatStandsElsewhereAndOnOnePoint) {
    PathWalk walk = pathWalk(bent(), {100, 0, -20});
    EXPECT_EQ(walk.stations.front().at, glm::dvec2(110, -10));
    GroundPath spot;
    EXPECT_TRUE(pathWalk(spot, {0, 0, 0}).stations.empty());
    for (const bool closed : {false, true}) {
        spot.points = {{"", {20, 20}}, {"", {20, 20}}};
        spot.closed = closed;
        const PlayWorld world = worldOf();
        PlayState s = stateAt(world, 15, 20);
        int taken = 0;
        walkAlong(pathWalk(spot, {0, 0, 0}), groundCurve(spot), world, s, 2000, taken);
        EXPECT_NEAR(s.walker.position.x, 20, 0.2);
        EXPECT_LT(taken, 2000) << "it arrives";
    }
}

TEST(PathWalk, InAPlaytestOtherInputEndsItAndWrongNamesAreTold) {
    Fixture f;
    f.ok(f.doc.addEntity("way"));
    f.ok(f.doc.addComponent("way", "GroundPath"));
    f.ok(f.doc.startPlay(f.start()));
    Playtest& play = *f.doc.play();
    for (const char* wrong : {"nothing", "ball"}) {
        const Status s = play.walkAlong(wrong);
        ASSERT_FALSE(s);
        EXPECT_NE(s.error().text().find(std::string(wrong) + " has no GroundPath"), std::string::npos);
    }
    const Status empty = play.walkAlong("way");
    ASSERT_FALSE(empty);
    EXPECT_NE(empty.error().text().find("way.GroundPath has no points"), std::string::npos);
    f.doc.stopPlay();
    for (int i = 0; i < 2; ++i) f.ok(f.doc.addListElement("way.GroundPath.points"));
    f.ok(f.doc.setField("way.GroundPath.points[0].at", "[17, 21]"));
    f.ok(f.doc.setField("way.GroundPath.points[1].at", "[17, 30]"));
    f.ok(f.doc.startPlay(f.start()));
    Playtest& along = *f.doc.play();
    f.ok(along.walkAlong("way"));
    along.step(120);
    EXPECT_TRUE(along.walking());
    EXPECT_GT(along.state().walker.position.z, 22);
    PlayInput look = along.held();
    look.move = {0, 0};
    along.hold(look);
    EXPECT_TRUE(along.walking()) << "to look around does not end it";
    along.step(60 * 10);
    EXPECT_FALSE(along.walking());
    EXPECT_NEAR(along.state().walker.position.z, 30, 0.3);
    EXPECT_LT(glm::length(along.state().walker.velocity), 0.01);
    f.ok(along.walkAlong("way"));
    along.hold(walkEast());
    EXPECT_FALSE(along.walking());
}

}  // namespace
}  // namespace sward::test
