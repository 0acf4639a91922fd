// Daylight and display: physical ratios, colours and limits of the sky model, tone mapping and sRGB.
#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics.h"

namespace sward {
namespace {

using namespace f64;
constexpr double kPiD = 3.14159265358979323846;

double luminance(const vec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }
vec3 sunAt(double degrees) { return {std::cos(degrees * kPiD / 180), std::sin(degrees * kPiD / 180), 0}; }

// Illuminance of level ground by the sky alone, klx.
vec3 skyIlluminance(const vec3& sun, double turbidity) {
    const SkyModel model = skyModel(sun, turbidity);
    const int rows = 60, columns = 180;
    vec3 sum(0);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double y = (i + 0.5) / rows, a = (j + 0.5) * 2 * kPiD / columns, r = std::sqrt(1 - y * y);
            sum += skyRadianceOf(model, {r * std::cos(a), y, r * std::sin(a)}) * y;
        }
    return sum * (2 * kPiD / (rows * columns));
}

TEST(Sky, SunLightsLevelGroundFourToTenTimesAsMuchAsTheSky) {
    for (double elevation : {30.0, 45.0, 60.0}) {
        const vec3 sun = sunAt(elevation);
        const double direct = luminance(sunIlluminance(sun, 3)) * sun.y, diffuse = luminance(skyIlluminance(sun, 3));
        EXPECT_GT(direct / diffuse, 4) << elevation;
        EXPECT_LT(direct / diffuse, 10) << elevation;
        EXPECT_GT(diffuse, 5);  // klx; measured clear skies give 8 to 15
        EXPECT_LT(diffuse, 20);
        EXPECT_LT(direct, 110);  // klx; the sun above the air gives 133
    }
}

TEST(Sky, IsBluerThanTheSunAndTheSunReddensAsItSinks) {
    for (double elevation : {10.0, 30.0, 60.0}) {
        const vec3 sky = skyIlluminance(sunAt(elevation), 3), sun = sunIlluminance(sunAt(elevation), 3);
        EXPECT_GT(sky.z / sky.x, 1.2 * sun.z / sun.x) << elevation;
    }
    double before = 1e9;
    for (double elevation = 90; elevation >= 1; elevation -= 1) {
        const vec3 sun = sunIlluminance(sunAt(elevation), 3);
        EXPECT_LT(sun.z / sun.x, before);
        before = sun.z / sun.x;
    }
}

TEST(Sky, IsFiniteAndNotNegativeEverywhere) {
    for (double elevation : {90.0, 89.9, 45.0, 1.0, 0.0, -0.2, -1.0, -10.0, -90.0})
        for (double turbidity : {0.0, 1.0, 2.0, 3.0, 6.0, 10.0, 50.0}) {
            const f32::vec3 sun(sunAt(elevation));
            const f32::vec3 direct = f32::sunIlluminance(sun, float(turbidity));
            for (int k = 0; k < 3; ++k) EXPECT_TRUE(direct[k] >= 0 && direct[k] < 140) << elevation;
            for (double view : {90.0, elevation, 0.0, 1e-3, -5.0, -90.0}) {
                const f32::vec3 sky = f32::skyRadiance(f32::vec3(sunAt(view)), sun, float(turbidity));
                for (int k = 0; k < 3; ++k)
                    EXPECT_TRUE(sky[k] >= 0 && sky[k] < 200) << elevation << ' ' << view << ' ' << turbidity;
            }
        }
}

TEST(Sky, DarkensAfterSunsetWithoutAJump) {
    double before = luminance(skyIlluminance(sunAt(3), 3));
    for (double elevation = 2.75; elevation > -12; elevation -= 0.25) {
        const double now = luminance(skyIlluminance(sunAt(elevation), 3));
        EXPECT_LT(now, before * 1.0001) << elevation;
        EXPECT_GT(now, before * 0.75) << elevation;
        before = now;
    }
    EXPECT_LT(before, 0.01);
    EXPECT_EQ(luminance(sunIlluminance(sunAt(-0.3), 3)), 0);
    EXPECT_GT(luminance(sunIlluminance(sunAt(1), 3)), 0);
}

TEST(Sky, AirMassIsOneAtTheZenithAndThirtySixOnTheHorizon) {
    EXPECT_NEAR(airMass(0), 1, 1e-3);
    EXPECT_NEAR(airMass(kPiD / 3), 2, 0.01);
    EXPECT_NEAR(airMass(kPiD / 2), 36.5, 0.5);
}

TEST(Sky, ZenithColourOfAClearNoonIsTheModels) {
    // Preetham, Shirley, Smits: x and y of a blue zenith, by their polynomials at turbidity 2 and a sun 30 degrees off
    // it.
    const vec3 zenith = skyZenith(kPiD / 6, 2);
    EXPECT_NEAR(zenith.y, 0.2508, 0.005);
    EXPECT_NEAR(zenith.z, 0.2564, 0.005);
    const vec3 white = xyYToLinear(0.31271, 0.32902, 1);  // D65
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(white[k], 1, 2e-3);
}

TEST(ToneMap, KeepsDarkColoursHuesAndGreysAndNeverExceedsWhite) {
    for (double v = 0.1; v < 0.79; v += 0.05) {
        const vec3 c = toneMapNeutral({v, v, v});
        EXPECT_NEAR(c.x, v - 0.04, 1e-12);
        EXPECT_EQ(c.x, c.y);
    }
    double before = 0;
    for (double k = 0.01; k < 1e6; k *= 1.2) {
        const vec3 c = toneMapNeutral(vec3(1.0, 0.5, 0.25) * k);
        EXPECT_TRUE(c.x <= 1 && c.x >= c.y && c.y >= c.z && c.z >= 0);
        EXPECT_GE(c.x, before);
        before = c.x;
    }
    EXPECT_GT(before, 0.99);
    EXPECT_EQ(toneMapNeutral(vec3(0)), vec3(0));
}

TEST(Srgb, MatchesTheStandardsPointsAndIsMonotone) {
    EXPECT_NEAR(srgbEncode(0.214041), 0.5, 1e-5);
    EXPECT_NEAR(srgbDecode(0.5), 0.214041, 1e-6);
    EXPECT_EQ(srgbEncode(0), 0);
    EXPECT_NEAR(srgbEncode(1), 1, 1e-12);
    double before = -1;
    for (int i = 0; i <= 4096; ++i) {
        const double now = double(f32::srgbEncode(float(i) / 4096));
        EXPECT_GT(now, before);
        before = now;
    }
}

}  // namespace
}  // namespace sward
