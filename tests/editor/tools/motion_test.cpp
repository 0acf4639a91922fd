// What a motion does to an entity's fields.
#include "tools/motion.h"

#include <gtest/gtest.h>

#include <map>

#include "model/document.h"
#include "support.h"
#include "techniques.h"
#include "world/placement.h"

namespace sward {
namespace {

// A slope: heights rise by one metre a texel along x.
class Motions : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "p"));
        for (const char* name : {"camera", "lawn", "sun", "sky"}) (void)doc.removeEntity(name);
        ASSERT_TRUE(doc.setField("ground.Terrain.size", "[40, 40]"));
        Map slope({41, 41, 1, PixelType::F32});
        for (int y = 0; y < 41; ++y)
            for (int x = 0; x < 41; ++x) slope.set(x, y, 0, static_cast<float>(x));
        ASSERT_TRUE(doc.setMap("ground.Terrain.height", slope, "slope"));
    }
    void add(const std::string& name, const std::string& component) {
        if (!doc.project().entities.contains(name)) {
            ASSERT_TRUE(doc.addEntity(name));
        }
        ASSERT_TRUE(doc.addComponent(name, component));
    }
    void set(const std::string& path, const std::string& text) {
        const Status s = doc.setField(path, text);
        ASSERT_TRUE(s) << s.error().text();
    }
    // The fields after the motion, by PATH, as texts that were accepted.
    std::map<std::string, std::string> after(const std::string& name, const Motion& motion) {
        const Ground ground = findGround(doc.project());
        const EntityStart start = startOf(doc.project(), handleOf(doc.project(), ground, name, 0));
        std::map<std::string, std::string> out;
        for (const auto& [path, text] : movedFields(start, motion, ground)) {
            set(path, text);
            out[path] = text;
        }
        return out;
    }
    glm::dvec3 vec(const std::string& path) {
        return *static_cast<const glm::dvec3*>(findField(doc.project(), tables().components, path)->value);
    }
    test::TempDir dir;
    Document doc{tables()};
};

Motion move(const glm::dvec3& by) {
    Motion m;
    m.move = by;
    return m;
}
Motion turnY(double degrees, const glm::dvec3& pivot) {
    Motion m;
    m.pivot = pivot, m.axis = {0, 1, 0}, m.angle = glm::radians(degrees);
    return m;
}

TEST_F(Motions, AnObjectOnTheGroundStaysOnItAndRisesOnlyByTheMoveItself) {
    add("bench", "Transform"), add("bench", "StaticMesh");
    set("bench.StaticMesh.file", "models/none.glb");
    set("bench.Transform.position", "[10, 0, 10]");
    after("bench", move({5, 0, 0}));
    EXPECT_EQ(vec("bench.Transform.position"), glm::dvec3(15, 0, 10));
    after("bench", move({0, 1, 0}));
    EXPECT_EQ(vec("bench.Transform.position"), glm::dvec3(15, 1, 10));
    set("bench.StaticMesh.onGround", "false");
    after("bench", move({1, 0, 0}));
    EXPECT_EQ(vec("bench.Transform.position"), glm::dvec3(16, 1, 10)) << "it does not climb";
}

TEST_F(Motions, ALampKeepsItsHeightOverTheGroundOnlyIfAsked) {
    add("lamp", "Transform"), add("lamp", "Light");
    set("lamp.Light.type", "point"), set("lamp.Transform.position", "[10, 14, 20]");
    after("lamp", move({5, 0, 0}));
    EXPECT_EQ(vec("lamp.Transform.position"), glm::dvec3(15, 14, 20));
    Motion along = move({5, 0, 0});
    along.alongGround = true;
    after("lamp", along);
    EXPECT_NEAR(vec("lamp.Transform.position").y, 19.125, 0.001) << "41 texels over 40 m: 1.025 metres a metre";
}

TEST_F(Motions, ACameraTakesItsTargetAlongAndTurnsAboutItsEye) {
    add("view", "Camera");
    set("view.Camera.eye", "[10, 5, 10]"), set("view.Camera.target", "[10, 5, 0]");
    after("view", move({1, 2, 3}));
    EXPECT_EQ(vec("view.Camera.eye"), glm::dvec3(11, 7, 13));
    EXPECT_EQ(vec("view.Camera.target"), glm::dvec3(11, 7, 3));
    after("view", turnY(90, {11, 7, 13}));
    EXPECT_EQ(vec("view.Camera.eye"), glm::dvec3(11, 7, 13));
    EXPECT_LT(glm::length(vec("view.Camera.target") - glm::dvec3(1, 7, 13)), 1e-9) << "to the left: towards -x";
}

TEST_F(Motions, WaterRisesAndAForceTurnsItsHeading) {
    add("lake", "Water");
    set("lake.Water.level", "1.5");
    EXPECT_EQ(after("lake", move({3, 0.25, 3})), (std::map<std::string, std::string>{{"lake.Water.level", "1.75"}}));
    add("pond", "Transform"), add("pond", "Water");
    set("pond.Water.level", "1.5"), set("pond.Water.radius", "6"), set("pond.Transform.position", "[4, 1.5, 5]");
    EXPECT_EQ(after("pond", move({3, 0.25, 2})),
              (std::map<std::string, std::string>{{"pond.Water.level", "1.75"},
                                                  {"pond.Transform.position", "[7, 1.75, 7]"}}));
    Motion grow;
    grow.pivot = {7, 1.75, 7}, grow.scale = 2;
    EXPECT_EQ(after("pond", grow).at("pond.Water.radius"), "12");
    add("foot", "Transform"), add("foot", "ForceSource");
    set("foot.ForceSource.headingDeg", "10");
    EXPECT_EQ(after("foot", turnY(30, {0, 0, 0})).at("foot.ForceSource.headingDeg"), "-20")
        << "headings count clockwise, turns counter-clockwise";
}

TEST_F(Motions, SeveralTurnAndScaleAboutOnePivot) {
    add("stone", "Transform"), add("stone", "StaticMesh");
    set("stone.StaticMesh.file", "models/none.glb"), set("stone.Transform.position", "[12, 0, 10]");
    after("stone", turnY(90, {10, 0, 10}));
    EXPECT_LT(glm::length(vec("stone.Transform.position") - glm::dvec3(10, 0, 8)), 1e-9);
    EXPECT_EQ(vec("stone.StaticMesh.rotationDeg"), glm::dvec3(0, 90, 0));
    Motion grow;
    grow.pivot = {10, 0, 10}, grow.scale = 2;
    EXPECT_EQ(after("stone", grow).at("stone.StaticMesh.scale"), "2");
    EXPECT_LT(glm::length(vec("stone.Transform.position") - glm::dvec3(10, 0, 6)), 1e-9);
    grow.scale = 1e9;
    EXPECT_EQ(after("stone", grow).at("stone.StaticMesh.scale"), "1000") << "within its range";
}

TEST_F(Motions, WhatHasNoPlaceIsLeftAlone) {
    add("wind", "Wind");
    EXPECT_TRUE(after("wind", move({1, 1, 1})).empty());
}

TEST(Turns, DegreesAfterATurnAreTheTurnedRotation) {
    const glm::dvec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const glm::dvec3 start : {glm::dvec3(0), glm::dvec3(20, -130, 35), glm::dvec3(170, 10, -100)})
        for (const glm::dvec3& axis : axes)
            for (const double angle : {0.3, -1.2, 1.5707963267948966, 3.0}) {
                Motion m;
                m.axis = axis, m.angle = angle;
                const glm::dmat3 wanted = rotationOf(glm::degrees(angle) * axis) * rotationOf(start),
                                 got = rotationOf(turnedDegrees(start, axis, angle));
                for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(wanted[c] - got[c]), 1e-6) << angle;
            }
    EXPECT_EQ(turnedDegrees({12.5, 170, -3.25}, {0, 1, 0}, glm::radians(20.0)).x, 12.5);
    EXPECT_NEAR(turnedDegrees({0, 170, 0}, {0, 1, 0}, glm::radians(20.0)).y, -170, 1e-9);
}

}  // namespace
}  // namespace sward
