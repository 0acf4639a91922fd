// Tracks of feet and balls in the grass: they press, recover and are forgotten.
#include <algorithm>

#include "editor/playtest/played_project.h"
#include "world/forces.h"

namespace sward {
namespace {

using namespace test;

// Forces that the copy has, of all kinds, as techniques see them.
std::vector<Force> forcesIn(Playtest& play) { return forcesOf(play.project(), play.time()); }

TEST(Tracks, FeetPressTheGrassAndItsTracksRecover) {
    Fixture f;
    f.ok(f.doc.startPlay(f.start()));
    Playtest& play = *f.doc.play();
    play.step(3000);
    const size_t standing = forcesIn(play).size();
    EXPECT_EQ(standing, 3u) << "two feet and the ball";
    for (const Force& force : forcesIn(play)) EXPECT_EQ(force.share, 1) << "what stands there keeps pressing";
    play.hold(walkEast());
    play.step(300);
    const size_t walked = forcesIn(play).size();
    EXPECT_GT(walked, standing + 5);
    size_t most = 0;
    for (int i = 0; i < 60; ++i) {  // ten minutes, to and fro
        PlayInput in = walkEast();
        in.yaw += i % 2 * 3.14159265358979;
        play.hold(in);
        play.step(600);
        most = std::max(most, forcesIn(play).size());
    }
    EXPECT_LT(most, 150u) << "what has recovered is forgotten";
    play.hold({});
    play.step(21 * kTicksPerSecond);
    EXPECT_LE(forcesIn(play).size(), 3u);
    f.doc.stopPlay();
    EXPECT_TRUE(forcesOf(f.doc.project(), 0).empty()) << "the project itself has none";
}

TEST(Tracks, FeetAreWhatAFootWithoutAPlaceSays) {
    Fixture f;
    f.ok(f.doc.addEntity("boots"));
    f.ok(f.doc.addComponent("boots", "ForceSource"));
    f.ok(f.doc.setField("boots.ForceSource.shape", "foot"));
    f.ok(f.doc.setField("boots.ForceSource.radius", "0.4"));
    f.ok(f.doc.setField("boots.ForceSource.recovery", "inf"));
    f.ok(f.doc.startPlay(f.start()));
    f.doc.play()->hold(walkEast());
    f.doc.play()->step(120);
    size_t boots = 0;
    for (const Force& force : forcesIn(*f.doc.play())) boots += force.radius == 0.4f;
    EXPECT_GT(boots, 2u);
    f.doc.stopPlay();
}

}  // namespace
}  // namespace sward
