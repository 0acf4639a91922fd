// Light from all around points, and what objects change of it on the ground: against closed forms.
#include "reference/around_tracer.h"

#include <gtest/gtest.h>

#include "around.h"

namespace sward::test {
namespace {

TEST(AroundTracer, OverAPlainIsTheSkysShareAndWhatThePlainThrowsBack) {
    const TempDir dir;
    const Project p = plain(dir);
    const AroundTracer t = tracerOf(p);
    for (const auto& [n, up] :
         {std::pair<glm::vec3, double>{{0, 1, 0}, 1}, {{1, 0, 0}, 0.5}, {{0, 0, -1}, 0.5}, {{0, -1, 0}, 0}}) {
        const AroundFactors f = meanAt(t, {2000, 3, 2000}, n);
        const double below = (1 - up) * double(kPlainAlbedo);
        EXPECT_NEAR(f.sky.y, up + below, 0.02) << n.x << n.y;
        EXPECT_NEAR(f.sun.y, below * std::sin(glm::radians(45.0)), 0.02);
        EXPECT_NEAR(f.ground.y, 0, 0.01) << "the plain goes on to the horizon";
    }
}

TEST(AroundTracer, InABoxThereIsNoneAndUnderARoofLittle) {
    const TempDir dir;
    Project p = plain(dir);
    putObject(p, "box", {{.size = {4, 4, 4}}}, {2000, 0, 2000});
    EXPECT_LT(meanAt(tracerOf(p), {2000, 1, 2000}, {0, 1, 0}).sky.y, 0.001);
    putObject(p, "box", {{.size = {40, 0.2f, 40}}}, {2000, 2, 2000});
    const AroundFactors under = meanAt(tracerOf(p), {2000, 0.5, 2000}, {0, 1, 0});
    EXPECT_LT(under.sky.y, 0.05);
    EXPECT_LT(under.sun.y, 0.05) << "the sun does not come under it";
}

TEST(AroundTracer, GrassColoursWhatIsThrownBack) {
    const TempDir dir;
    Project p = plain(dir);
    const AroundFactors bare = meanAt(tracerOf(p), {2000, 3, 2000}, {0, -1, 0});
    GrassField grass;
    grass.species[0].bladesPerM2 = 20000, grass.species[0].height = 0.1f;
    grass.species[0].rootColor = grass.species[0].midColor = grass.species[0].tipColor = {0.02f, 0.2f, 0.02f};
    put(p, "grass", grass);
    const AroundFactors green = meanAt(tracerOf(p), {2000, 3, 2000}, {0, -1, 0});
    EXPECT_NEAR(bare.sun.x, bare.sun.y, 0.01);
    EXPECT_GT(green.sun.y, 3 * green.sun.x);
    EXPECT_LT(green.sun.x, 0.2f * bare.sun.x);
}

// Black, 400 m long and 2 m high, along x.
void putWall(Project& p, BakeLight light = BakeLight::Traced) {
    putObject(p, "wall", {{.size = {400, 2, 0.2f}, .color = {0, 0, 0}}}, {2000, 0, 2000});
    p.registry.get<StaticMesh>(findEntity(p, "wall"))->bakeLight = light;
}

// A long wall hides half of what lies below the elevation of its top, by the cosine.
TEST(AroundTracer, ALongWallTakesItsShareOfTheSkyFromTheGround) {
    const TempDir dir;
    Project p = plain(dir);
    putWall(p);
    const AroundTracer t = tracerOf(p);
    for (const double off : {0.2, 1.0, 2.0, 5.0}) {
        const auto change = t.changeOnGround(2000, 1999.9 - off);
        ASSERT_TRUE(change);
        const double hidden = (1 - off / std::hypot(off, 2.0)) / 2;
        EXPECT_NEAR(double(change->sky.y), -hidden, 0.03) << off;
        EXPECT_EQ(change->sun, glm::vec3(0)) << "a black wall throws nothing back";
        EXPECT_NEAR(double(shareAfter(*change, t.lights()).y), 1 - hidden, 0.03);
    }
    EXPECT_FALSE(t.changeOnGround(2000, 2000)) << "in the wall";
}

TEST(AroundTracer, AWhiteWallInTheSunBrightensTheGroundBeforeIt) {
    const TempDir dir;
    Project p = plain(dir);
    putObject(p, "wall", {{.size = {400, 2, 0.2f}, .color = {0.9f, 0.9f, 0.9f}}}, {2000, 0, 2000});
    const auto before = tracerOf(p).changeOnGround(2000, 2001.1), behind = tracerOf(p).changeOnGround(2000, 1998.9);
    ASSERT_TRUE(before && behind);
    // The sun in the south at 45 degrees falls on the wall by its cosine; 1 m off it is seen by this share.
    const double seen = (1 - 1 / std::hypot(1.0, 2.0)) / 2;
    EXPECT_NEAR(double(before->sun.y), 0.9 * std::sqrt(0.5) * seen, 0.15 * seen);
    EXPECT_LT(behind->sun.y, 0.3f * before->sun.y);
    EXPECT_GT(before->sky.y, -float(seen)) << "it throws some of the sky's light back, too";
}

TEST(AroundTracer, WhatIsNotTracedChangesNothingOnTheGround) {
    const TempDir dir;
    Project p = plain(dir);
    putWall(p, BakeLight::Local);
    const auto change = tracerOf(p).changeOnGround(2000, 1999);
    ASSERT_TRUE(change);
    EXPECT_EQ(change->sky, glm::vec3(0));
    EXPECT_EQ(tracerOf(p).changeOnGround(2000, 2000)->sky, glm::vec3(0));
}

}  // namespace
}  // namespace sward::test
