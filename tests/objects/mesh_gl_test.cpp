// Objects: drawn where they stand, on the ground, lit by the same light, counted, and gone without a trace.
#include "objects.h"
#include "techniques.h"
#include "world/placement.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

const PassStats* passNamed(const Renderer& r, const std::string& name) {
    for (const PassStats& p : r.stats().passes)
        if (p.name == name) return &p;
    return nullptr;
}
ViewSettings measured() {
    ViewSettings s = small();
    s.measure = true;
    return s;
}
ViewCamera fromSouth() { return {{10, 3, 18}, {10, 1, 10}, 55, 0}; }

TEST(Objects, AnObjectIsDrawnOnceForEachMaterialAndCounted) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Renderer renderer(gpu(), tables());
    ASSERT_TRUE(renderer.draw(p, fromSouth(), measured()));
    ASSERT_TRUE(passNamed(renderer, "objects/mesh"));
    EXPECT_EQ(passNamed(renderer, "objects/mesh")->draws, 1u);
    EXPECT_EQ(passNamed(renderer, "objects/mesh")->instances, 1u);
    put<StaticMesh>(p, "second", {.file = "cube.glb"});
    put<Transform>(p, "second", {{13, 0, 10}});
    ASSERT_TRUE(renderer.draw(p, fromSouth(), measured()));
    EXPECT_EQ(passNamed(renderer, "objects/mesh")->draws, 1u) << "two of one file are one draw";
    EXPECT_EQ(passNamed(renderer, "objects/mesh")->instances, 2u);
    EXPECT_EQ(gpu().ledger.at("objects/mesh"), 24 * 32 + 36 * 4 + 256 + 256 + 4)
        << "vertices, indices, instances, numbers of their first vertices, white: one file is held once";
}

TEST(Objects, WhatTheViewDoesNotSeeIsNotDrawnButMayShade) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Renderer renderer(gpu(), tables());
    const ViewCamera away{{10, 3, 18}, {10, 1, 30}, 55, 0};
    ASSERT_TRUE(renderer.draw(p, away, measured()));
    EXPECT_EQ(passNamed(renderer, "objects/mesh")->draws, 0u);
    EXPECT_EQ(passNamed(renderer, "objects/shadow")->draws, 3u) << "in every map";
}

TEST(Objects, AnObjectStandsOnTheGroundUnlessToldOtherwise) {
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    t.height = field(filled({8, 8, 1, PixelType::F32}, 3), "maps/height.exr");
    put<Transform>(p, "ground", {{100, 5, 0}});
    EXPECT_EQ(placedMeshes(p)[0].at, glm::dvec3(10, 8, 10)) << "the terrain's own place counts";
    p.registry.get<StaticMesh>(findEntity(p, "cube"))->onGround = false;
    EXPECT_EQ(placedMeshes(p)[0].at, glm::dvec3(10, 0, 10));
}

TEST(Objects, TurnsAreAboutXThenZThenY) {
    const TempDir dir;
    Project p = cubeScene(dir.path);
    p.registry.get<StaticMesh>(findEntity(p, "cube"))->rotationDeg = {90, 90, 0};
    // z to -y by x... then y to z by x stays; the heading comes last.
    const glm::dmat3 turn = placedMeshes(p)[0].turn;
    EXPECT_LT(glm::distance(turn * glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0)), 1e-9);
    EXPECT_LT(glm::distance(turn * glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0)), 1e-9);
}

TEST(Objects, AFaceIsLitAsTheGroundIsByWhereItLooks) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = glm::vec3(0.1f);
    Renderer renderer(gpu(), tables());
    ViewSettings s = small();
    const ViewCamera above{{10, 12, 14}, {10, 0, 10}, 55, 0};
    ASSERT_TRUE(renderer.draw(p, above, s));
    const glm::vec3 top = lightAt(renderer, above, s, {10, 2, 10}), front = lightAt(renderer, above, s, {10, 1, 11});
    EXPECT_NEAR(front.y / top.y, 1, 0.25) << "the sun stands at 45 degrees before both; the sky is seen by halves";
    p.registry.remove<Light>(findEntity(p, "sun"));
    ASSERT_TRUE(renderer.draw(p, above, s));
    EXPECT_LT(lightAt(renderer, above, s, {10, 1, 11}).y, lightAt(renderer, above, s, {10, 2, 10}).y)
        << "without sun the top sees the more sky";
}

TEST(Objects, AFileThatIsGoneIsToldAndTheRestIsDrawn) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    put<StaticMesh>(p, "lost", {.file = "lost.glb"});
    Renderer renderer(gpu(), tables());
    ASSERT_TRUE(renderer.draw(p, fromSouth(), measured()));
    EXPECT_EQ(passNamed(renderer, "objects/mesh")->instances, 1u);
}

}  // namespace
}  // namespace sward::test
