// Light from all around objects: against that of points, and which objects have it.
#include "reference/object_light.h"

#include <gtest/gtest.h>

#include "around.h"

namespace sward::test {
namespace {

std::vector<TracedObject> tracedOf(const Project& p) {
    JobControl control;
    const auto made = traceObjectLight(p, tables(), 0, control);
    EXPECT_TRUE(made) << made.error().text();
    return made ? made->objects : std::vector<TracedObject>{};
}

// A wall of four corners a side under a roof that reaches over it: in the middle it has the light of its middle.
TEST(ObjectLight, AWallUnderARoofIsAsBrightAsItsMiddle) {
    const TempDir dir;
    Project p = plain(dir);
    putObject(p, "hut", {{.size = {4, 3, 4}}, {.size = {6, 0.2f, 6}, .at = {0, 3, 0}}}, {2000, 0, 2000});
    const auto traced = tracedOf(p);
    ASSERT_EQ(traced.size(), 1u);
    const auto mesh = readMesh(p.dir, "hut.glb");
    ASSERT_TRUE(mesh);
    ASSERT_EQ(traced[0].vertices.size(), mesh->vertices.size());
    double fit = 0, corners = 0;
    int n = 0;
    const AroundTracer t = tracerOf(p);
    for (size_t i = 0; i < mesh->vertices.size(); ++i) {
        const MeshVertex& v = mesh->vertices[i];
        if (v.normal.x < 0.9f || v.position.y > 3.01f || std::abs(v.position.x - 2) > 0.01f) continue;
        fit += double(traced[0].vertices[i].sky.y), ++n;
        corners += double(meanAt(t, glm::dvec3(2000, 0, 2000) + glm::dvec3(v.position), v.normal).sky.y);
    }
    ASSERT_EQ(n, 4);
    double whole = 0;  // over the wall, in an even grid
    for (int i = 0; i < 64; ++i)
        whole +=
            double(t.at({2002, 3 * (i / 8 + 0.5) / 8, 1998 + 4 * (i % 8 + 0.5) / 8}, {1, 0, 0}, uint32_t(i)).sky.y) /
            64;
    EXPECT_NEAR(fit / n, whole, 0.05 * whole);
    EXPECT_LT(corners / n, 0.8 * whole) << "found at the corners themselves it would be darker";
}

// A pillar of four corners a side that stands three quarters deep in a block.
TEST(ObjectLight, WhatLiesInAnotherPartDoesNotDarkenWhatStandsOut) {
    const TempDir dir;
    Project p = plain(dir);
    putObject(p, "pillar", {{.size = {0.4f, 4, 0.4f}}, {.size = {2, 3, 2}}}, {2000, 0, 2000});
    const auto traced = tracedOf(p);
    ASSERT_EQ(traced.size(), 1u);
    const auto mesh = readMesh(p.dir, "pillar.glb");
    ASSERT_TRUE(mesh);
    double low = 0, high = 0;
    int n = 0;
    for (size_t i = 0; i < mesh->vertices.size(); ++i) {
        const MeshVertex& v = mesh->vertices[i];
        if (std::abs(v.normal.y) > 0.1f || std::abs(v.position.x) > 0.21f || std::abs(v.position.z) > 0.21f) continue;
        (v.position.y > 2 ? high : low) += double(traced[0].vertices[i].sky.y) / 8, ++n;
    }
    ASSERT_EQ(n, 16) << "corners of four sides";
    const double open = double(meanAt(tracerOf(p), {2000.2, 3.5, 2000}, {1, 0, 0}).sky.y);
    EXPECT_NEAR(low / 8 + 7 * high / 8, open, 0.07 * open)
        << "0.56 to 0.85 of it, by the seed, were all points to count alike";
}

TEST(ObjectLight, IsOfWhatAsksForItStaysWhereItIsAndIsSmallEnough) {
    const TempDir dir;
    Project p = plain(dir);
    const std::vector<Solid> cube = {{.size = {1, 1, 1}}};
    for (const char* name : {"a", "b", "c", "d"}) putObject(p, name, cube, {2000, 0, 2000});
    p.registry.get<StaticMesh>(findEntity(p, "b"))->bakeLight = BakeLight::Local;
    put<Rolling>(p, "c");
    putObject(p, "d", {{.kind = SolidKind::Leaves, .size = {1, 1, 1}, .count = 40000, .leaf = 0.05f}}, {2010, 0, 2000});
    const auto traced = tracedOf(p);
    ASSERT_EQ(traced.size(), 2u);
    EXPECT_EQ(traced[0].entity, findEntity(p, "a"));
    EXPECT_FALSE(traced[0].vertices.empty());
    EXPECT_EQ(traced[1].entity, findEntity(p, "d"));
    EXPECT_TRUE(traced[1].vertices.empty()) << "160,000 vertices";
    EXPECT_TRUE(has(sceneFeatures(p.registry, tables()), Feature::ObjectLight));
    for (const char* name : {"a", "d"}) p.registry.get<StaticMesh>(findEntity(p, name))->bakeLight = BakeLight::Local;
    EXPECT_FALSE(has(sceneFeatures(p.registry, tables()), Feature::ObjectLight)) << "what rolls does not ask for it";
}

TEST(ObjectLight, IsTheSameAgainAndTellsWhatIsWrong) {
    const TempDir dir;
    Project p = plain(dir);
    putObject(p, "a", {{.size = {1, 1, 1}}}, {2000, 0, 2000});
    const auto one = tracedOf(p), other = tracedOf(p);
    for (size_t i = 0; i < one[0].vertices.size(); ++i) EXPECT_EQ(one[0].vertices[i].sky, other[0].vertices[i].sky);
    JobControl cancelled;
    cancelled.cancel();
    EXPECT_FALSE(traceObjectLight(p, tables(), 0, cancelled));
    writeText(p.dir / "a.glb", "no mesh");
    JobControl control;
    const auto broken = traceObjectLight(p, tables(), 0, control);
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().text().find("a.glb"), std::string::npos) << broken.error().text();
}

}  // namespace
}  // namespace sward::test
