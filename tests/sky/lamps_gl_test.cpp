#include "fields.h"
#include "objects.h"
#include "scene/forest.h"
#include "scenes.h"
#include "shared/light.h"
#include "techniques.h"

namespace sward::test {
namespace {

Light lantern() {
    Light l;
    l.type = LightType::Point;
    return l;
}
// Bare flat ground without sun and sky, and a lantern over its middle.
Project night(double height, const Light& light) {
    Project p;
    Terrain t;
    t.size = {20, 20};
    put(p, "ground", t);
    put(p, "lamp", light);
    put(p, "lamp", Transform{{10, height, 10}});
    return p;
}
// Radiance of the middle of the picture.
glm::vec3 middle(Renderer& r, Project& p, double time = 0) {
    ViewSettings s = small();
    s.time = time;
    EXPECT_TRUE(r.draw(p, {{10, 4, 8}, {10, 0, 10}, 40, 0}, s));
    const auto light = r.readLinear();
    const size_t at =
        (static_cast<size_t>(s.height / 2) * static_cast<size_t>(s.width) + static_cast<size_t>(s.width / 2)) * 3;
    return {light[at], light[at + 1], light[at + 2]};
}

TEST(Lamps, FadeWithTheSquareOfTheDistanceByTheirBeta) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Light light = lantern();
    Project one = night(1, light), two = night(2, light);
    const float at1 = middle(r, one).y, at2 = middle(r, two).y;
    EXPECT_GT(at1, 0.01f);
    EXPECT_NEAR(at2 / at1, (1 + 1.0f) / (1 + 4.0f), 0.01f);
    light.attenuation = 0;
    light.color = {0, 1, 0};
    Project constant = night(2, light);
    const glm::vec3 green = middle(r, constant);
    EXPECT_NEAR(green.y / at1, 2, 0.02f);
    EXPECT_EQ(green.x, 0.0f);
}

TEST(Lamps, MoveWithTheTimeAndComeBack) {
    Renderer r(gpu(), tables());
    Light light = lantern();
    light.orbitRadius = 4;
    light.orbitSeconds = 8;
    light.azimuthDeg = 0;
    Project p = night(1, light);
    const float start = middle(r, p, 0).y;
    EXPECT_NEAR(start, middle(r, p, 8e6).y, 1e-4f * start);
    put(p, "lamp", Transform{{10, 1, 14}});  // now it starts over the middle
    EXPECT_GT(middle(r, p, 0).y, 4 * middle(r, p, 4).y);
}

TEST(Lamps, ASecondDirectionalLightAddsToTheSun) {
    Renderer r(gpu(), tables());
    Project p = lawn();
    put<Light>(p, "zz");
    const auto sum = [&] {
        EXPECT_TRUE(r.draw(p, eyeHeight(), small()));
        double s = 0;
        const auto light = r.readLinear();
        for (size_t i = light.size() * 2 / 3; i < light.size(); ++i) s += light[i];  // no sky
        return s;
    };
    const double both = sum();
    p.registry.get<Light>(findEntity(p, "zz"))->intensity = 0;
    const double one = sum();
    EXPECT_GT(both, 1.3 * one);
    removeEntity(p, "zz");
    EXPECT_EQ(one, sum());
}

TEST(Lamps, AreFiniteInsideABladeOnEveryAxisAndBelowTheHorizonAtTheirBrightest) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = lawn();
    flatField(p, "grass").species[0].bladesPerM2 = 40;
    Light light = lantern();
    light.intensity = 65504;
    light.color = glm::vec3(65504);
    const auto expectFinite = [&](const char* what) {
        ASSERT_TRUE(r.draw(p, {{10, 0.6, 9}, {10, 0, 10}, 55, 0}, small()));
        for (float v : r.readLinear()) ASSERT_TRUE(std::isfinite(v) && v >= 0) << what << ' ' << v;
    };
    put(p, "z-lamp", light);
    for (const float beta : {0.0f, 1.0f, 1e6f})
        for (const glm::dvec3& at : {glm::dvec3(10, 0, 10), glm::dvec3(10.01, 0.05, 10), glm::dvec3(10, 0.6, 9),
                                     glm::dvec3(10, -3, 10), glm::dvec3(1e8, 0, -1e8)}) {
            p.registry.get<Light>(findEntity(p, "z-lamp"))->attenuation = beta;
            put(p, "z-lamp", Transform{at});
            expectFinite("point light");
        }
    light.type = LightType::Directional;
    for (const float elevation : {90.0f, 0.0f, 1e-30f, -0.5f, -90.0f})
        for (const float azimuth : {0.0f, 90.0f, 180.0f, 270.0f}) {
            light.elevationDeg = elevation;
            light.azimuthDeg = azimuth;
            put(p, "z-lamp", light);
            expectFinite("directional light");
        }
}

TEST(Lamps, AreFiniteOnObjectsTreesAndWaterAtTheirBrightest) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const TempDir dir;
    Project p = cubeScene(dir.path);
    put<Water>(p, "lake", {.level = 0.5f});
    put<Forest>(
        p, "trees",
        {.species = {{.leaves = 40}}, .perHectare = 900, .distance = 2, .tileSize = 8, .meshesTo = 14, .voxel = 1});
    Light& light = put<Light>(p, "z-lamp", lantern());
    light.intensity = 65504, light.color = glm::vec3(65504);
    for (const float beta : {0.0f, 1e6f})
        for (const glm::dvec3& at : {glm::dvec3(10, 1, 10), glm::dvec3(11, 1.5, 10), glm::dvec3(9, 0.5, 14)}) {
            light.attenuation = beta;
            put(p, "z-lamp", Transform{at});
            ASSERT_TRUE(r.draw(p, {{13, 4, 18}, {10, 1, 10}, 60, 0}, small()));
            for (float v : r.readLinear()) ASSERT_TRUE(std::isfinite(v) && v >= 0) << at.x << ' ' << v;
        }
}

TEST(Lamps, NoMoreThanTheBlockHoldsShineAndNoneOfThemBreaksIt) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Light light = lantern();
    light.color = {1, 0, 0};
    Project p = night(1, light);
    const float one = middle(r, p).x;
    for (int i = 0; i < 20; ++i) {
        put(p, "lamp" + std::to_string(i), light);
        put(p, "lamp" + std::to_string(i), Transform{{10, 1, 10}});
    }
    EXPECT_NEAR(middle(r, p).x / one, MAX_LIGHTS, 0.01f * MAX_LIGHTS);
}

}  // namespace
}  // namespace sward::test
