#include "world/land.h"

#include <gtest/gtest.h>

#include "core/numerics.h"
#include "scene/components.h"

namespace sward {
namespace {

Project land(LandBeyond beyond, float mapSize = 0) {
    Project p;
    Terrain t;
    t.size = {100, 60};
    t.beyond = beyond;
    t.mapSize = mapSize;
    t.groundColor = {0.2f, 0.15f, 0.1f};
    Map m({16, 16, 1, PixelType::F32});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) m.set(x, y, 0, static_cast<float>(x));
    t.height = {"maps/h.exr", m};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    return p;
}
const Terrain& of(const Project& p) { return *findGround(p).terrain; }

TEST(Land, IsNowhereUnlessAskedFor) {
    const Land none = landOf(land(LandBeyond::None));
    EXPECT_EQ(none.reach, 0);
    EXPECT_EQ(landOf(land(LandBeyond::Extend)).reach, kLandReach);
    EXPECT_EQ(landOf(Project{}).reach, 0);
}

TEST(Land, LiesBeyondTheRectangleByTheDistanceToIt) {
    EXPECT_EQ(f64::beyondBy({50, 30}, {100, 60}), 0);
    EXPECT_EQ(f64::beyondBy({100, 0}, {100, 60}), 0);
    EXPECT_EQ(f64::beyondBy({-3, 30}, {100, 60}), 3);
    EXPECT_EQ(f64::beyondBy({103, 64}, {100, 60}), 5);
    EXPECT_EQ(f64::landMean(5, 0), 0);
    EXPECT_EQ(f64::landMean(50, 0.02), 1);
    EXPECT_EQ(f64::landMean(25, 0.02), 0.5);
}

TEST(Land, HasTheColourOfTheEdgeNearestToIt) {
    const auto expect = [](const glm::dvec2& place, double along, const glm::dvec2& edge) {
        const glm::dvec2 at = f64::edgePlace(place, {100, 60}, along);
        EXPECT_NEAR(at.x, edge.x, 1e-12);
        EXPECT_NEAR(at.y, edge.y, 1e-12);
    };
    expect({40, 20}, 0, {40, 20});
    expect({40, 20}, 7, {40, 20});  // on the terrain there is no edge to go along
    expect({110, 20}, 0, {100, 20});
    expect({110, 20}, 5, {100, 25});
    expect({110, 20}, -50, {100, 0});
    expect({40, -3}, 5, {45, 0});
    expect({103, 64}, 5, {96, 60});  // around the corner
    expect({103, 64}, -5, {100, 57});
    EXPECT_EQ(f64::landSpread(0), 0);
    EXPECT_GT(f64::landSpread(10), 1);
}

TEST(Land, ExtendsAsAtItsEdgesAndFadesToTheirMean) {
    const Project extended = land(LandBeyond::Extend), faded = land(LandBeyond::Fade);
    const Land goesOn = landOf(extended), fades = landOf(faded);
    const double edge = terrainHeight(of(faded), 100, 30);
    EXPECT_EQ(landHeight(of(extended), goesOn, 5000, 30), edge);
    EXPECT_EQ(landHeight(of(faded), fades, 100, 30), edge) << "no step at the edge";
    EXPECT_NEAR(landHeight(of(faded), fades, 100.5, 30), edge, 0.01);
    EXPECT_NEAR(landHeight(of(faded), fades, 126, 30), 7.5, 0.1) << "the edges' mean";
    EXPECT_EQ(landHeight(of(faded), fades, 40, 20), terrainHeight(of(faded), 40, 20));
}

TEST(Land, OfMapsThatRepeatGoesOnRepeating) {
    const Project p = land(LandBeyond::Fade, 50);
    const Land l = landOf(p);
    EXPECT_EQ(l.fade, 0);
    EXPECT_EQ(landHeight(of(p), l, 4003, 30), terrainHeight(of(p), 4003, 30));
}

TEST(Land, SendsItsSoilWhereNothingGrowsAndAsACanopyWhereMuchDoes) {
    Project p = land(LandBeyond::Fade);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(landOf(p).mean[k], of(p).groundColor[k], 1e-5f);
    GrassField f;
    f.species[0].rootColor = f.species[0].midColor = f.species[0].tipColor = {0.1f, 0.2f, 0.04f};
    f.species[0].bladesPerM2 = 1e5f;
    f.onTerrain = false;
    p.registry.add<GrassField>(*addEntity(p, "moss"), f);
    EXPECT_NEAR(landOf(p).mean.x, of(p).groundColor.x, 1e-5f) << "what grows on meshes alone is no ground";
    f.onTerrain = true;
    p.registry.add<GrassField>(*addEntity(p, "grass"), f);
    const Land l = landOf(p);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(l.mean[k], 0.5f * f.species[0].midColor[k], 1e-4f);
        EXPECT_NEAR(l.grass[k], 0.5f * f.species[0].midColor[k], 1e-4f);
    }
}

}  // namespace
}  // namespace sward
