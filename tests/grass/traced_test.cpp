// Factors of traced light as the engine and shaders read them.
#include "grass/traced.h"

#include <gtest/gtest.h>

#include "core/numerics.h"
#include "support.h"

namespace sward::test {
namespace {

TracedLight someLight() {
    TracedLight t;
    for (size_t i = 0; i < t.blades.direct.size(); ++i)
        t.blades.direct[i] = glm::vec3(0.1f, 0.2f, -0.05f) * static_cast<float>(i + 1);
    t.parts.direct = t.blades.direct;
    for (size_t i = 0; i < t.parts.fill.size(); ++i) t.parts.fill[i] = glm::vec3(0.01f, 0.02f, 0.03f) * float(i);
    t.blades.sky = {glm::vec3(2), glm::vec3(-0.5f), glm::vec3(0.1f)};
    t.blades.ground = {glm::vec3(0.2f), glm::vec3(0), glm::vec3(1)};
    t.soilScattered = {0.01f, 0.02f, -0.1f};
    t.soilSky = 0.4f, t.recollision = 0.45f;
    return t;
}

// What a shader makes of the numbers it is given, at an elevation that rays were traced for.
glm::vec3 asShadersRead(const SpeciesGlobals& g, const glm::vec3& toEye, const glm::vec3& light) {
    const f32::TracedTerms t = f32::tracedTerms(toEye, light);
    const glm::vec4* at = g.traced + TRACED_TERMS * static_cast<int>(std::round(f32::tracedLightAt(light.y)));
    glm::vec3 sum = glm::vec3(at[6]) * t.near2 + glm::vec3(at[7]) * t.glow;
    for (int i = 0; i < 3; ++i) sum += glm::vec3(at[i]) * t.rise[i] + glm::vec3(at[i + 3]) * t.across[i];
    return glm::max(sum, glm::vec3(0));
}

TEST(Traced, ShadersReadTheFactorsAsTheEngineDoes) {
    const glm::vec3 sun(0.6f, 0.8f, 0);
    SpeciesGlobals g{};
    setTraced(g, nullptr);
    EXPECT_EQ(asShadersRead(g, {0.6f, 0.8f, 0}, sun), glm::vec3(1)) << "nothing was traced";
    const TracedLight light = someLight();
    EXPECT_EQ(g.recollision, 0);
    setTraced(g, &light);
    EXPECT_EQ(g.recollision, 0.45f);
    for (const glm::vec3& eye : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::normalize(glm::vec3(-1, 0.2f, 0.7f))}) {
        const glm::vec3 want = tracedDirect(light.blades, eye, sun), got = asShadersRead(g, eye, sun);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], 1e-5f * (1 + want[c]));
    }
}

TEST(Traced, LightFromBladeToBladeIsReadBetweenHeightsAndElevations) {
    SpeciesGlobals g{};
    setTraced(g, nullptr);
    for (const glm::vec4& fill : g.tracedFill) EXPECT_EQ(fill, glm::vec4(0)) << "nothing was traced";
    const TracedLight light = someLight();
    glm::vec4 fill[TRACED_HEIGHTS];
    setSunFill(fill, light, {0, 0.275f, 0});  // half-way from the second elevation to the third
    for (size_t k = 0; k < TRACED_HEIGHTS; ++k)
        EXPECT_NEAR(fill[k].y, 0.02f * (1.5f * TRACED_HEIGHTS + static_cast<float>(k)), 1e-5f);
    for (const float share : {-1.0f, 0.0f, 0.1f, 0.5f, 0.9f, 1.0f, 7.0f}) {
        const glm::vec3 heights = f32::tracedHeights(share);
        EXPECT_NEAR(heights.x + heights.y + heights.z, 1, 1e-6f) << share;
        EXPECT_NEAR(heights.y / 2 + heights.z, glm::clamp(share, 0.0f, 1.0f), 1e-6f) << share;
    }
}

TEST(Traced, FactorsNeverDarkenBelowNothing) {
    const TracedLight light = someLight();
    EXPECT_EQ(tracedDirect(light.blades, {0, 1, 0}, {0, 1, 0}).z, 0.0f) << "its polynomial is negative there";
    EXPECT_EQ(soilScattered(light, 1), 0.0f);
    EXPECT_GT(soilScattered(light, 0.2f), 0.0f);
    EXPECT_EQ(tracedRise(light.blades.sky, 0), glm::vec3(2));
    EXPECT_EQ(tracedRise(light.blades.sky, -1), tracedRise(light.blades.sky, 0))
        << "an eye below the blade looks along the ground";
}

TEST(Traced, DeepGrassHasAllOfItsFactorAtAnyDensityAndSparseGrassByIt) {
    for (const float area : {0.0f, 0.1f, 1.0f, 30.0f}) {
        EXPECT_EQ(f32::tracedShare(1, area), 1.0f) << area;
        EXPECT_EQ(f32::tracedShare(0, area), 0.0f) << area;
    }
    EXPECT_NEAR(f32::tracedShare(0.3f, 0.01f), 0.3f, 0.002f);
    EXPECT_GT(f32::tracedShare(0.3f, 20), 0.99f);
}

TEST(Traced, ATiltedSkyChangesWhatComesFromTheSkyAlone) {
    TracedLight light = someLight();
    light.blades.skyTilt = {glm::vec3(0.5f), glm::vec3(0), glm::vec3(-0.25f)};
    light.shows.sky.fill(glm::vec3(0.3f)), light.shows.skyTilt[1] = glm::vec3(0.1f);
    light.soilTilt = -0.1f;
    const TracedLight here = underSky(light, {1, 2, 0});
    EXPECT_EQ(here.blades.sky[0], light.blades.sky[0] + glm::vec3(0.5f, 1, 0));
    EXPECT_EQ(here.blades.sky[1], light.blades.sky[1]);
    EXPECT_EQ(here.blades.sky[2], light.blades.sky[2] - glm::vec3(0.25f, 0.5f, 0));
    EXPECT_EQ(here.shows.sky[0], light.shows.sky[0]);
    EXPECT_EQ(here.shows.sky[1], light.shows.sky[1] + glm::vec3(0.1f, 0.2f, 0)) << "slices have the same sky";
    EXPECT_NEAR(here.soilSky, 0.4f - 0.1f * (0.2126f + 2 * 0.7152f), 1e-6f);
    EXPECT_EQ(here.blades.direct, light.blades.direct);
    EXPECT_EQ(here.blades.ground, light.blades.ground);
    EXPECT_EQ(underSky(light, glm::vec3(0)).blades.sky, light.blades.sky);
}

// A table that is linear in the sines and the angle is read back everywhere between its directions.
TEST(Traced, WhatIsSeenIsReadBetweenTheDirectionsThatWereTraced) {
    TracedShows shows;
    const auto at = [](float view, float light, float turn) {
        return glm::vec3(1 + view, 2 - light, 0.5f + 0.1f * turn);
    };
    for (size_t v = 0; v < kTracedViews; ++v)
        for (size_t l = 0; l < kTracedLights; ++l)
            for (size_t t = 0; t < kTracedTurns; ++t)
                shows.direct[(v * kTracedLights + l) * kTracedTurns + t] = at(kViewSines[v], kLightSines[l], kTurns[t]);
    for (const float view : {0.04f, 0.3f, 0.7f, 0.97f})
        for (const float light : {0.1f, 0.27f, 0.6f, 0.95f})
            for (const float turn : {0.01f, 0.5f, 2.0f, 3.1f}) {
                const float across = std::sqrt(1 - light * light);
                const glm::vec3 seen = shownDirect(shows.direct, {std::sqrt(1 - view * view), view, 0},
                                                   {across * std::cos(turn), light, across * std::sin(turn)});
                for (int k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], at(view, light, turn)[k], 1e-4f);
            }
    EXPECT_EQ(shownDirect(shows.direct, {1, -0.1f, 0}, {1, -0.5f, 0}).x,
              shownDirect(shows.direct, {1, 0.04f, 0}, {1, 0.1f, 0}).x);
    EXPECT_FALSE(std::isnan(shownDirect(shows.direct, {0, 1, 0}, {0, 1, 0}).z)) << "an eye straight above";
    shows.sky = {glm::vec3(1), glm::vec3(2), glm::vec3(3), glm::vec3(4), glm::vec3(5), glm::vec3(6)};
    EXPECT_EQ(shownRise(shows.sky, 0), glm::vec3(1));
    EXPECT_EQ(shownRise(shows.sky, 1), glm::vec3(6));
    EXPECT_NEAR(shownRise(shows.sky, 0.5f * (kViewSines[2] + kViewSines[3])).y, 3.5f, 1e-5f);
}

}  // namespace
}  // namespace sward::test
