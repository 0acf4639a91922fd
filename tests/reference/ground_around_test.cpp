// What objects change of the light on the ground about them: where squares lie, what they say, and how they are packed.
#include "reference/ground_around.h"

#include <gtest/gtest.h>

#include "around.h"
#include "shared/objects.h"

namespace sward::test {
namespace {

std::vector<GroundTile> tilesOf(const Project& p) {
    const AroundTracer tracer = tracerOf(p);
    std::vector<StandingBox> boxes;
    for (const PlacedMesh& m : placedMeshes(p))
        boxes.push_back(standingBox(findGround(p), m, *readMesh(p.dir, m.mesh->file)));
    const auto tiles = traceGround(tracer, p, boxes, JobControl{});
    EXPECT_TRUE(tiles);
    return tiles ? *tiles : std::vector<GroundTile>{};
}
// As shaders/lib/ground_around.glsl reads it; 1 where no tile lies.
glm::vec3 shareIn(const PackedGround& packed, double x, double z) {
    const glm::dvec2 at = glm::dvec2(x, z) / AROUND_CELL, cell = glm::floor(at), in = (at - cell) * (AROUND_SIDE - 1.0);
    const auto key = static_cast<uint32_t>(cell.x) | static_cast<uint32_t>(cell.y) << 16;
    for (const glm::uvec2& entry : packed.table) {
        if (entry.x != key) continue;
        const size_t width = AROUND_ACROSS * AROUND_SIDE;
        const size_t corner = entry.y / AROUND_ACROSS * AROUND_SIDE * width + entry.y % AROUND_ACROSS * AROUND_SIDE;
        const auto i = static_cast<size_t>(std::lround(in.x)), j = static_cast<size_t>(std::lround(in.y));
        return packed.share[corner + j * width + i];
    }
    return glm::vec3(1);
}
Project withCube(const TempDir& dir) {
    Project p = plain(dir);
    putObject(p, "cube", {{.size = {1, 1, 1}, .color = {0.1f, 0.1f, 0.1f}}}, {2001, 0, 2001});
    return p;
}

TEST(GroundAround, ABoxIsAsLargeAsTheObjectAndItsFootAsWhatIsNearTheGround) {
    const TempDir dir;
    Project p = plain(dir);
    putObject(p, "tree", {{.size = {0.2f, 3, 0.2f}}, {.size = {4, 1, 4}, .at = {0, 3, 0}}}, {2000, 0, 2000});
    p.registry.get<StaticMesh>(findEntity(p, "tree"))->scale = 2;
    const PlacedMesh placed = placedMeshes(p)[0];
    const StandingBox box = standingBox(findGround(p), placed, *readMesh(p.dir, "tree.glb"));
    EXPECT_NEAR(box.low.x, 1996, 1e-4);
    EXPECT_NEAR(box.high.y, 2004, 1e-4);
    EXPECT_NEAR(box.footLow.x, 1999.8, 1e-4);
    EXPECT_NEAR(box.footHigh.y, 2000.2, 1e-4);
    EXPECT_NEAR(box.top, 8, 1e-4);
    p.registry.get<Transform>(findEntity(p, "tree"))->position.y = 5;
    EXPECT_GT(standingBox(findGround(p), placedMeshes(p)[0], *readMesh(p.dir, "tree.glb")).footLow.x, 1e9)
        << "nothing of it stands on the ground";
}

TEST(GroundAround, SquaresLieAboutAnObjectFineAtItsFootAndSayWhatRaysFind) {
    const TempDir dir;
    const Project p = withCube(dir);
    const std::vector<GroundTile> tiles = tilesOf(p);
    const AroundTracer tracer = tracerOf(p);
    ASSERT_FALSE(tiles.empty());
    EXPECT_LT(tiles.size(), 30u) << "2 m to each side is as far as it reaches";
    size_t fine = 0;
    for (const GroundTile& t : tiles) {
        ASSERT_EQ(t.change.size(), size_t(t.side * t.side));
        EXPECT_LE(glm::distance(glm::dvec2(t.cell) * 2.0 + 1.0, glm::dvec2(2001)), 6);
        if (t.cell == glm::ivec2(1000)) EXPECT_EQ(t.side, AROUND_SIDE) << "it stands there";
        fine += t.side == AROUND_SIDE;
        const auto direct = tracer.changeOnGround(t.cell.x * 2.0 + kGroundAside, t.cell.y * 2.0 + kGroundAside);
        ASSERT_TRUE(direct);
        EXPECT_EQ(t.change[0].sky, direct->sky) << "its first corner";
    }
    EXPECT_GE(fine, 1u);
    EXPECT_LE(fine, 5u);
    const std::vector<GroundTile> again = tilesOf(p);
    ASSERT_EQ(again.size(), tiles.size());
    for (size_t i = 0; i < tiles.size(); ++i) EXPECT_EQ(again[i].change.back().sky, tiles[i].change.back().sky);
}

TEST(GroundAround, WhatLiesUnderAnObjectIsAsWhatLiesBesideIt) {
    const TempDir dir;
    const Project p = withCube(dir);
    const PackedGround packed = packGround(tilesOf(p), tracerOf(p).lights());
    const float beside = shareIn(packed, 2001.625, 2001).y, under = shareIn(packed, 2001, 2001).y;
    EXPECT_LT(beside, 0.75f) << "at the foot of a wall";
    EXPECT_GT(under, 0.4f) << "else the ground beside it would be mixed with black";
    EXPECT_LT(under, 0.8f);
    EXPECT_GT(shareIn(packed, 2001, 2003.9).y, 0.96f);
    EXPECT_EQ(shareIn(packed, 2030, 2030), glm::vec3(1));
}

// The table is read by the hash: from its slot on, no hole comes before a cell's entry.
TEST(GroundAround, EachSquareIsFoundInTheTable) {
    std::vector<GroundTile> tiles;
    for (int i = 0; i < 500; ++i) {
        AroundFactors change;
        change.sky = glm::vec3(-0.001f * float(i) - 0.1f);
        tiles.push_back({{i % 25 * 7, i / 25 * 3}, 2, std::vector<AroundFactors>(4, change)});
    }
    const PackedGround packed = packGround(tiles, {glm::vec3(1), glm::vec3(0), glm::vec3(0)});
    EXPECT_EQ(packed.table.size(), 1024u);
    EXPECT_EQ(packed.from, glm::ivec2(0));
    EXPECT_EQ(packed.to, glm::ivec2(24 * 7 + 1, 19 * 3 + 1));
    for (uint32_t n = 0; n < tiles.size(); ++n) {
        const glm::uvec2 cell(tiles[n].cell);
        uint32_t slot = f32::hash2(cell.x, cell.y) & 1023;
        while (packed.table[slot].x != (cell.x | cell.y << 16)) {
            ASSERT_NE(packed.table[slot].x, AROUND_EMPTY) << n;
            slot = (slot + 1) & 1023;
        }
        EXPECT_EQ(packed.table[slot].y, n);
        // 0.015 count as no change.
        EXPECT_NEAR(shareIn(packed, 2 * cell.x + 1, 2 * cell.y + 1).x, 0.915f - 0.001f * float(n), 1e-4);
    }
}

TEST(GroundAround, WithoutObjectsOrGroundThereIsNone) {
    const TempDir dir;
    Project p = plain(dir);
    EXPECT_TRUE(tilesOf(p).empty());
    const PackedGround packed = packGround({}, {});
    EXPECT_TRUE(packed.share.empty() && packed.table.empty());
    p = withCube(dir);
    removeEntity(p, "ground");
    EXPECT_TRUE(tilesOf(p).empty());
}

// A floor as large as a town has squares where its edge is, at most so many, and takes no minutes.
TEST(GroundAround, LargeAndFarObjectsAreBounded) {
    const TempDir dir;
    Project p = plain(dir);
    putObject(p, "town", {{.size = {3000, 0.2f, 3000}}}, {2000, 0, 2000});
    putObject(p, "far", {{.size = {1, 1, 1}}}, {1e15, 0, -1e15});
    const std::vector<GroundTile> tiles = tilesOf(p);
    EXPECT_LE(tiles.size(), kMostGroundTiles);
    removeEntity(p, "town");
    EXPECT_TRUE(tilesOf(p).empty()) << "what stands far from the terrain changes nothing there";
    const StandingBox none{glm::dvec2(1e300), glm::dvec2(-1e300), glm::dvec2(1e300), glm::dvec2(-1e300), 0};
    const auto nothing = traceGround(tracerOf(p), p, {none}, JobControl{});
    ASSERT_TRUE(nothing);
    EXPECT_TRUE(nothing->empty()) << "a mesh without vertices";
}

TEST(GroundAround, AThinWallIsFoundAlongAllOfIt) {
    const TempDir dir;
    Project p = plain(dir);
    putObject(p, "wall", {{.size = {60, 2, 0.1f}, .color = {0, 0, 0}}}, {2000, 0, 2000.9});
    const PackedGround packed = packGround(tilesOf(p), tracerOf(p).lights());
    for (double x = 1972; x < 2028; x += 0.5) EXPECT_LT(shareIn(packed, x, 2000.625).y, 0.7f) << x;
}

TEST(GroundAround, CanBeCancelled) {
    const TempDir dir;
    const Project p = withCube(dir);
    JobControl cancelled;
    cancelled.cancel();
    const StandingBox box{{2000.5, 2000.5}, {2001.5, 2001.5}, {2000.5, 2000.5}, {2001.5, 2001.5}, 1};
    EXPECT_FALSE(traceGround(tracerOf(p), p, {box}, cancelled));
}

}  // namespace
}  // namespace sward::test
