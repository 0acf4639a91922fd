// What is scattered keeps off paths and off objects where they are low.
#include "world/keep_off.h"

#include <gtest/gtest.h>

#include "objects.h"
#include "world/scatter.h"

namespace sward::test {
namespace {

Scatter rule() { return {.meshes = {{"stone", "stone.glb", 1}}, .perHectare = 20000, .distance = 0.3f}; }

// The cube of cubeScene covers x and z from 9 to 11.
TEST(KeepOff, NothingStandsOnAnObjectOrWithinTheGapBesideIt) {
    const TempDir dir;
    const Project p = cubeScene(dir.path);
    Scatter s = rule();
    s.gap = 0.5f;
    const auto beside = [&](const ScatteredObject& o) {
        return glm::length(glm::max(glm::abs(glm::dvec2(o.at.x, o.at.z) - 10.0) - 1.0, 0.0));
    };
    double nearest = 1e9;
    for (const ScatteredObject& o : scatterIn(p, s, findGround(p)).objects) nearest = std::min(nearest, beside(o));
    EXPECT_GT(nearest, 0.5 - 0.06) << "an outline is as exact as 1.5 texels";
    EXPECT_LT(nearest, 0.8);
    s.keepOffObjects = false;
    const std::vector<ScatteredObject> all = scatterIn(p, s, findGround(p)).objects;
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const ScatteredObject& o) { return beside(o) == 0; }));
}

TEST(KeepOff, WhatHangsHighIsInNobodysWay) {
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Footprints outlines;
    const auto held = [&] { return keepOffOf(p, findGround(p), rule(), outlines).holds(10, 10); };
    EXPECT_TRUE(held());
    put<Transform>(p, "cube", {{10, 3, 10}});
    StaticMesh& cube = *p.registry.get<StaticMesh>(findEntity(p, "cube"));
    cube.onGround = false;
    EXPECT_FALSE(held());
}

TEST(KeepOff, NothingStandsOnAPathOrWithinTheGapBesideIt) {
    const TempDir dir;
    Project p = cubeScene(dir.path);
    put<GroundPath>(p, "way", {.points = {{"a", {0, 5}}, {"b", {20, 5}}}, .width = 2});
    Scatter s = rule();
    s.gap = 0.25f;
    for (const ScatteredObject& o : scatterIn(p, s, findGround(p)).objects) EXPECT_GE(std::abs(o.at.z - 5), 1.25);
    const std::string with = keepOffInputs(p, findGround(p), s);
    p.registry.get<GroundPath>(findEntity(p, "way"))->points[1].at.y = 6;
    EXPECT_NE(keepOffInputs(p, findGround(p), s), with);
    s.keepOffPaths = s.keepOffObjects = false;
    EXPECT_EQ(keepOffInputs(p, findGround(p), s), "");
    EXPECT_EQ(scatterIn(p, s, findGround(p)).hash, scatterOver(s, findGround(p)).hash);
}

TEST(KeepOff, TheMemoryLooksAgainOnceAnObjectMoved) {
    const TempDir dir;
    Project p = cubeScene(dir.path);
    ScatterMemory memory;
    const auto first = memory.of(p, findGround(p), "stones", rule());
    EXPECT_EQ(memory.of(p, findGround(p), "stones", rule()), first);
    put<Transform>(p, "cube", {{5, 0, 5}});
    EXPECT_NE(memory.of(p, findGround(p), "stones", rule())->hash, first->hash);
}

}  // namespace
}  // namespace sward::test
