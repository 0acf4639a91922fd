// The tables of sky and air against paths of light that are traced without them, against measured daylight, and at
// their edges.
#include "sky/air_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/jobs.h"
#include "core/numerics.h"

namespace sward {
namespace {

constexpr double kPiD = 3.14159265358979323846;
using dvec3 = glm::dvec3;

double luminance(const dvec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }
glm::vec3 sunAt(double degrees) { return glm::vec3(std::cos(degrees * kPiD / 180), std::sin(degrees * kPiD / 180), 0); }
AirTables airFor(double sunDegrees, float turbidity, float haze = 0) {
    AirTables t;
    updateAir(t, turbidity, sunAt(sunDegrees).y, haze);
    return t;
}

// --- the same air by paths (delta tracking in one colour), in double, about the planet's centre
struct Traced {
    f64::Air air;
    dvec3 sun;
    int colour;
    std::mt19937 dice;
    double unit() { return std::uniform_real_distribution<double>(0, 1)(dice); }
    static double heightOf(const dvec3& at) { return glm::length(at) - f64::kPlanet; }
    double takes(double height) const { return f64::airTakes(air, f64::airDensity(height))[colour]; }
    // Share of light from a place along a way that leaves the air; 0 behind the planet.
    double leaves(const dvec3& at, const dvec3& way) const {
        const double h = heightOf(at), mu = glm::dot(at, way) / glm::length(at);
        if (f64::groundAt(h, mu) >= 0) return 0;
        const double end = f64::airExit(h, mu);
        double sum = 0;
        const int steps = 200;
        for (int i = 0; i < steps; ++i) {
            const double s = (i + 0.5) / steps, t = end * s * s;
            sum += takes(heightOf(at + way * t)) * 2 * s * end / steps;
        }
        return std::exp(-sum);
    }
    dvec3 around(const dvec3& axis, double c) {
        const double turn = 2 * kPiD * unit(), s = std::sqrt(std::max(1 - c * c, 0.0));
        const dvec3 side = glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
        return glm::normalize(axis * c + (side * std::cos(turn) + glm::cross(axis, side) * std::sin(turn)) * s);
    }
    // For 1 klx above the air.
    double light(dvec3 at, dvec3 way) {
        double sum = 0, weight = 1;
        const double most = takes(0) * 1.001;
        for (int bounce = 0; bounce < 60; ++bounce) {
            const double h = heightOf(at), mu = glm::dot(at, way) / glm::length(at), ground = f64::groundAt(h, mu),
                         end = ground >= 0 ? ground : f64::airExit(h, mu);
            double t = 0, height = 0;
            bool met = false;
            while (!met) {
                t -= std::log(1 - unit()) / most;
                if (t >= end) break;
                height = heightOf(at + way * t);
                met = unit() * most < takes(height);
            }
            if (!met && ground < 0) return sum;
            at += way * (met ? t : end);
            if (!met) {
                const dvec3 up = glm::normalize(at);
                at = up * (f64::kPlanet + 1e-6);
                sum += weight * 0.3 / kPiD * std::max(glm::dot(up, sun), 0.0) * leaves(at, sun);
                weight *= 0.3;
                way = around(up, std::sqrt(unit()));
                continue;
            }
            const dvec3 density = f64::airDensity(height);
            const double rayleigh = air.rayleigh[colour] * density.x, haze = air.haze * f64::kHazeScatters * density.y,
                         c = glm::dot(way, sun);
            sum += weight * (rayleigh * f64::rayleighPhase(c) + haze * f64::hazePhase(c)) / takes(height) *
                   leaves(at, sun);
            weight *= (rayleigh + haze) / takes(height);
            const double turned = scattered(unit() * (rayleigh + haze) < haze);
            way = around(way, turned);
        }
        return sum;
    }
    // The cosine of an angle by the phase function, by rejection from Henyey and Greenstein's.
    double scattered(bool byHaze) {
        while (true) {
            const double g = byHaze ? f64::kHazeForward : 0, u = unit(), s = (1 - g * g) / (1 - g + 2 * g * u),
                         c = byHaze ? (1 + g * g - s * s) / (2 * g) : 2 * u - 1;
            if (unit() * 2 < 1 + c * c) return c;
        }
    }
};
double tracedLight(double sunDegrees, double turbidity, const dvec3& towards, int colour, int paths) {
    const size_t parts = 16;
    std::vector<double> sums(parts);
    parallelFor(parts, [&](size_t i) {
        Traced t{f64::airOf(turbidity), dvec3(sunAt(sunDegrees)), colour, std::mt19937(unsigned(i) + 7)};
        for (int n = 0; n < paths / int(parts); ++n)
            sums[i] += t.light({0, f64::kPlanet + double(kAirEye), 0}, glm::normalize(towards));
    });
    double sum = 0;
    for (const double s : sums) sum += s;
    return sum / (paths / int(parts) * int(parts)) * f64::sunAboveAir()[colour];
}

// Equations 5 to 10 take light that was scattered twice and more as if it came from everywhere: close where air
// scatters, less so where haze sends light on. At worst 17 % were seen.
TEST(AirTables, TheSkyIsThatOfTracedPaths) {
    const dvec3 ways[] = {{0, 1, 0}, {0, 0.5, 1}, {-1, 0.2, 0.3}, {1, 0.3, 1}};
    for (const double sun : {40.0, 8.0})
        for (const float turbidity : {1.05f, 1.5f}) {
            const AirTables t = airFor(sun, turbidity);
            double off = 0;
            for (const dvec3& way : ways)
                for (const int colour : {0, 1, 2}) {
                    const double tabled = double(skyOf(t, sunAt(sun), glm::vec3(glm::normalize(way)))[colour]),
                                 traced = tracedLight(sun, double(turbidity), way, colour, 24000);
                    off += std::abs(tabled / traced - 1) / 12;
                    EXPECT_NEAR(tabled / traced, 1, 0.2) << "sun " << sun << ", turbidity " << turbidity << ", way "
                                                         << way.x << " " << way.y << " " << way.z << ", " << colour;
                }
            EXPECT_LT(off, 0.1) << "sun " << sun << ", turbidity " << turbidity;
            std::printf("sun %g, turbidity %g: %.3f off in the mean\n", sun, double(turbidity), off);
        }
}

// Irradiance of level ground by the sky alone, klx.
double skyKlx(const AirTables& t, double sunDegrees) {
    dvec3 sum(0);
    const int rows = 40, columns = 80;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double y = (i + 0.5) / rows, r = std::sqrt(1 - y * y), a = 2 * kPiD * (j + 0.5) / columns;
            sum += dvec3(skyOf(t, sunAt(sunDegrees), glm::vec3(r * std::cos(a), y, r * std::sin(a)))) * y;
        }
    return luminance(sum) * 2 * kPiD / (rows * columns);
}

// Clear skies light level ground with 8 to 20 klx by day; dusk by the U.S. Naval Observatory's table (Seidelmann,
// Explanatory Supplement, 1992): 0.7 klx of a sun on the horizon, 3.4 lx at the end of civil twilight.
TEST(AirTables, DaylightAndDuskAreAsBrightAsMeasured) {
    for (const double sun : {30.0, 60.0}) {
        const double klx = skyKlx(airFor(sun, 1.6f), sun);
        EXPECT_GT(klx, 6) << sun;
        EXPECT_LT(klx, 22) << sun;
    }
    const double set = skyKlx(airFor(0, 1.4f), 0), dusk = skyKlx(airFor(-6, 1.4f), -6);
    EXPECT_GT(set, 0.7 / 2);
    EXPECT_LT(set, 0.7 * 2);
    EXPECT_GT(dusk, 3.4e-3 / 4);
    EXPECT_LT(dusk, 3.4e-3 * 4);
    double before = 1e9;
    for (double sun = 4; sun >= -12; sun -= 1) {
        const double klx = skyKlx(airFor(sun, 1.4f), sun);
        EXPECT_LT(klx, before) << sun;
        before = klx;
    }
}

TEST(AirTables, AreFiniteAndNotNegativeForEverySunAirAndHaze) {
    for (const double sun : {90.0, 45.0, 0.5, 0.0, -0.3, -4.0, -18.0, -90.0})
        for (const float turbidity : {1.0f, 3.0f, 12.0f}) {
            AirTables t;  // haze makes some of them anew
            for (const float haze : {0.0f, 1e-3f, 40.0f}) {
                updateAir(t, turbidity, sunAt(sun).y, haze);
                for (const AirTable* table : {&t.columns, &t.scattered, &t.sky, &t.between})
                    for (const glm::vec3& v : table->values)
                        for (int k = 0; k < 3; ++k)
                            ASSERT_TRUE(v[k] >= 0 && v[k] < 1e5f) << sun << " " << turbidity << " " << haze;
            }
        }
}

// Columns of rays that sink are put together from two that rise.
TEST(AirTables, LightFromAboveComesThroughAsAlongTheRayItself) {
    const AirTables t = airFor(30, 1.5f);
    for (const double elevation : {90.0, 20.0, 3.0, 0.5}) {
        const double mu = std::sin(elevation * kPiD / 180);
        const dvec3 direct = f64::airColumns(0.2, mu, 4000);
        const float least = f32::kAirTop - 0.2f, most = f32::airExit(0.2f, 0);
        const glm::vec3 tabled =
            t.columns.at((f32::airExit(0.2f, float(mu)) - least) / (most - least), std::sqrt(0.2f / f32::kAirTop));
        EXPECT_NEAR(double(tabled.x) / direct.x, 1, 0.02) << elevation;
        EXPECT_NEAR(double(tabled.y) / direct.y, 1, 0.04) << elevation;
    }
}

// What the air fades into is what stands above it: else a line lies along the horizon.
TEST(AirTables, FarAirIsTheHorizonAndHazeIsTheHorizonsColour) {
    for (const double sun : {60.0, 20.0, 2.0}) {
        const AirTables dull = airFor(sun, 3);
        for (const float turbidity : {1.2f, 3.0f}) {
            const AirTables clear = airFor(sun, turbidity), hazy = airFor(sun, turbidity, 0.01f);
            for (int i = 0; i <= 12; ++i) {
                const double a = i * kPiD / 12;
                const glm::vec2 way(std::cos(a), std::sin(a));
                const glm::vec3 horizon = skyOf(clear, sunAt(sun), {way.x, 0, way.y}),
                                thick = airOver(hazy, sunAt(sun), way, 30000),
                                far = airOver(dull, sunAt(sun), way, f32::kAirFar),
                                above = skyOf(dull, sunAt(sun), {way.x, 0, way.y});
                for (int k = 0; k < 3; ++k) {
                    EXPECT_NEAR(thick[k] / horizon[k], 1, 0.05) << sun << " " << turbidity << " " << i;
                    EXPECT_NEAR(far[k] / above[k], 1, 0.05) << sun << " " << i;
                }
            }
        }
    }
}

TEST(AirTables, AreMadeAnewOnlyWhereTheyChange) {
    AirTables t;
    updateAir(t, 2, 0.5f, 0);
    const float* sky = &t.sky.values[0].x;
    const unsigned changes = t.changes;
    updateAir(t, 2, 0.5f, 0);
    EXPECT_EQ(t.changes, changes);
    updateAir(t, 2, 0.5f, 1e-3f);
    EXPECT_NE(t.changes, changes);
    EXPECT_EQ(&t.sky.values[0].x, sky) << "the haze does not change the sky";
}

TEST(AirTables, OfWhatWasMadeLatelyAreThoseMadeFromNothing) {
    AirTables first, t, other;
    updateAir(first, 2.7f, 0.3f, 1e-4f);
    updateAir(t, 2.7f, 0.5f, 0);  // its scattered light is the first's
    const unsigned changes = t.changes;
    updateAir(t, 2.7f, 0.3f, 1e-4f);
    EXPECT_NE(t.changes, changes) << "what is drawn follows";
    EXPECT_EQ(t.sky.values, first.sky.values);
    EXPECT_EQ(t.between.values, first.between.values);
    updateAir(t, 2.7f, 0.5f, 0);
    for (const float turbidity : {3.0f, 4.0f, 5.0f, 6.0f}) updateAir(other, turbidity, 0.3f, 1e-4f);
    updateAir(t, 2.7f, 0.3f, 1e-4f);  // forgotten meanwhile
    EXPECT_EQ(t.scattered.values, first.scattered.values);
    EXPECT_EQ(t.sky.values, first.sky.values);
    EXPECT_EQ(t.between.values, first.between.values);
}

}  // namespace
}  // namespace sward
