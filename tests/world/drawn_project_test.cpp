#include "world/drawn_project.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics.h"
#include "scenes.h"
#include "tests/rows.h"

namespace sward::test {
namespace {

GroundPath across(float width, float falloff, double z = 10) {
    GroundPath p;
    p.points = {{"", {-5, z}}, {"", {8, z}}, {"", {25, z}}};
    p.width = width, p.falloff = falloff;
    return p;
}
const Species& speciesOf(const Project& p) { return firstOf<GrassField>(p)->species[0]; }
MapField paintedOver(float value, int side = 256) { return field(filled({side, side, 1, PixelType::U16}, value)); }

TEST(DrawnProject, WithoutPathsItIsTheProjectItself) {
    Project p = lawn();
    DrawnProject drawn;
    EXPECT_EQ(&drawn.of(p, rows()), &p);
    put(p, "way", GroundPath{});
    EXPECT_EQ(&drawn.of(p, rows()), &p) << "a path without points";
    put(p, "way", across(2, 1));
    EXPECT_NE(&drawn.of(p, rows()), &p);
    p.registry.remove<GroundPath>(findEntity(p, "way"));
    EXPECT_EQ(&drawn.of(p, rows()), &p);
}
TEST(DrawnProject, APathClearsTheBladesOfItsArea) {
    Project p = lawn();
    const double all = virtualBlades(p);
    put(p, "way", across(2, 0));
    EXPECT_NEAR(virtualBlades(DrawnProject().of(p, rows())), all - 200 * 20 * 2, 0.005 * 8000);
    EXPECT_EQ(virtualBlades(p), all) << "what is painted stays";
}
TEST(DrawnProject, FalloffThinsHalfOfWhatItCovers) {
    Project p = lawn();
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density = paintedOver(0.5f);
    const double all = virtualBlades(p);
    put(p, "way", across(2, 1.5f));
    EXPECT_NEAR(virtualBlades(DrawnProject().of(p, rows())), all - 0.5 * 200 * 20 * (2 + 1.5), 0.005 * 7000);
}
TEST(DrawnProject, GrassAboveNothingRaisesDensityAndZeroLeavesIt) {
    Project p = lawn();
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density = paintedOver(0.25f);
    const double all = virtualBlades(p);
    GroundPath path = across(2, 0);
    path.grass = 1;
    put(p, "way", path);
    EXPECT_NEAR(virtualBlades(DrawnProject().of(p, rows())), all + 0.75 * 200 * 20 * 2, 0.005 * 6000);
    path.grass = -0.5f;
    put(p, "way", path);
    EXPECT_NEAR(virtualBlades(DrawnProject().of(p, rows())), all - 0.125 * 200 * 20 * 2, 0.005 * 1000);
    path.grass = 0;
    put(p, "way", path);
    DrawnProject drawn;
    EXPECT_TRUE(speciesOf(drawn.of(p, rows())).density.map.sameTiles(speciesOf(p).density.map));
}
TEST(DrawnProject, APathNarrowerThanTexelsIsAnEvenLine) {
    Project p = lawn();
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density = paintedOver(1, 20);  // of a metre
    for (const double z : {10.0, 10.1, 10.3, 10.5, 10.9}) {
        put(p, "way", across(0.5f, 0, z));
        EXPECT_NEAR(virtualBlades(DrawnProject().of(p, rows())), 200 * (400 - 20 * 0.5), 200 * 20 * 0.13) << z;
    }
}
TEST(DrawnProject, PathsActOneAfterTheOther) {
    Project p = lawn();
    GroundPath first = across(2, 0), second = across(1, 0);
    second.grass = 1;
    put(p, "a", first);
    put(p, "b", second);
    EXPECT_NEAR(virtualBlades(DrawnProject().of(p, rows())), 200 * (400 - 20), 0.005 * 80000) << "grass in the middle";
}
TEST(DrawnProject, TilesThatNoPathReachesAreThePaintedOnes) {
    Project p = lawn();
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density =
        paintedOver(0.5f, 512);  // 4 x 4 tiles of 5 m
    put(p, "way", across(1, 0.5f, 2));
    DrawnProject drawn;
    const Map first = speciesOf(drawn.of(p, rows())).density.map;
    const Map& below = speciesOf(p).density.map;
    for (int tx = 0; tx < 4; ++tx) {
        EXPECT_NE(first.tile(tx, 0), below.tile(tx, 0));
        for (int ty = 1; ty < 4; ++ty) EXPECT_EQ(first.tile(tx, ty), below.tile(tx, ty));
    }
    EXPECT_TRUE(first.sameTiles(speciesOf(drawn.of(p, rows())).density.map)) << "nothing changed, nothing is made";
}
TEST(DrawnProject, AMovedPathLeavesNothingBehindAndPaintShowsThrough) {
    Project p = lawn();
    GrassField& grass = *p.registry.get<GrassField>(findEntity(p, "grass"));
    grass.species[0].density = paintedOver(0.5f, 512);
    DrawnProject drawn;
    put(p, "way", across(1, 0.5f, 2));
    drawn.of(p, rows());
    put(p, "way", across(1, 0.5f, 12.5));
    const Map moved = speciesOf(drawn.of(p, rows())).density.map;
    DrawnProject anew;
    const Map made = speciesOf(anew.of(p, rows())).density.map;
    EXPECT_EQ(moved.hash(), made.hash());
    grass.species[0].density.map.set(100, 320, 0, 1);  // on the path
    grass.species[0].density.map.set(100, 50, 0, 1);   // beside it
    const Map after = speciesOf(drawn.of(p, rows())).density.map;
    EXPECT_EQ(after.at(100, 320), 0);
    EXPECT_EQ(after.at(100, 50), 1);
    EXPECT_EQ(after.tile(3, 3), moved.tile(3, 3)) << "tiles without a stroke stay";
}
TEST(DrawnProject, OnePointMovedMakesOnlyItsSurroundingsAnew) {
    Project p = lawn();
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density = paintedOver(0.5f, 512);
    GroundPath path = across(1, 0.5f);
    path.points = {{"", {1, 2}}, {"", {5.5, 2}}, {"", {11, 2}}, {"", {14, 2}}, {"", {19, 2}}};
    put(p, "way", path);
    DrawnProject drawn;
    const Map before = speciesOf(drawn.of(p, rows())).density.map;
    path.points.back().at.y = 9;
    put(p, "way", path);
    const Map after = speciesOf(drawn.of(p, rows())).density.map;
    EXPECT_EQ(after.tile(0, 0), before.tile(0, 0));
    EXPECT_NE(after.tile(3, 1), before.tile(3, 1));
    DrawnProject anew;
    EXPECT_EQ(after.hash(), speciesOf(anew.of(p, rows())).density.map.hash());
}
TEST(DrawnProject, AMapThatRepeatsIsLaidOutBeforeThePathIsCut) {
    Project p = lawn();
    Species& s = p.registry.get<GrassField>(findEntity(p, "grass"))->species[0];
    s.density = paintedOver(1, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 32; ++x) s.density.map.set(x, y, 0, 0);  // stripes: half of it bare
    s.densityTiling = 4;
    put(p, "way", across(2, 0));
    DrawnProject keeps;
    const Species& out = speciesOf(keeps.of(p, rows()));
    EXPECT_EQ(out.densityTiling, 1);
    EXPECT_EQ(out.density.map.info().width, 256);
    const Tiling before = tilingOf(*firstOf<Terrain>(p), 4), after = tilingOf(*firstOf<Terrain>(p), 1);
    for (double x = 0.3; x < 20; x += 0.71) {
        EXPECT_NEAR(tiledSample(out.density.map, after, x, 4), tiledSample(s.density.map, before, x, 4), 0.51);
        EXPECT_EQ(tiledSample(out.density.map, after, x, 10), 0) << "on the path";
    }
    EXPECT_NEAR(virtualBlades(keeps.of(p, rows())), 200 * (400 - 40) / 2, 200);
}
TEST(DrawnProject, AMapThatRepeatsTooOftenIsLeftAloneAndNamed) {
    Project p = lawn();
    Species& s = p.registry.get<GrassField>(findEntity(p, "grass"))->species[0];
    s.density = paintedOver(1, 64);
    s.densityTiling = 64;
    put(p, "way", across(2, 0));
    EXPECT_TRUE(mapsBeyondPaths(p, rows()).empty()) << "4096 texels";
    s.densityTiling = 65;
    const std::vector<std::string> named = mapsBeyondPaths(p, rows());
    EXPECT_EQ(named, std::vector<std::string>{"grass.GrassField.species[lawn].density"});
    EXPECT_NE(beyondPaths(named[0]).find("lower its tiling"), std::string::npos);
    DrawnProject drawn;
    EXPECT_TRUE(speciesOf(drawn.of(p, rows())).density.map.sameTiles(s.density.map));
    EXPECT_EQ(speciesOf(drawn.of(p, rows())).densityTiling, 65);
    p.registry.remove<GroundPath>(findEntity(p, "way"));
    EXPECT_TRUE(mapsBeyondPaths(p, rows()).empty());
}
TEST(DrawnProject, OnATerrainWithAMapSizeThePathLiesWhereItsPointsAre) {
    Project p = lawn();
    p.registry.get<Terrain>(findEntity(p, "ground"))->mapSize = 8;
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {20, 12};
    put(p, "way", across(2, 0));
    DrawnProject drawn;
    const Project& out = drawn.of(p, rows());
    const Tiling tiling = tilingOf(*firstOf<Terrain>(out), speciesOf(out).densityTiling);
    for (double x = 0.5; x < 20; x += 1) {
        EXPECT_EQ(tiledSample(speciesOf(out).density.map, tiling, x, 10), 0) << x;
        EXPECT_EQ(tiledSample(speciesOf(out).density.map, tiling, x, 6), 1) << x;
    }
}
TEST(DrawnProject, FlowersGiveWayBesideGrass) {
    Project p = lawn();
    Flowers flowers;
    flowers.density = paintedOver(0.5f);
    put(p, "daisies", flowers);
    GroundPath path = across(2, 0);
    path.grass = 0, path.flowers = -1;
    put(p, "way", path);
    DrawnProject drawn;
    const Project& out = drawn.of(p, rows());
    EXPECT_FALSE(speciesOf(out).density.present()) << "grass is left alone";
    EXPECT_EQ(firstOf<Flowers>(out)->density.map.sample(0.5, 0.5), 0);
    EXPECT_NEAR(firstOf<Flowers>(out)->density.map.sample(0.5, 0.2), 0.5f, 1e-4);
}
TEST(DrawnProject, TintLaysItsColourOverTheGround) {
    Project p = lawn();
    GroundPath path = across(2, 0);
    path.tint = 0.5f, path.color = {0.2f, 0.1f, 0.05f};
    put(p, "way", path);
    DrawnProject drawn;
    const Map& bare = firstOf<Terrain>(drawn.of(p, rows()))->terrainMap.map;
    EXPECT_NEAR(bare.sample(0.5, 0.5, 3), 0.5, 0.01);
    EXPECT_NEAR(f32::srgbDecode(bare.sample(0.5, 0.5, 0)), 0.2f, 0.005f) << "no black of what was clear";
    EXPECT_EQ(bare.sample(0.5, 0.2, 3), 0);
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    t.terrainMap = field(filled({256, 256, 4, PixelType::U8}, 1));
    const Map& over = firstOf<Terrain>(drawn.of(p, rows()))->terrainMap.map;
    EXPECT_NEAR(over.sample(0.5, 0.5, 3), 1, 1e-6);
    EXPECT_NEAR(f32::srgbDecode(over.sample(0.5, 0.5, 0)), 0.6f, 0.01f) << "half white, half of 0.2";
    EXPECT_EQ(over.sample(0.5, 0.2, 1), 1);
}

}  // namespace
}  // namespace sward::test
