#include "sky/daylight.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/numerics.h"
#include "scene/project.h"

namespace sward {
namespace {

// A sky and its sun, as frames have them.
struct SkyHere {
    FrameGlobals globals{};
    SkySums sums;
};
SkyHere skyHere(float elevationDeg, float turbidity, SkyModel model) {
    Project p;
    Light sun;
    sun.azimuthDeg = 70, sun.elevationDeg = elevationDeg;
    p.registry.add<Light>(*addEntity(p, "sun"), sun);
    Sky sky;
    sky.turbidity = turbidity, sky.model = model;
    p.registry.add<Sky>(*addEntity(p, "sky"), sky);
    SkyHere here;
    here.globals.exposure = 1;
    addSun(here.globals, p, 0);
    addSky(here.globals, p, 0, here.sums, nullptr);
    return here;
}
FrameGlobals skyOf(float elevation, float turbidity, double* sunAzimuth) {
    const FrameGlobals g = skyHere(elevation, turbidity, SkyModel::Clear).globals;
    *sunAzimuth = std::atan2(g.skySun.z, g.skySun.x);
    return g;
}

glm::vec3 fitted(const FrameGlobals& g, const glm::vec2& way) {
    const auto h = [&g](int i) { return glm::vec3(g.horizon[i]); };
    return f32::horizonLight(h(0), h(1), h(2), h(3), h(4), g.horizonMiddle, g.horizonScale, {g.skySun.x, g.skySun.z},
                             way);
}

// Share by which the fit is off at most, as a share of the sky's largest channel there.
float worstOff(const FrameGlobals& g, double from) {
    float worst = 0;
    for (int i = 0; i < 360; ++i) {
        const double a = from + i * std::numbers::pi / 180;
        const glm::vec2 way(std::cos(a), std::sin(a));
        const glm::vec3 sky = f32::skyRadiance({way.x, 0, way.y}, g.skySun, g.turbidity) * g.skyGain,
                        off = glm::abs(fitted(g, way) - sky);
        worst = std::max(worst, std::max({off.x, off.y, off.z}) / std::max({sky.x, sky.y, sky.z}));
    }
    return worst;
}

// What haze fades into is what stands above it: else a line lies along the horizon.
TEST(Daylight, TheHorizonIsTheSkysInEveryDirection) {
    for (const float turbidity : {2.0f, 4.0f, 8.0f})
        for (const float elevation : {15.0f, 33.0f, 60.0f, 89.0f}) {
            double from = 0;
            const FrameGlobals g = skyOf(elevation, turbidity, &from);
            EXPECT_LT(worstOff(g, from), 0.02f) << "turbidity " << turbidity << ", sun at " << elevation << " degrees";
        }
    // A sun on the horizon has a glow with a tip, which no polynomial has.
    double from = 0;
    EXPECT_LT(worstOff(skyOf(1, 4, &from), from), 0.12f);
}

glm::vec3 tiltAt(float elevation, float turbidity, SkyModel model) {
    return skyHere(elevation, turbidity, model).sums.tilt;
}

// What stands upright has more of the sky's light than level ground says wherever it is brighter towards the horizon.
TEST(Daylight, ASkyIsTiltedAsUprightSurfacesSeeIt) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(tiltAt(33, 3, SkyModel::Uniform)[c], 0, 1e-4f);
    for (const float turbidity : {2.0f, 4.0f}) {
        const glm::vec3 low = tiltAt(15, turbidity, SkyModel::Clear), high = tiltAt(80, turbidity, SkyModel::Clear);
        EXPECT_GT(low.y, 0.1f);
        EXPECT_LT(high.y, low.y) << "the glow about a high sun lights the ground";
    }
}

TEST(Daylight, ThePlainBeginsWhereTheTerrainEnds) {
    const glm::vec2 size(100, 200);
    EXPECT_FLOAT_EQ(f32::plainDistance({50, 2, 50}, size, glm::normalize(glm::vec3(1, -0.5f, 0))),
                    50 / glm::normalize(glm::vec3(1, -0.5f, 0)).x);
    EXPECT_FLOAT_EQ(f32::plainDistance({50, 2, 50}, size, glm::normalize(glm::vec3(0, -0.001f, -1))),
                    2 / glm::normalize(glm::vec3(0, 0.001f, 1)).y);
    EXPECT_FLOAT_EQ(f32::plainDistance({-50, 2, 50}, size, {0, -1, 0}), 2);
    EXPECT_EQ(f32::edgeDistance({0, 50}, size, {-1, 0}), 0);
}

}  // namespace
}  // namespace sward
