// Rays meet objects by their triangles, of 50,000 as well as of one.
#include "tools/scene_objects.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>

#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "scene/locked.h"
#include "support.h"

namespace sward {
namespace {

class Objects : public testing::Test {
  protected:
    void SetUp() override {
        const Solid ball{SolidKind::Ball, glm::vec3(1), glm::vec3(0)};
        test::writeText(dir / "ball.glb", *encodeGlb(makeMesh({&ball, 1})));
        p.dir = dir.path;
    }
    void add(const std::string& name, const glm::dvec3& at, float scale = 1) {
        const Entity e = *addEntity(p, name);
        p.registry.add<Transform>(e, {at});
        StaticMesh mesh;
        mesh.file = "ball.glb", mesh.scale = scale, mesh.onGround = false;
        p.registry.add<StaticMesh>(e, mesh);
        ++revision;
    }
    std::string hit(const glm::dvec3& from, const glm::dvec3& way) {
        const auto met = objects.closest(p, revision, from, way);
        return met ? met->entity : "";
    }
    test::TempDir dir;
    Project p;
    SceneObjects objects;
    uint64_t revision = 1;
};

TEST_F(Objects, OneThatIsScatteredChoosesItsRule) {
    Terrain t;
    t.size = {50, 50};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    const Scatter rule{.meshes = {{"ball", "ball.glb"}}, .perHectare = 200, .distance = 3};
    const Entity e = *addEntity(p, "balls");
    p.registry.add<Scatter>(e, rule);
    ++revision;
    const auto there = scatterOver(rule, findGround(p)).objects;
    ASSERT_FALSE(there.empty());
    for (const ScatteredObject& o : there) EXPECT_EQ(hit(o.at + glm::dvec3(0, 20, 0), {0, -1, 0}), "balls");
    p.registry.add<Hidden>(e, {});
    ++revision;
    EXPECT_EQ(hit(there[0].at + glm::dvec3(0, 20, 0), {0, -1, 0}), "");
    p.registry.remove<Hidden>(e);
    p.registry.add<Locked>(e, {});
    ++revision;
    EXPECT_EQ(hit(there[0].at + glm::dvec3(0, 20, 0), {0, -1, 0}), "");
}

TEST_F(Objects, ATreeChoosesItsForestAndSaysWhichItIs) {
    Terrain t;
    t.size = {60, 60};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    Forest rule;
    rule.species = {TreeSpecies{.name = "oak", .kind = TreeKind::Broadleaf, .height = 9, .leaves = 200}};
    rule.perHectare = 200;
    const Entity e = *addEntity(p, "wood");
    p.registry.add<Forest>(e, rule);
    ++revision;
    const auto trees = standingForest(rule, findGround(p)).trees;
    ASSERT_GT(trees.size(), 20u);
    size_t met = 0;
    for (const StandingTree& tree : trees) {  // at the trunk, from four sides: others may stand before it
        const glm::dvec3 trunk = tree.at + glm::dvec3(0, 0.6, 0);
        const auto there = objects.closest(p, revision, trunk + glm::dvec3(2, 0, 0), {-1, 0, 0});
        if (!there) continue;
        ++met;
        EXPECT_EQ(there->entity, "wood");
        EXPECT_EQ(there->which.substr(0, 5), "oak, ") << there->which;
        EXPECT_NE(there->which.find(fmt::format("one of {} trees", trees.size())), std::string::npos) << there->which;
    }
    EXPECT_EQ(met, trees.size());
    const glm::dvec3 from = trees[0].at + glm::dvec3(2, 0.6, 0);
    EXPECT_EQ(hit(from, {-1, 0, 0}), "wood");
    p.registry.get<Forest>(e)->perHectare = 0;
    ++revision;
    EXPECT_EQ(hit(from, {-1, 0, 0}), "") << "cut down";
    p.registry.get<Forest>(e)->perHectare = 200;
    p.registry.add<Locked>(e, {});
    ++revision;
    EXPECT_EQ(hit(from, {-1, 0, 0}), "");
}

TEST_F(Objects, TreesAreMetAsHighAsTheirForestsVerticalScaleHasThem) {
    Terrain t;
    t.size = {60, 60};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    Forest rule;
    rule.species = {TreeSpecies{.name = "oak", .kind = TreeKind::Broadleaf, .height = 9, .leaves = 200}};
    rule.perHectare = 0;
    rule.placed = {{.at = {30, 30}}};
    const Entity e = *addEntity(p, "wood");
    p.registry.add<Forest>(e, rule);
    // Level rays from one side, as high as each is asked for: how high the highest that meets the tree is.
    const auto top = [&](float scale) {
        p.registry.get<Forest>(e)->verticalScale = scale;
        ++revision;
        const glm::dvec3 foot = standingForest(*p.registry.get<Forest>(e), findGround(p)).trees[0].at;
        double highest = 0;
        for (double up = 0.05; up < 40; up += 0.05)
            for (double aside = -3; aside <= 3; aside += 0.25)
                if (!hit(foot + glm::dvec3(20, up, aside), {-1, 0, 0}).empty()) highest = up;
        return highest;
    };
    const double once = top(1);
    EXPECT_NEAR(once, 9, 1);
    EXPECT_NEAR(top(2), 2 * once, 0.6);
    EXPECT_NEAR(top(0.5f), 0.5 * once, 0.3);
    const auto met = objects.closest(p, revision, {50, 0.3, 30}, {-1, 0, 0});
    ASSERT_TRUE(met);
    EXPECT_NE(met->which.find("4.5 m high"), std::string::npos) << met->which;
}

TEST_F(Objects, FilesAreReadAheadOneByOne) {
    const Solid box{SolidKind::Box, glm::vec3(1), glm::vec3(0)};
    test::writeText(dir / "box.glb", *encodeGlb(makeMesh({&box, 1})));
    add("one", {0, 0, 0});
    add("same", {5, 0, 0});
    add("other", {9, 0, 0});
    p.registry.get<StaticMesh>(findEntity(p, "other"))->file = "box.glb";
    EXPECT_FALSE(objects.hasRead(p, "ball.glb"));
    EXPECT_TRUE(objects.readAhead(p));
    EXPECT_NE(objects.hasRead(p, "ball.glb"), objects.hasRead(p, "box.glb")) << "one of them";
    EXPECT_TRUE(objects.readAhead(p));
    EXPECT_TRUE(objects.hasRead(p, "ball.glb") && objects.hasRead(p, "box.glb"));
    EXPECT_FALSE(objects.readAhead(p));
    EXPECT_EQ(hit({0, 0, 9}, {0, 0, -1}), "one");
}

TEST_F(Objects, RaysGoThroughWhatIsLocked) {
    add("near", {0, 0, -5}), add("far", {0, 0, -10}, 2);
    p.registry.add<Locked>(findEntity(p, "near"), {});
    ++revision;
    EXPECT_EQ(hit({0, 0, 0}, {0, 0, -1}), "far");
}

TEST_F(Objects, TheFirstByItsTrianglesAndNotByItsBox) {
    add("near", {0, 0, -5}), add("far", {0, 0, -10}, 2);
    EXPECT_EQ(hit({0, 0, 0}, {0, 0, -1}), "near");
    EXPECT_NEAR(objects.closest(p, revision, {0, 0, 0}, {0, 0, -1})->distance, 4, 0.02);
    EXPECT_EQ(hit({1.5, 0, 0}, {0, 0, -1}), "far");
    EXPECT_EQ(hit({0.9, 0.9, 0}, {0, 0, -1}), "far") << "past the near one, within its box";
    EXPECT_EQ(hit({1.9, 1.9, 0}, {0, 0, -1}), "") << "a corner of the far one's box";
    EXPECT_EQ(hit({0, 0, 0}, {0, 0, 1}), "");
}

TEST_F(Objects, ItFollowsWhatChanges) {
    add("one", {0, 0, -5});
    EXPECT_EQ(hit({0, 0, 0}, {0, 0, -1}), "one");
    p.registry.get<Transform>(findEntity(p, "one"))->position.x = 9;
    ++revision;
    EXPECT_EQ(hit({0, 0, 0}, {0, 0, -1}), "");
    EXPECT_EQ(hit({9, 0, 0}, {0, 0, -1}), "one");
    p.registry.add<Hidden>(findEntity(p, "one"), {});
    ++revision;
    EXPECT_EQ(hit({9, 0, 0}, {0, 0, -1}), "") << "what is hidden is not met";
}

// Among many each is met where it is, whoever moved, went or came in between, and on ground that rises.
TEST_F(Objects, ItFollowsOneOfManyThatMoved) {
    for (int i = 0; i < 30; ++i) add(fmt::format("ball-{:02}", i), {5.0 * i, 0, 0});
    const auto below = [&](double x) { return hit({x, 50, 0}, {0, -1, 0}); };
    EXPECT_EQ(below(50), "ball-10");
    p.registry.get<Transform>(findEntity(p, "ball-10"))->position.x = 500;
    ++revision;
    EXPECT_EQ(below(50), "");
    EXPECT_EQ(below(500), "ball-10");
    EXPECT_EQ(below(55), "ball-11");
    removeEntity(p, "ball-03");
    add("ball-105", {700, 0, 0});
    EXPECT_EQ(below(15), "");
    EXPECT_EQ(below(20), "ball-04");
    EXPECT_EQ(below(700), "ball-105");
    const auto level = [](float metres) {
        Map map({2, 2, 1, PixelType::F32});
        for (int i = 0; i < 4; ++i) map.set(i % 2, i / 2, 0, metres);
        return MapField{"heights", map};
    };
    Terrain t;
    t.size = {800, 800};
    t.height = level(30);
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    p.registry.get<StaticMesh>(findEntity(p, "ball-04"))->onGround = true;
    ++revision;
    EXPECT_NEAR(objects.closest(p, revision, {20, 50, 0}, {0, -1, 0})->distance, 19, 0.1);
    p.registry.get<Terrain>(findEntity(p, "ground"))->height = level(10);
    ++revision;
    EXPECT_NEAR(objects.closest(p, revision, {20, 50, 0}, {0, -1, 0})->distance, 39, 0.1);
    EXPECT_NEAR(objects.closest(p, revision, {25, 50, 0}, {0, -1, 0})->distance, 49, 0.1) << "not on the ground";
}

TEST_F(Objects, WhatCannotBeReadIsNotMetAndHasNoBox) {
    add("one", {0, 0, -5});
    p.registry.get<StaticMesh>(findEntity(p, "one"))->file = "none.glb";
    EXPECT_EQ(hit({0, 0, 0}, {0, 0, -1}), "");
    EXPECT_FALSE(objects.cornersOf(p, findGround(p), "one"));
    EXPECT_FALSE(objects.cornersOf(p, findGround(p), "nobody"));
}

TEST_F(Objects, ItsBoxTurnsAndGrowsWithIt) {
    add("one", {3, 4, 5}, 2);
    p.registry.get<StaticMesh>(findEntity(p, "one"))->rotationDeg = {0, 90, 0};
    const auto corners = objects.cornersOf(p, findGround(p), "one");
    ASSERT_TRUE(corners);
    EXPECT_LT(glm::length((corners->front() + corners->back()) / 2.0 - glm::dvec3(3, 4, 5)), 0.05);
    EXPECT_NEAR(glm::length((*corners)[1] - (*corners)[0]), 4, 0.05);
    EXPECT_LT(std::abs((*corners)[1].x - (*corners)[0].x), 0.01) << "its x points along the world's z";
}

TEST_F(Objects, OfFiftyThousandARayLooksAtFew) {
    for (int i = 0; i < 50000; ++i) add(fmt::format("ball-{:05}", i), {3.0 * (i % 250), 0, 3.0 * (i / 250)});
    const auto clock = [] { return std::chrono::steady_clock::now(); };
    const auto start = clock();
    EXPECT_EQ(hit({300, 50, 300}, {0, -1, 0}), "ball-25100");
    const auto made = clock();
    size_t most = 0;
    for (int i = 0; i < 100; ++i) {
        const double a = i * 0.0628;
        EXPECT_NE(hit({375, 30, 300}, glm::normalize(glm::dvec3(std::cos(a), -0.12, std::sin(a)))), "nobody");
        most = std::max(most, objects.looked());
    }
    EXPECT_LT(most, 300u) << "boxes";
    const std::chrono::duration<double, std::milli> making = made - start, rays = clock() - made;
    RecordProperty("making_ms", fmt::format("{:.2f}", making.count()));
    RecordProperty("ray_ms", fmt::format("{:.4f}", rays.count() / 100));
    RecordProperty("boxes", static_cast<int>(most));
}

}  // namespace
}  // namespace sward
