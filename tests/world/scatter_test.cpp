// Where scattered objects stand: distances and ranges hold, no place is favoured, and what changes somewhere moves
// nothing far away.
#include "world/scatter.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "techniques.h"

namespace sward {
namespace {

struct ScatteredField {
    Terrain terrain;
    Scatter rule;
    ScatteredField() {
        terrain.size = {200, 100};
        rule.meshes = {{"stone", "stone.glb", 1}};
        rule.perHectare = 400;
        rule.distance = 0;
        rule.slopeDeg = {0, 90};
    }
    Ground ground() const { return {&terrain, {1000, 5, -300}}; }
    Scattering all() const { return scatterOver(rule, ground()); }
    void heights(const std::function<float(int, int)>& f, int side = 64) {
        Map m({side, side, 1, PixelType::F32});
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) m.set(x, y, 0, f(x, y));
        terrain.height = {"maps/h.exr", m};
    }
};

double nearest(const Scattering& s) {
    double least = 1e30;
    for (size_t i = 0; i < s.objects.size(); ++i)
        for (size_t k = i + 1; k < s.objects.size(); ++k)
            least = std::min(least,
                             std::hypot(s.objects[i].at.x - s.objects[k].at.x, s.objects[i].at.z - s.objects[k].at.z));
    return least;
}

TEST(Scatter, WithoutADistanceItIsTheDensityTimesTheArea) {
    const Scattering s = ScatteredField().all();
    EXPECT_NEAR(static_cast<double>(s.objects.size()), 800, 4 * std::sqrt(800.0));
    EXPECT_NEAR(s.asked, 800, 4 * std::sqrt(800.0));
    for (const ScatteredObject& o : s.objects) {
        EXPECT_GE(o.at.x, 1000);
        EXPECT_LE(o.at.x, 1200);
        EXPECT_GE(o.at.z, -300);
        EXPECT_LE(o.at.z, -200);
        EXPECT_EQ(o.at.y, 5) << "the terrain's own place counts";
    }
}

TEST(Scatter, TheDistanceHoldsAndTheNumberIsTheOneAskedFor) {
    ScatteredField f;
    for (const float share : {0.2f, 0.6f, 0.95f}) {  // of the densest
        f.rule.distance = 2;
        f.rule.perHectare = static_cast<float>(kDensestScatter / 4 * 1e4) * share;
        const Scattering s = f.all();
        const double asked = static_cast<double>(f.rule.perHectare) * 2;
        EXPECT_GE(nearest(s), 2) << share;
        EXPECT_NEAR(static_cast<double>(s.objects.size()), asked, 0.04 * asked) << share;
    }
}

TEST(Scatter, WhatDoesNotFitIsLeftOutAndCounted) {
    ScatteredField f;
    f.rule.distance = 4;
    f.rule.perHectare = 2000;
    const Scattering s = f.all();
    EXPECT_GE(nearest(s), 4);
    EXPECT_NEAR(s.asked, 4000, 200) << "it still says what was asked for";
    EXPECT_NEAR(static_cast<double>(s.objects.size()), kDensestScatter / 16 * 20000, 60);
    EXPECT_NE(shortfall("stones", f.rule, s).find(fmt::format("{} of {:.0f}", s.objects.size(), s.asked)),
              std::string::npos)
        << shortfall("stones", f.rule, s);
    f.rule.distance = 1;
    EXPECT_EQ(shortfall("stones", f.rule, f.all()), "");
}

TEST(Scatter, NoPlaceIsFavoured) {
    ScatteredField f;
    f.rule.distance = 1.5f;
    f.rule.perHectare = 1000;
    std::vector<int> columns(10), phases(10);
    int n = 0;
    for (int seed = 1; seed <= 10; ++seed) {
        f.rule.seed = seed;
        for (const ScatteredObject& o : f.all().objects) {
            const double x = o.at.x - 1000;
            ++columns[static_cast<size_t>(std::min(x / 20, 9.0))];
            ++phases[static_cast<size_t>((x - std::floor(x)) * 10)];
            ++n;
        }
    }
    for (const auto& bins : {columns, phases})
        for (const int count : bins) EXPECT_NEAR(count, n / 10.0, 5 * std::sqrt(n / 10.0));
}

TEST(Scatter, TheSameTwiceAndAnotherSeedIsAnother) {
    ScatteredField f;
    f.rule.distance = 2;
    EXPECT_EQ(f.all().hash, f.all().hash);
    const uint64_t first = f.all().hash;
    f.rule.seed = 2;
    EXPECT_NE(f.all().hash, first);
}

TEST(Scatter, RangesHold) {
    ScatteredField f;
    f.heights([](int x, int y) { return 6 * std::sin(0.3f * static_cast<float>(x)) + 0.1f * static_cast<float>(y); });
    f.rule.slopeDeg = {5, 20}, f.rule.heights = {0, 6};
    f.rule.size = {0.5, 0.7}, f.rule.headingDeg = {30, 60};
    const Scattering s = f.all();
    ASSERT_GT(s.objects.size(), 30u);
    EXPECT_NEAR(s.asked, static_cast<double>(s.objects.size()), 0.2 * s.asked) << "what may not stand is not asked for";
    for (const ScatteredObject& o : s.objects) {
        const glm::dvec2 at(o.at.x - 1000, o.at.z + 300);
        const double slope = glm::degrees(std::acos(terrainNormal(f.terrain, at.x, at.y).y));
        EXPECT_GE(slope, 5);
        EXPECT_LE(slope, 20);
        EXPECT_NEAR(o.at.y, 5 + terrainHeight(f.terrain, at.x, at.y), 1e-9);
        EXPECT_GE(o.at.y - 5, 0);
        EXPECT_LE(o.at.y - 5, 6);
        EXPECT_GE(o.scale, 0.5f);
        EXPECT_LE(o.scale, 0.7f);
        const double heading =
            glm::degrees(std::atan2(-static_cast<double>(o.turn[0].z), static_cast<double>(o.turn[0].x)));
        EXPECT_GE(heading, 29.99);
        EXPECT_LE(heading, 60.01);
        EXPECT_EQ(o.turn[1], glm::vec3(0, 1, 0)) << "upright";
    }
}

TEST(Scatter, TheyLeanAsTheGroundWhereTheyAreTold) {
    ScatteredField f;
    f.heights([](int x, int) { return static_cast<float>(x); });
    f.rule.alignToGround = 1;
    const Scattering s = f.all();
    ASSERT_FALSE(s.objects.empty());
    for (const ScatteredObject& o : s.objects) {
        const glm::dvec3 n = terrainNormal(f.terrain, o.at.x - 1000, o.at.z + 300);
        EXPECT_NEAR(glm::distance(glm::dvec3(o.turn[1]), n), 0, 1e-6);
        EXPECT_NEAR(static_cast<double>(glm::determinant(o.turn)), 1, 1e-5);
    }
}

TEST(Scatter, SharesAndTheDensityMapDecide) {
    ScatteredField f;
    f.rule.meshes = {{"a", "a.glb", 3}, {"none", "", 5}, {"b", "b.glb", 1}};
    f.rule.distance = 1;
    Map m({64, 64, 1, PixelType::U16});
    for (int y = 0; y < 64; ++y)
        for (int x = 32; x < 64; ++x) m.set(x, y, 0, 0.5f);
    f.rule.density = {"maps/d.png", m};
    f.rule.perHectare = 2000;
    std::vector<int> count(3);
    int left = 0;
    for (const ScatteredObject& o : f.all().objects) {
        ++count[o.mesh];
        left += o.at.x < 1098;
    }
    EXPECT_EQ(left, 0);
    EXPECT_EQ(count[1], 0) << "a mesh without a file";
    EXPECT_NEAR(count[0] + count[2], 1000, 80) << "half of 2000 on half of it";
    EXPECT_NEAR(count[0], 3 * count[2], 120);
}

TEST(Scatter, AnEditOfTheGroundMovesOnlyWhatStandsThere) {
    ScatteredField f;
    f.heights([](int, int) { return 1.0f; });
    f.rule.distance = 3, f.rule.perHectare = 500, f.rule.slopeDeg = {0, 20};
    const Scattering before = f.all();
    f.terrain.height.map.set(32, 32, 0, 9.0f);  // steep around (101.6, 50.8): texels are 3.1 m wide
    const Scattering after = f.all();
    const auto far = [](const Scattering& s) {
        std::set<std::vector<double>> out;
        for (const ScatteredObject& o : s.objects)
            if (std::hypot(o.at.x - 1101.6, o.at.z + 249.2) > 25)
                out.insert({o.at.x, o.at.y, o.at.z, static_cast<double>(o.scale)});
        return out;
    };
    EXPECT_NE(before.hash, after.hash);
    EXPECT_GT(far(before).size(), 500u);
    EXPECT_EQ(far(before), far(after));
}

TEST(Scatter, WithoutGroundOrBeyondTheLimitThereIsNothing) {
    ScatteredField f;
    EXPECT_TRUE(scatterOver(f.rule, {}).objects.empty());
    f.terrain.size = {10000, 10000};
    f.rule.perHectare = 100;
    EXPECT_TRUE(f.all().objects.empty()) << "a million";
    EXPECT_NE(shortfall("stones", f.rule, f.all()).find("1000000 objects are asked for"), std::string::npos);
}

TEST(Scatter, ItIsEvaluatedAnewOnlyWhenSomethingChanged) {
    ScatteredField f;
    ScatterMemory memory;
    const auto first = memory.of({}, f.ground(), "stones", f.rule);
    EXPECT_EQ(memory.of({}, f.ground(), "stones", f.rule), first);
    f.terrain.groundColor = glm::vec3(0.5f);
    EXPECT_EQ(memory.of({}, f.ground(), "stones", f.rule), first) << "a colour moves nothing";
    f.rule.seed = 7;
    EXPECT_NE(memory.of({}, f.ground(), "stones", f.rule)->hash, first->hash);
    memory.keepOnly({});
    EXPECT_NE(memory.of({}, f.ground(), "stones", f.rule), first);
}

TEST(ScatterRow, SaysWhatCannotBe) {
    Project p;
    Terrain t;
    t.size = {1000, 1000};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    const Entity e = *addEntity(p, "stones");
    const auto faults = [&](const Scatter& s) {
        p.registry.add<Scatter>(e, s);
        std::vector<ComponentFault> out;
        scatterRow().check(p.registry, e, "stones.Scatter", out);
        std::vector<std::string> fields;
        for (const ComponentFault& f : out) fields.push_back(f.field);
        return fields;
    };
    using Fields = std::vector<std::string>;
    const std::vector<ScatterMesh> stone = {{"stone", "stone.glb", 1}};
    EXPECT_EQ(faults({.meshes = stone}), Fields{});
    EXPECT_EQ(faults({}), Fields{"Scatter.meshes"});
    EXPECT_EQ(faults({.meshes = stone, .perHectare = 1000, .distance = 3}), Fields{"Scatter.distance"});
    EXPECT_EQ(faults({.meshes = stone, .perHectare = 3000, .distance = 0}), Fields{"Scatter.perHectare"});
    Scatter turned{.slopeDeg = {30, 10}};
    EXPECT_EQ(scatterRow().repair(&turned).size(), 1u);
    EXPECT_EQ(turned.slopeDeg, glm::dvec2(10, 30));
}

}  // namespace
}  // namespace sward
