// Shadows of hills in lamps' light: where the ray-traced truth has them, and none on open ground.
#include "terrain/lamp_hills.h"

#include "lamps.h"
#include "techniques.h"
#include "world/ground.h"

namespace sward::test {
namespace {

// Level ground of 20 x 20 m with a lamp, and a height at each place; ground shades.
template <class F>
Project hillsAtNight(const glm::dvec3& lamp, F height) {
    Project p;
    Terrain t;
    t.size = {20, 20};
    t.groundColor = glm::vec3(0.1f);
    t.castShadows = true;
    t.height = field(Map({128, 128, 1, PixelType::F32}), "maps/height.exr");
    for (int z = 0; z < 128; ++z)
        for (int x = 0; x < 128; ++x)
            t.height.map.set(x, z, 0, static_cast<float>(height((x + 0.5) / 6.4, (z + 0.5) / 6.4)));
    put(p, "ground", t);
    putLamp(p, "lamp", lamp, {.intensity = 8, .attenuation = 0.1f});
    return p;
}
double bump(double x, double z, double high, double wide) {
    return high * std::exp(-((x - 10) * (x - 10) + (z - 10) * (z - 10)) / (wide * wide));
}
Terrain& groundOf(Project& p) { return *p.registry.get<Terrain>(findEntity(p, "ground")); }
void expectAsInTheTruth(Project& p) {
    Renderer r(gpu(), tables());
    const ThreePictures of = threePictures(r, p, kOver, square(), groundOf(p).castShadows);
    std::vector<glm::dvec2> points;
    for (double x = 3; x <= 17; x += 0.25)
        for (double z = 3; z <= 17; z += 0.25) points.emplace_back(x, z);
    const auto height = [&](double x, double z) { return terrainHeight(groundOf(p), x, z); };
    expectAsInTruth(compareShadows(of, kOver, square(), groundSpots(points, 0.25, height)), 40, 800);
}

TEST(LampHills, BehindAHillItIsDarkWhereTheTruthIsDark) {
    NoGlErrors errors;
    for (const glm::dvec3& lamp : {glm::dvec3(10, 2.5, 16), glm::dvec3(5, 1.5, 7), glm::dvec3(19, 3, 10.3)}) {
        SCOPED_TRACE(lamp.x);
        Project p = hillsAtNight(lamp, [](double x, double z) { return bump(x, z, 2.5, 1.8); });
        expectAsInTheTruth(p);
    }
}

TEST(LampHills, OfADirectionalLightAreThoseOfTheTruth) {
    NoGlErrors errors;
    Project p = hillsAtNight({}, [](double x, double z) { return bump(x, z, 2.5, 1.8); });
    removeEntity(p, "lamp");
    put<Light>(p, "a-sun", {.intensity = 0});
    for (const float azimuth : {160.0f, 270.0f, 10.0f}) {
        SCOPED_TRACE(azimuth);
        put<Light>(p, "moon", {.azimuthDeg = azimuth, .elevationDeg = 22, .intensity = 0.2f});
        expectAsInTheTruth(p);
    }
}

void expectOpen(Project p) {
    for (const ViewCamera& c : {kOver, ViewCamera{{10, 1.7, 3}, {10, 0, 12}, 60, 0}}) {
        Renderer r(gpu(), tables());
        EXPECT_TRUE(has(sceneFeatures(p.registry, tables()), Feature::LampHills));
        EXPECT_LE(mostShaded(r, p, c, groundOf(p).castShadows), 1);
    }
}
TEST(LampHills, LevelGroundAndSlopesThatFaceTheLampAreAsWithoutShadows) {
    NoGlErrors errors;
    const auto level = [](double, double) { return 0.5; };
    expectOpen(hillsAtNight({10, 3, 10}, level));
    expectOpen(hillsAtNight({3, 1, 16}, level));
    expectOpen(hillsAtNight({10, 3, 10}, [](double x, double z) { return -bump(x, z, 1.5, 4); }));
}

TEST(LampHills, AreWalkedAnewOnlyWhereLampOrGroundChanged) {
    NoGlErrors errors;
    Project p = hillsAtNight({10, 2.5, 16}, [](double x, double z) { return bump(x, z, 2.5, 1.8); });
    Renderer r(gpu(), tables());
    const auto walked = [&](const ViewCamera& c) {
        EXPECT_TRUE(r.draw(p, c, square()));
        return drawsOf(r, "terrain/lamp-hills");
    };
    EXPECT_EQ(walked(kOver), 1u);
    ViewCamera moved = kOver;
    moved.eye.x += 2, moved.target.x += 2;
    EXPECT_EQ(walked(moved), 0u) << "the eye";
    const float dark = lightAt(r, moved, square(), {10, 0, 6}).y;
    p.registry.get<Transform>(findEntity(p, "lamp"))->position.x = 16;
    EXPECT_EQ(walked(moved), 1u) << "the lamp";
    EXPECT_GT(lightAt(r, moved, square(), {10, 0, 6}).y, 10 * dark);
    p.registry.get<Transform>(findEntity(p, "lamp"))->position.x = 10;
    groundOf(p).height.map = filled({128, 128, 1, PixelType::F32}, 0);
    EXPECT_EQ(walked(moved), 1u) << "the ground";
    EXPECT_GT(lightAt(r, moved, square(), {10, 0, 6}).y, 10 * dark);
    put<Transform>(p, "ground", {{5, 0, 0}});
    EXPECT_EQ(walked(moved), 1u) << "where it stands";
}

TEST(LampHills, AreNotThereWhereTheGroundOrTheLampCastsNone) {
    NoGlErrors errors;
    Project p = hillsAtNight({10, 2.5, 16}, [](double x, double z) { return bump(x, z, 2.5, 1.8); });
    Renderer r(gpu(), tables());
    const auto drawn = [&] {
        EXPECT_TRUE(r.draw(p, kOver, square()));
        return r.readImage();
    };
    drawn();
    EXPECT_EQ(gpu().ledger.at("terrain/lamp-hills"), 4 * 512 * 512);
    EXPECT_NE(r.explain(p, false).find("lamp-hills  (because of ground)"), std::string::npos);
    Light& lamp = *p.registry.get<Light>(findEntity(p, "lamp"));
    lamp.castShadows = false;
    const std::vector<uint8_t> as = drawn();
    EXPECT_EQ(gpu().ledger.count("terrain/lamp-hills"), 0u);
    groundOf(p).castShadows = false;
    EXPECT_EQ(as, drawn()) << "byte for byte";
    EXPECT_NE(r.explain(p, false).find("lamp-hills: no Terrain with a height map has castShadows"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
