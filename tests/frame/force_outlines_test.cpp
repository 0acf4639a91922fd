// Forces in the shape of objects' outlines, as the list of a frame has them.
#include "core/log.h"
#include "fields.h"
#include "objects.h"
#include "world/forces.h"

namespace sward::test {
namespace {

// An L (as tests/mesh/footprint_test.cpp) on level ground at (10, 10) among grass of 0.3 m.
struct Scene {
    TempDir dir;
    Project p;
    std::string log;
    int sink = addLogSink([this](LogLevel, const std::string& text) { log += text + "\n"; });
    Outlines outlines;
    Scene() {
        p.dir = dir.path;
        Terrain t;
        t.size = {20, 20};
        put(p, "ground", t);
        FlatField f;
        f.species[0].height = 0.3f;
        put(p, "grass", f);
        putObject(p, "block",
                  {{.size = {3, 0.5f, 1}, .at = {1.5f, 0, 0.5f}}, {.size = {1, 0.5f, 2}, .at = {0.5f, 0, 1}}},
                  {10, 0, 10});
        ForceSource s;
        s.shape = ForceShape::Outline, s.radius = 0.3f, s.reach = 2;
        put(p, "block", s);
    }
    ~Scene() { removeLogSink(sink); }
    StaticMesh& mesh() { return *p.registry.get<StaticMesh>(findEntity(p, "block")); }
    Transform& place() { return *p.registry.get<Transform>(findEntity(p, "block")); }
    glm::vec3 at(double x, double z) { return forceAt(forcesOf(p, 0, &outlines), {x, z}); }
};

TEST(ForceOutlines, PressInsidePushAtTheRimAndLeaveTheNotchAlone) {
    Scene s;
    EXPECT_EQ(s.at(12.5, 10.5).z, 1);
    EXPECT_EQ(s.at(10.5, 11.6).z, 1);
    for (const double x : {10.02, 10.5, 12.98})
        EXPECT_EQ(glm::vec2(s.at(x, 10.5)), glm::vec2(0)) << "under it nothing pushes blades upright again";
    EXPECT_EQ(s.at(12, 11.6), glm::vec3(0)) << "the notch";
    EXPECT_EQ(s.at(14, 10.5), glm::vec3(0));
    const glm::vec3 rim = s.at(13.12, 10.5);
    EXPECT_GT(rim.x, 0.45f);
    EXPECT_NEAR(rim.y, 0, 0.1f);
    EXPECT_EQ(rim.z, 0);
    EXPECT_GT(s.at(12.5, 11.1).y, 0.5f) << "out of the long arm, into the notch";
}

TEST(ForceOutlines, TurnScaleAndMoveWithTheObject) {
    Scene s;
    s.mesh().rotationDeg.y = 90;  // counter-clockwise: the long arm goes to -z, the short one to +x
    EXPECT_EQ(s.at(10.5, 7.5).z, 1);
    EXPECT_EQ(s.at(11.6, 9.5).z, 1);
    EXPECT_EQ(s.at(11.6, 8), glm::vec3(0)) << "the notch, turned";
    EXPECT_EQ(s.at(12.5, 10.5), glm::vec3(0));
    EXPECT_LT(s.at(10.5, 6.88).y, -0.45f) << "off the turned arm's end";
    s.mesh().scale = 2;
    EXPECT_EQ(s.at(11, 5).z, 1);
    EXPECT_EQ(s.at(13.2, 6), glm::vec3(0)) << "the notch, scaled";
    s.place().position = {5, 0, 15};
    EXPECT_EQ(s.at(6, 10).z, 1);
    EXPECT_EQ(s.at(11, 5), glm::vec3(0));
}

TEST(ForceOutlines, OnlyWhatIsLowerThanTheGrassPresses) {
    Scene s;
    s.place().position.y = 0.5;  // on stilts
    EXPECT_TRUE(forcesOf(s.p, 0, &s.outlines).empty());
    s.p.registry.get<GrassField>(findEntity(s.p, "grass"))->species[0].height = 0.8f;
    EXPECT_EQ(s.at(12.5, 10.5).z, 1) << "tall grass reaches it";
    EXPECT_EQ(s.log, "");
}

TEST(ForceOutlines, WithoutAMeshPressNothingAndSaySoOnce) {
    Scene s;
    s.p.registry.remove<StaticMesh>(findEntity(s.p, "block"));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(forcesOf(s.p, 0, &s.outlines).empty());
    EXPECT_EQ(s.log.find("block.ForceSource.shape"), s.log.rfind("block.ForceSource.shape")) << s.log;
    EXPECT_NE(s.log.find("StaticMesh"), std::string::npos) << s.log;
    put<StaticMesh>(s.p, "block", {.file = "nowhere.glb"});
    EXPECT_TRUE(forcesOf(s.p, 0, &s.outlines).empty());
    EXPECT_NE(s.log.find("nowhere.glb"), std::string::npos) << s.log;
}

TEST(ForceOutlines, AreMadeOnceAMeshAndForgottenWithIt) {
    Scene s;
    const auto first = forcesOf(s.p, 0, &s.outlines)[0].outline;
    s.mesh().rotationDeg.y = 33;
    s.place().position = {7, 0, 7};
    EXPECT_EQ(forcesOf(s.p, 0, &s.outlines)[0].outline, first) << "turned and moved it is the same raster";
    put(s.p, "second", s.mesh());
    put(s.p, "second", *s.p.registry.get<ForceSource>(findEntity(s.p, "block")));
    put(s.p, "second", Transform{{3, 0, 3}});
    EXPECT_EQ(forcesOf(s.p, 0, &s.outlines).at(1).outline, first);
    EXPECT_EQ(s.outlines.count(), 1u);
    s.mesh().rotationDeg.x = 20;
    forcesOf(s.p, 0, &s.outlines);
    EXPECT_EQ(s.outlines.count(), 2u) << "tilted it stands otherwise";
    for (const char* name : {"block", "second"})
        s.p.registry.get<ForceSource>(findEntity(s.p, name))->shape = ForceShape::Object;
    EXPECT_EQ(forcesOf(s.p, 0, &s.outlines).size(), 2u);
    EXPECT_EQ(s.outlines.count(), 0u);
}

TEST(ForceOutlines, ExtremeNumbersStayFinite) {
    Scene s;
    ForceSource& source = *s.p.registry.get<ForceSource>(findEntity(s.p, "block"));
    for (const float radius : {1e-7f, 0.01f, 1000.0f})
        for (const float reach : {1.0f, 20.0f})
            for (const float scale : {0.001f, 1000.0f}) {
                source.radius = radius, source.reach = reach, s.mesh().scale = scale;
                for (const double x : {-1e6, 0.0, 10.0, 10.001, 12.5, 1e6}) {
                    const glm::vec3 f = s.at(x, 10.0005);
                    EXPECT_TRUE(std::isfinite(f.x + f.y + f.z) && f.z >= 0 && f.z <= 1 &&
                                glm::length(glm::vec2(f)) <= 1.00001f)
                        << radius << ' ' << reach << ' ' << scale << ' ' << x;
                }
            }
    EXPECT_EQ(s.at(std::numeric_limits<double>::quiet_NaN(), 10), glm::vec3(0));
}

}  // namespace
}  // namespace sward::test
