// Rays against objects and terrain, and the ground's ambient occlusion against closed forms.
#include "reference/occlusion.h"

#include <gtest/gtest.h>

#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "support.h"
#include "tests/reference/ray_scenes.h"

namespace sward {
namespace {

double seenFrom(const RayScene& rays, double x, double z, int samples = 16384) {
    TerrainSurface level;
    level.size = {100, 100};
    level.heights.resize(4);
    return skySeen(rays, level, x, z, {0, 0}, samples, 5);
}

TEST(Occlusion, OpenGroundSeesAllOfTheSky) { EXPECT_EQ(seenFrom(sceneOf({}), 50, 50), 1); }

TEST(Occlusion, ALongWallTakesHalfOfOneMinusTheCosineToItsEdge) {
    // Of a half-plane's sky a wall up to elevation e hides (1 - cos e) / 2: Nusselt's disc cut by the ellipse of its
    // edge.
    for (const double distance : {0.5, 1.0, 3.0}) {
        const float x = static_cast<float>(50 + distance), far = 1e4f;
        const RayScene rays = sceneOf({quad({x, 0, -far}, {x, 0, far}, {x, 2, far}, {x, 2, -far})});
        const double elevation = std::atan2(2.0, distance);
        EXPECT_NEAR(seenFrom(rays, 50, 50), 1 - (1 - std::cos(elevation)) / 2, 0.004) << distance;
    }
}

TEST(Occlusion, ADomeWithAHoleLeavesTheSquareOfTheHolesSine) {
    // A disc of radius r at height h above: its form factor is r^2 / (r^2 + h^2).
    Triangles disc{{{50, 3, 50}}, {}};
    for (uint32_t i = 0; i <= 256; ++i) {
        const double a = 6.283185307 * i / 256;
        disc.positions.push_back(
            {static_cast<float>(50 + 2 * std::cos(a)), 3, static_cast<float>(50 + 2 * std::sin(a))});
        if (i > 0) disc.indices.insert(disc.indices.end(), {0, i, i + 1});
    }
    EXPECT_NEAR(seenFrom(sceneOf({disc}), 50, 50), 1 - 4.0 / 13, 0.004);
}

TEST(Occlusion, AClosedHemisphereLeavesNothing) {
    const Solid ball{.kind = SolidKind::Ball, .size = {5, 5, 5}, .at = {50, 0, 50}};
    const Mesh mesh = makeMesh({&ball, 1});
    Triangles t;
    for (const MeshVertex& v : mesh.vertices) t.positions.push_back(v.position);
    t.indices = mesh.indices;
    EXPECT_EQ(seenFrom(sceneOf({t}), 50, 50, 1024), 0);
}

TEST(Occlusion, MoreRaysAreNearerToTheTruth) {
    const RayScene rays = sceneOf({quad({51, 0, -1e4f}, {51, 0, 1e4f}, {51, 2, 1e4f}, {51, 2, -1e4f})});
    const double truth = 1 - (1 - std::cos(std::atan2(2.0, 1.0))) / 2;
    TerrainSurface level;
    level.size = {100, 100};
    level.heights.resize(4);
    double last = 1;
    for (const int samples : {4, 64, 1024}) {
        double squares = 0;
        for (uint32_t id = 0; id < 200; ++id) {
            const double error = skySeen(rays, level, 50, 50, {0, 0}, samples, id) - truth;
            squares += error * error;
        }
        const double rms = std::sqrt(squares / 200);
        EXPECT_LT(rms, 0.5 / std::sqrt(samples)) << samples;
        EXPECT_LT(rms, 0.5 * last) << "strata do better than chance";
        last = rms;
    }
}

// --- a project's map ---------------------------------------------------------------------------------------------
struct Scene {
    test::TempDir dir;
    Project p;
    Scene() {
        p.dir = dir.path;
        Terrain t;
        t.size = {20, 10};
        p.registry.add(*addEntity(p, "ground"), t);
        p.registry.add(*addEntity(p, "grass"), GrassField{});
        const Solid box{.size = {4, 2, 4}};
        test::writeText(dir / "box.glb", *encodeGlb(makeMesh({&box, 1})));
        const Entity e = *addEntity(p, "box");
        p.registry.add(e, StaticMesh{.file = "box.glb", .bakeLight = BakeLight::Local});
        p.registry.add(e, Transform{{5, 0, 5}});
    }
};

TEST(Occlusion, AMapIsDarkUnderAnObjectDimBesideItAndBrightFarAway) {
    Scene s;
    JobControl control;
    const Result<Map> map = bakeOcclusion(s.p, {.samples = 256, .size = 80}, control);
    ASSERT_TRUE(map) << map.error().text();
    EXPECT_EQ(map->info(), (MapInfo{80, 40, 1, PixelType::U8})) << "texels are square";
    EXPECT_EQ(map->at(20, 20), 0) << "under the box";
    EXPECT_NEAR(map->at(28, 20), 0.5 + 0.5 * std::cos(std::atan2(2, 0.125)), 0.1)
        << "at the foot of its wall half is left";
    EXPECT_GT(map->at(78, 20), 0.97);
    EXPECT_EQ(control.progress(), 1);
}

TEST(Occlusion, TheSameSceneGivesTheSameMapAndAnotherSceneAnotherHash) {
    Scene s;
    JobControl control;
    const OcclusionSettings settings{.samples = 16, .size = 64};
    EXPECT_EQ(bakeOcclusion(s.p, settings, control)->hash(), bakeOcclusion(s.p, settings, control)->hash());
    const uint64_t before = occlusionHash(s.p, settings);
    EXPECT_EQ(before, occlusionHash(s.p, settings));
    EXPECT_NE(before, occlusionHash(s.p, {.samples = 25, .size = 64}));
    s.p.registry.get<Transform>(findEntity(s.p, "box"))->position.x += 0.1;
    EXPECT_NE(before, occlusionHash(s.p, settings));
    const uint64_t moved = occlusionHash(s.p, settings);
    s.p.registry.get<StaticMesh>(findEntity(s.p, "box"))->castShadows = false;
    EXPECT_NE(moved, occlusionHash(s.p, settings));
    EXPECT_EQ(bakeOcclusion(s.p, settings, control)->at(20, 20), 1) << "what casts no shadow hides no sky";
}

TEST(Occlusion, WhatDarkensTheGroundByItselfIsLeftOut) {
    Scene s;
    JobControl control;
    const OcclusionSettings settings{.samples = 16, .size = 64};
    const uint64_t before = occlusionHash(s.p, settings);
    s.p.registry.get<StaticMesh>(findEntity(s.p, "box"))->bakeLight = BakeLight::Traced;
    EXPECT_NE(before, occlusionHash(s.p, settings));
    EXPECT_EQ(bakeOcclusion(s.p, settings, control)->at(16, 16), 1);
}

TEST(Occlusion, AHollowSeesLessThanAPlainAndASlopeIsNotHiddenByItself) {
    Scene s;
    removeEntity(s.p, "box");
    Terrain& t = *s.p.registry.get<Terrain>(findEntity(s.p, "ground"));
    t.height = {"maps/h.exr", Map({128, 64, 1, PixelType::F32})};
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 128; ++x)
            t.height.map.set(x, z, 0, x < 64 ? 0.1f * static_cast<float>(std::abs(x - 32)) : 3.2f);
    JobControl control;
    const Result<Map> map = bakeOcclusion(s.p, {.samples = 256, .size = 128}, control);
    ASSERT_TRUE(map);
    // A trench of straight sides at slope 0.64 seen from its bottom leaves the cosine of their elevation.
    EXPECT_NEAR(map->at(32, 32), std::cos(std::atan(0.1 / (20.0 / 128))), 0.12) << "rays near the trench's ends escape";
    EXPECT_GT(map->at(100, 32), 0.99) << "level ground does not hide itself";
    EXPECT_GT(map->at(50, 32), map->at(32, 32));
}

TEST(Occlusion, ACancelledBakeGivesNothing) {
    Scene s;
    JobControl control;
    control.cancel();
    EXPECT_FALSE(bakeOcclusion(s.p, {}, control));
}

TEST(Occlusion, AMissingObjectOrTerrainIsToldByName) {
    Scene s;
    JobControl control;
    std::filesystem::remove(s.dir / "box.glb");
    const auto lost = bakeOcclusion(s.p, {}, control);
    ASSERT_FALSE(lost);
    EXPECT_NE(lost.error().text().find("box.glb"), std::string::npos);
    removeEntity(s.p, "ground");
    EXPECT_EQ(bakeOcclusion(s.p, {}, control).error().code, ExitCode::Unsound);
}

}  // namespace
}  // namespace sward
