// Where entities are taken hold of, and which have icons.
#include "tools/handles.h"

#include <gtest/gtest.h>

#include "scene/locked.h"
#include "support.h"

namespace sward {
namespace {

class Handles : public testing::Test {
  protected:
    template <class C>
    C& add(const std::string& name, const C& component = {}) {
        if (!p.entities.contains(name)) EXPECT_TRUE(addEntity(p, name));
        p.registry.add<C>(findEntity(p, name), component);
        return *p.registry.get<C>(findEntity(p, name));
    }
    Handle of(const std::string& name, double seconds = 0) { return handleOf(p, findGround(p), name, seconds); }
    void SetUp() override {
        add<Terrain>("ground", {});
        add<Transform>("ground", {{0, 2, 0}});
    }
    Project p;
};

TEST_F(Handles, EachKindHasItsPlace) {
    add<Camera>("view").eye = {1, 2, 3};
    EXPECT_EQ(of("view").kind, HandleKind::Camera);
    EXPECT_EQ(of("view").at, glm::dvec3(1, 2, 3));
    add<StaticMesh>("bench").file = "bench.glb";
    add<Transform>("bench", {{5, 1, 6}});
    EXPECT_EQ(of("bench").at, glm::dvec3(5, 3, 6)) << "on the ground";
    add<ForceSource>("foot");
    EXPECT_EQ(of("foot").kind, HandleKind::None) << "the walker's, without a place";
    add<Transform>("foot", {{5, 9, 6}});
    EXPECT_EQ(of("foot").at, glm::dvec3(5, 2, 6));
    add<Water>("lake").level = 1.5f;
    EXPECT_EQ(of("lake").at, glm::dvec3(20, 3.5, 20)) << "in the middle of level ground";
    add<Transform>("pond", {{7, 1, 9}});
    add<Water>("pond").radius = 3;
    EXPECT_EQ(of("pond").kind, HandleKind::Pond);
    EXPECT_EQ(of("pond").at, glm::dvec3(7, 2, 9)) << "in its middle, at its level over the ground's origin";
    EXPECT_EQ(of("ground").kind, HandleKind::Other);
    EXPECT_EQ(of("nobody").kind, HandleKind::None);
}

TEST_F(Handles, ALampIsWhereItShinesAndTheSunHasNoPlace) {
    Light& lamp = add<Light>("lamp");
    lamp.type = LightType::Point, lamp.orbitRadius = 4, lamp.orbitSeconds = 8, lamp.azimuthDeg = 0;
    add<Transform>("lamp", {{10, 5, 10}});
    EXPECT_LT(glm::length(of("lamp").at - glm::dvec3(10, 5, 6)), 1e-9);
    EXPECT_LT(glm::length(of("lamp", 2).at - glm::dvec3(14, 5, 10)), 1e-9) << "a quarter of a turn later";
    add<Light>("sun");
    EXPECT_EQ(of("sun").kind, HandleKind::None);
}

TEST_F(Handles, WhatIsLockedIsNotMovedAndHasNoIcon) {
    add<Camera>("free"), add<Camera>("held");
    add<Locked>("held");
    const std::vector<std::string> chosen = {"free", "held", "nobody"};
    const std::vector<Handle> moved = movable(p, findGround(p), chosen, 0);
    ASSERT_EQ(moved.size(), 1u);
    EXPECT_EQ(moved[0].entity, "free");
    EXPECT_EQ(icons(p, findGround(p), 0).size(), 1u);
}

TEST_F(Handles, IconsAreOfWhatIsNoObjectAndNotHidden) {
    add<Camera>("b-view"), add<Water>("lake"), add<Light>("sun"), add<Camera>("a-view"), add<Camera>("hidden");
    add<Hidden>("hidden");
    add<ForceSource>("stone");
    add<Transform>("stone");
    add<StaticMesh>("stone").file = "stone.glb";
    std::vector<std::string> names;
    for (const Handle& h : icons(p, findGround(p), 0)) names.push_back(h.entity);
    EXPECT_EQ(names, (std::vector<std::string>{"a-view", "b-view", "lake"}));
}

}  // namespace
}  // namespace sward
