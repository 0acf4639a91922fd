// The sky's model "atmosphere" as drawn: its tables on the GPU, the truth beside it, and nothing of it where no scene
// asks.
#include "sky/atmosphere.h"

#include <cmath>

#include "reference/reference.h"
#include "scenes.h"
#include "sky/air_tables.h"
#include "sky/daylight.h"

namespace sward::test {
namespace {

Project land(float sunDegrees, SkyModel model = SkyModel::Atmosphere) {
    Project p;
    Terrain t;
    t.size = {20, 20};
    put(p, "ground", t);
    put<Light>(p, "sun", {.azimuthDeg = 180, .elevationDeg = sunDegrees});
    put<Sky>(p, "sky", {.model = model, .turbidity = 1.4f});
    return p;
}
ViewSettings tiny() {
    ViewSettings s;
    s.width = 48, s.height = 32, s.msaa = 1;
    return s;
}
// Half of it sky.
ViewCamera level() { return {{10, 2, 10}, {10, 2, 0}, 60, 0}; }

TEST(Atmosphere, TheSkyDrawnIsTheTablesAndTheTruthIsTheSame) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const float sun : {40.0f, 3.0f, -3.0f}) {
        const Project p = land(sun);
        ASSERT_TRUE(r.draw(p, level(), tiny()));
        const std::vector<float> drawn = r.readLinear();
        JobControl control;
        auto scene = ReferenceScene::make(p, tables(), 0, control);
        ASSERT_TRUE(scene);
        ReferenceSettings s;
        s.width = 48, s.height = 32, s.samples = 64;
        const auto truth = scene->trace(level(), s, control);
        ASSERT_TRUE(truth);
        for (size_t i = 0; i < 48 * 15 * 3; ++i)  // rows over the horizon
            ASSERT_NEAR(drawn[i], truth->color[i], 0.015f * truth->color[i] + 4 * truth->error[i])
                << "sun at " << sun << ", " << i;
    }
}

TEST(Atmosphere, HazeBeforeLandIsAsTheTruthHasIt) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = land(25);
    firstOf<Terrain>(p);
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {60000, 60000};
    put<Fog>(p, "haze", {.visibility = 20000});
    const ViewCamera c{{30000, 300, 59000}, {30000, 100, 57000}, 30, 0};
    ASSERT_TRUE(r.draw(p, c, tiny()));
    const std::vector<float> drawn = r.readLinear();
    JobControl control;
    auto scene = ReferenceScene::make(p, tables(), 0, control);
    ASSERT_TRUE(scene);
    ReferenceSettings s;
    s.width = 48, s.height = 32, s.samples = 16;
    s.lighting = ReferenceLighting::Direct;
    const auto truth = scene->trace(c, s, control);
    ASSERT_TRUE(truth);
    for (size_t row = 8; row < 32; row += 4) {
        double is = 0, wanted = 0;
        for (size_t i = row * 48 * 3; i < (row + 1) * 48 * 3; ++i)
            is += double(drawn[i]), wanted += double(truth->color[i]);
        EXPECT_NEAR(is / wanted, 1, 0.03) << row;
    }
}

TEST(Atmosphere, IsFiniteFromNoonToNightAndFarFromTheOrigin) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const float sun : {90.0f, 20.0f, 0.2f, 0.0f, -0.2f, -6.0f, -90.0f})
        for (const glm::dvec3& eye : {glm::dvec3(10, 2, 10), glm::dvec3(90000, 2, -90000), glm::dvec3(10, 90000, 10)}) {
            ASSERT_TRUE(r.draw(land(sun), {eye, eye + glm::dvec3(0, 0, 1), 100, 0}, tiny()));
            for (const float v : r.readLinear())
                ASSERT_TRUE(v >= 0 && v <= 65504) << sun << " " << eye.x << " " << eye.y;
        }
}

TEST(Atmosphere, NoLineLiesAlongTheHorizonOfHazyLand) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = land(30);
    put<Fog>(p, "haze", {.visibility = 3000});
    ViewSettings s = tiny();
    s.height = 200;
    ASSERT_TRUE(r.draw(p, {{10, 2, 10}, {0, 2, 0}, 2, 0}, s));
    const std::vector<float> light = r.readLinear();
    for (size_t row = 97; row < 103; ++row)
        for (size_t k = 0; k < 3; ++k) {
            const double above = double(light[((row - 1) * 48 + 20) * 3 + k]),
                         below = double(light[(row * 48 + 20) * 3 + k]);
            EXPECT_NEAR(below / above, 1, 0.04) << row;
        }
}

TEST(Atmosphere, ASceneWithoutItHoldsRunsAndCompilesNothingOfIt) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const Project with = land(30), without = land(30, SkyModel::Clear);
    ASSERT_TRUE(r.draw(with, level(), tiny()));
    EXPECT_GT(gpu().ledger["sky/atmosphere"], 0);
    EXPECT_NE(r.explain(with, false).find("\natmosphere  (because of sky)"), std::string::npos);
    ASSERT_TRUE(r.draw(without, level(), tiny()));
    EXPECT_FALSE(gpu().ledger.contains("sky/atmosphere"));
    EXPECT_EQ(r.explain(without, false).find("sky/atmosphere"), std::string::npos);
    EXPECT_NE(r.explain(without, false).find("atmosphere: no Sky has the model"), std::string::npos);
    ViewSettings measured = tiny();
    measured.measure = true;
    ASSERT_TRUE(r.draw(without, level(), measured));
    for (const std::string& system : r.stats().systems) EXPECT_NE(system, "sky/atmosphere");
}

// Sky, sun and haze come from the turbidity alone: exporting asks for the same sun.
TEST(Atmosphere, TheSunIsDimmedByTheSameAir) {
    const glm::vec3 low(0.9950f, 0.0998f, 0);
    const glm::vec3 clear = sunKlx(land(6, SkyModel::Clear), low), thin = sunKlx(land(6), low);
    Project hazy = land(6);
    hazy.registry.get<Sky>(findEntity(hazy, "sky"))->turbidity = 4;
    EXPECT_NE(clear, thin);
    EXPECT_LT(sunKlx(hazy, low).x, 0.5f * thin.x);
}

}  // namespace
}  // namespace sward::test
