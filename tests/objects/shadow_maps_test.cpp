// Matrices into shadow maps: where they put the world, and that their texels stay while the eye moves.
#include "objects/shadow_maps.h"

#include <gtest/gtest.h>

namespace sward::test {
namespace {

const glm::vec3 kSun = glm::normalize(glm::vec3(0.3f, 0.8f, -0.4f));

TEST(ShadowMaps, AxesStandAcrossTheLightAlsoUnderTheZenith) {
    for (const glm::vec3& towards : {kSun, glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(1, 0, 0)}) {
        const LightAxes axes = axesAcross(towards, {1, 2, 3});
        EXPECT_NEAR(glm::length(axes.right), 1, 1e-5);
        EXPECT_NEAR(glm::length(axes.up), 1, 1e-5);
        EXPECT_NEAR(glm::dot(axes.right, axes.up), 0, 1e-5);
        EXPECT_NEAR(glm::dot(axes.right, towards), 0, 1e-5);
        EXPECT_EQ(axes.origin, glm::dvec3(1, 2, 3));
    }
}

TEST(ShadowMaps, TheMiddleOfAMapIsItsCentreAndItsEdgesAreHalfItsWidthAway) {
    const LightAxes axes = axesAcross(kSun, {});
    const glm::dvec3 centre(100, 5, -40), eye(90, 7, -30);
    const glm::mat4 m = mapAround(axes, centre, eye, 20, 512);
    const auto at = [&](const glm::vec3& offset) {
        return glm::vec3(m * glm::vec4(glm::vec3(centre - eye) + offset, 1));
    };
    const float texel = 1.0f / 512;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(at({0, 0, 0})[i], 0.5, texel);
    EXPECT_NEAR((at(axes.right * 20.0f) - at({0, 0, 0})).x, 0.5, 1e-4);
    EXPECT_NEAR((at(axes.up * -20.0f) - at({0, 0, 0})).y, -0.5, 1e-4);
    EXPECT_GT(at(axes.towards).z, at({0, 0, 0}).z) << "nearer to the light is more";
}

TEST(ShadowMaps, TexelsStayAtTheSamePlacesOfTheTerrain) {
    const glm::dvec3 point(103.21, 0.4, -38.7);
    for (const glm::dvec3 by : {glm::dvec3(0), glm::dvec3(1000, 3, -77)}) {
        const LightAxes axes = axesAcross(kSun, by);
        glm::vec2 first(0);
        for (int step = 0; step < 5; ++step) {
            const glm::dvec3 eye = glm::dvec3(90 + 0.37 * step, 7, -30) + by;
            const glm::vec2 texel =
                512.0f * glm::vec2(mapAround(axes, eye, eye, 20, 512) * glm::vec4(point + by - eye, 1));
            const glm::vec2 in = texel - glm::floor(texel);
            if (step == 0) first = in;
            EXPECT_NEAR(in.x, first.x, 0.01) << step;
            EXPECT_NEAR(in.y, first.y, 0.01) << step;
        }
    }
}

TEST(ShadowMaps, WhatStandsBehindTheLightedPartOrFarAsideShadesNothingThere) {
    const LightAxes axes = axesAcross({0, 1, 0}, {});
    ShadowCaster c;
    c.radius = 1;
    const auto shades = [&](const glm::vec3& at) {
        c.centre = at;
        return shadesWithin(axes, c, 10);
    };
    EXPECT_TRUE(shades({0, 0, 0}));
    EXPECT_TRUE(shades({0, 1000, 0})) << "between it and the light";
    EXPECT_FALSE(shades({0, -20, 0})) << "below";
    EXPECT_FALSE(shades({20, 5, 0})) << "aside";
    EXPECT_TRUE(shades({15.5f, 5, 0})) << "its ball reaches in";
}

}  // namespace
}  // namespace sward::test
