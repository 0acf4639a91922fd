// Air: closed forms of its columns, phase functions, the planet's geometry in float, and what is known of sunlight.
#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics.h"

namespace sward {
namespace {

constexpr double kPiD = 3.14159265358979323846;

double luminance(const f64::vec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

TEST(Air, ColumnsToTheZenithAreTheScaleHeightsAndHalfTheOzonesWidth) {
    const f64::vec3 up = f64::airColumns(0, 1, 400);
    EXPECT_NEAR(up.x, 8 * (1 - std::exp(-100 / 8.0)), 1e-3);
    EXPECT_NEAR(up.y, 1.2, 1e-3);
    EXPECT_NEAR(up.z, 15, 1e-2);  // a tent 30 km wide
    // A level ray, by the closed form of thin shells: sqrt(pi R H / 2), a little more for curvature.
    const f64::vec3 level = f64::airColumns(0, 0, 4000);
    EXPECT_NEAR(level.x / std::sqrt(kPiD * 6360 * 8 / 2), 1, 0.01);
    EXPECT_NEAR(level.y / std::sqrt(kPiD * 6360 * 1.2 / 2), 1, 0.01);
}

TEST(Air, OfThePapersTurbidityTakesWhatItsTableSays) {
    // Hillaire 2020, table 1: 5.802, 13.558, 33.1 and 4.44 of 1e-6 a metre at the ground; ozone 0.650, 1.881, 0.085.
    const f64::Air air = f64::airOf(1 + 4.44e-3 * 1.2 / (13.558e-3 * 8));
    const f64::vec3 ground = f64::airTakes(air, f64::airDensity(0)), ozone = f64::airTakes(air, f64::airDensity(25));
    EXPECT_NEAR(ground.x, 5.802e-3 + 4.44e-3, 1e-6);
    EXPECT_NEAR(ground.y, 13.558e-3 + 4.44e-3, 1e-6);
    EXPECT_NEAR(ground.z, 33.1e-3 + 4.44e-3, 1e-6);
    EXPECT_NEAR(ozone.y, 1.881e-3 + 13.558e-3 * std::exp(-25 / 8.0), 1e-6);
    EXPECT_NEAR(f64::kHazeScatters, 3.996 / 4.44, 1e-9);
}

TEST(Air, ScattersAllThatItScatters) {
    double rayleigh = 0, haze = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
        const double c = -1 + 2 * (i + 0.5) / n;
        rayleigh += f64::rayleighPhase(c) * 4 * kPiD / n, haze += f64::hazePhase(c) * 4 * kPiD / n;
    }
    EXPECT_NEAR(rayleigh, 1, 1e-6);
    EXPECT_NEAR(haze, 1, 1e-4);
}

// A float at 6360 km knows half a metre; a level ray over 600 km rises by 28 km, a step of it by less than that.
TEST(Air, HeightsOfGrazingRaysKeepTheirDigitsInFloat) {
    for (const float height : {0.0f, 0.002f, 0.2f, 9.0f, 90.0f})
        for (const float mu : {-0.02f, -1e-4f, 0.0f, 1e-5f, 0.01f, 1.0f})
            for (const float distance : {0.001f, 0.5f, 20.0f, 600.0f}) {
                const double exact = f64::airHeight(double(height), double(mu), double(distance));
                if (exact < 0) continue;
                EXPECT_NEAR(f32::airHeight(height, mu, distance), exact, 1e-4 + 1e-5 * exact)
                    << height << " " << mu << " " << distance;
            }
    EXPECT_LT(f32::groundAt(0.2f, 0), 0);
    EXPECT_NEAR(f32::groundAt(0.2f, -1), 0.2, 1e-6);
    EXPECT_NEAR(f32::groundAt(0.002f, -0.001f), f64::groundAt(0.002, double(-0.001f)), 0.01);
    EXPECT_NEAR(f32::airExit(0, 0), std::sqrt(6460.0 * 6460 - 6360.0 * 6360), 0.1);
    EXPECT_NEAR(f32::lowestOf(50, -0.01f), f64::lowestOf(50, double(-0.01f)), 1e-3);
}

TEST(Air, SunlightIsThatOfClearDaysAndReddensAsItSinks) {
    const auto at = [](double degrees, double turbidity) {
        const double a = degrees * kPiD / 180;
        return f64::sunThroughAir({std::cos(a), std::sin(a), 0}, turbidity);
    };
    // Direct sun on clear days: 90 to 120 klx high up (IES Lighting Handbook), some ten at five degrees.
    EXPECT_GT(luminance(at(60, 2)), 90);
    EXPECT_LT(luminance(at(60, 2)), 120);
    EXPECT_GT(luminance(at(5, 1.5)), 10);
    EXPECT_LT(luminance(at(5, 1.5)), 60);
    double before = 1e9;
    for (double elevation = 90; elevation >= 0; elevation -= 1) {
        const f64::vec3 sun = at(elevation, 1.5);
        EXPECT_LT(sun.z / sun.x, before) << elevation;
        before = sun.z / sun.x;
    }
    EXPECT_EQ(at(-1, 1.5), f64::vec3(0));
    for (double elevation : {90.0, 1.0, 0.1, 0.0, -0.1, -90.0})
        for (double turbidity : {-5.0, 1.0, 12.0, 1e9}) {
            const glm::vec3 sun = f32::sunThroughAir(
                glm::vec3(std::cos(elevation * kPiD / 180), std::sin(elevation * kPiD / 180), 0), float(turbidity));
            for (int k = 0; k < 3; ++k) EXPECT_TRUE(sun[k] >= 0 && sun[k] < 140) << elevation << " " << turbidity;
        }
}

TEST(Air, PlacesInTablesGoThereAndBack) {
    for (int i = 0; i <= 100; ++i) {
        const double share = i / 100.0;
        EXPECT_NEAR(f64::skyUp(f64::skySine(share)), share, 1e-9);
        EXPECT_NEAR(f64::airAlong(f64::airDistance(share)), share, 1e-9);
    }
    EXPECT_EQ(f64::airAcross({1, 0}, {5, 0}), 0);
    EXPECT_EQ(f64::airAcross({1, 0}, {-3, 0}), 1);
    EXPECT_NEAR(f64::airAcross({1, 0}, {0, 2}), std::sqrt(0.5), 1e-12);
    EXPECT_EQ(f64::airAcross({0, 0}, {0, 0}), std::sqrt(0.5));  // the sun at the zenith: anywhere
    EXPECT_DOUBLE_EQ(f64::airTexel(0, 4), 0.125);
    EXPECT_DOUBLE_EQ(f64::airTexel(1, 4), 0.875);
}

}  // namespace
}  // namespace sward
