// Scenes whose pictures take too long are noticed when grass changes and when the view rests, and get few blades.
#include "app/long_frame.h"

#include <gtest/gtest.h>

#include "fields.h"
#include "scene/project.h"
#include "techniques.h"

namespace sward {
namespace {

// 72 million blades on 60 x 60 m, drawn one by one.
Project longTurf() {
    Project p;
    Terrain t;
    t.size = {60, 60};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    GrassField f;
    f.technique = "geometry";
    f.species[0].bladesPerM2 = 20000;
    f.species[0].height = 0.05f;
    p.registry.add<GrassField>(*addEntity(p, "turf"), f);
    return p;
}

struct Watch {
    Project project = longTurf();
    ViewCamera camera{{1, 1.7, 1}, {20, 0, 20}, 55, 0};
    uint64_t revision = 1;
    LongFrame frame;

    void look(bool atRest) { followLongFrame(frame, {project, tables(), revision, camera, 320, 240}, atRest); }
    GrassField& turf() { return *project.registry.get<GrassField>(findEntity(project, "turf")); }
};

TEST(LongFrame, IsNoticedBeforeItIsDrawnAndGetsTheBladesOfASecond) {
    Watch w;
    w.look(false);
    EXPECT_GT(w.frame.seconds, kLongFrame);
    EXPECT_EQ(w.frame.slowest.entity, "turf");
    EXPECT_NEAR(shareOfBlades(w.frame) * w.frame.seconds, 1, 1e-9);
    const std::string notice = longFrameNotice(w.frame);
    EXPECT_NE(notice.find("blades of turf (geometry) would take about"), std::string::npos) << notice;
    w.frame.all = true;
    EXPECT_EQ(shareOfBlades(w.frame), 1);
    EXPECT_EQ(longFrameNotice(w.frame).find("would"), std::string::npos);
}

TEST(LongFrame, GrassIsLookedAtAtOnceAndTheViewOnceItRests) {
    Watch w;
    w.look(false);
    const double seconds = w.frame.seconds;
    w.camera.target = {1, 1000, 1.1};  // nothing but sky
    ++w.revision;
    w.look(false);
    EXPECT_EQ(w.frame.seconds, seconds);
    w.look(true);
    EXPECT_EQ(w.frame.seconds, 0);
    EXPECT_EQ(shareOfBlades(w.frame), 1);
    EXPECT_EQ(longFrameNotice(w.frame), "");
    w.camera.target = {20, 0, 20};
    w.look(true);
    EXPECT_EQ(w.frame.seconds, seconds);
    w.frame.all = true;
    w.turf().technique = "hybrid";
    w.look(false);
    EXPECT_LT(w.frame.seconds, kLongFrame);
    EXPECT_FALSE(w.frame.all) << "that was wanted of other grass";
}

}  // namespace
}  // namespace sward
