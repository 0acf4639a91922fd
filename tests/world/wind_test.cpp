// Wind: how it moves, far away and after long; that no wind is none.
#include "world/wind.h"

#include <gtest/gtest.h>

#include "core/numerics.h"

namespace sward {
namespace {

constexpr double kMonth = 30.0 * 86400;

Wind windOfModel(WindModel model) {
    Wind w;
    w.model = model;
    return w;
}
// The lean at a place of the terrain as shaders find it, about an eye near by.
glm::vec2 leanAt(const Wind& w, const Map& gusts, const glm::dvec2& place, double seconds) {
    const glm::dvec2 eye = place - glm::dvec2(3, -2);
    return windLeanAt(windGlobals(w, eye, seconds), gusts, glm::vec2(place - eye), 0.3f);
}

class WindModels : public ::testing::TestWithParam<WindModel> {
  protected:
    Wind wind = windOfModel(GetParam());
    Map made;
    const Map& gusts = gustsOf(wind, made);
};

TEST_P(WindModels, StepsOfAMonthOldWindAreThoseOfANewOne) {
    wind.quiverHz = 3;
    // A place that has moved with the wind for a month is where it was: steps there must be equal too.
    const double carried = kMonth * static_cast<double>(wind.speed),
                 angle = glm::radians(static_cast<double>(wind.azimuthDeg));
    const glm::dvec2 way(std::sin(angle), -std::cos(angle));
    double worst = 0, largest = 0;
    wind.turbulence = 0;  // fine gusts overtake: they are elsewhere after a month
    for (int i = 0; i < 240; ++i) {
        const double t = i / 60.0;
        const auto step = [&](double from, const glm::dvec2& at) {
            return glm::dvec2(leanAt(wind, gusts, at, from + t + 1 / 60.0)) -
                   glm::dvec2(leanAt(wind, gusts, at, from + t));
        };
        const glm::dvec2 young = step(0, {5, 7}), old = step(kMonth, glm::dvec2(5, 7) + way * carried);
        worst = std::max(worst, glm::length(young - old));
        largest = std::max(largest, glm::length(young));
    }
    EXPECT_GT(largest, 1e-4);
    EXPECT_LT(worst, 0.01 * largest);
}

TEST_P(WindModels, IsTheSameAboutEveryEye) {
    wind.turbulence = 1;
    for (const double far : {0.0, 1000.0, 90000.0})
        for (int i = 0; i < 50; ++i) {
            const glm::dvec2 place(far + 0.37 * i, far - 1.3 * i);
            const auto about = [&](const glm::dvec2& eye) {
                return windLeanAt(windGlobals(wind, eye, 100), gusts, glm::vec2(place - eye), 0.7f);
            };
            EXPECT_LT(glm::length(about(place) - about(place + glm::dvec2(40, -25))), 2e-4f) << far;
        }
}

TEST_P(WindModels, NeighboursDifferByNoMoreThanItsSlope) {
    wind.turbulence = 1;
    const WindGlobals g = windGlobals(wind, {0, 0}, 12);
    const float slope = windSlope(g, gusts);
    float steepest = 0;
    for (uint32_t i = 0; i < 20000; ++i) {
        const auto number = [&](uint32_t k) { return f32::hashUnit(f32::hash3(i, k, 4)); };
        const glm::vec2 a(50 * number(0), 50 * number(1)), b = a + 0.2f * glm::vec2(number(2) - 0.5f, number(3) - 0.5f);
        steepest = std::max(
            steepest, glm::length(windLeanAt(g, gusts, a, 0.5f) - windLeanAt(g, gusts, b, 0.5f)) / glm::length(a - b));
    }
    EXPECT_LE(steepest, slope);
    EXPECT_GT(steepest, 0.02f * slope) << "a bound that says nothing";
}

TEST_P(WindModels, BlowsAlongItsAzimuthAndNeverHarderThanItsStrength) {
    wind.strength = 0.6f, wind.turbulence = 0, wind.azimuthDeg = 90;
    float most = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec2 lean = leanAt(wind, gusts, {0.7 * i, 0.3 * i}, 3);
        EXPECT_NEAR(lean.y, 0, 1e-6);
        most = std::max(most, std::abs(lean.x));
    }
    EXPECT_LE(most, 0.6f * 1.000001f);
    EXPECT_GT(most, 0.3f);
}
TEST_P(WindModels, LeansAndQuiversByTheShareThatStiffnessLeaves) {
    wind.strength = 0.3f, wind.turbulence = 1;
    Species s;
    ASSERT_EQ(s.stiffness, 1);
    EXPECT_EQ(windStrength(wind, s), wind.strength) << "to the last bit: pictures are those without the field";
    const auto leanOf = [&](float stiffness, const glm::vec2& at, float grain) {
        s.stiffness = stiffness;
        WindGlobals g = windGlobals(wind, {0, 0}, 17);
        g.strength = windStrength(wind, s);
        return windLeanAt(g, gusts, at, grain);
    };
    float most = 0, quivers = 0;
    for (int i = 0; i < 500; ++i) {
        const glm::vec2 at(0.31f * static_cast<float>(i), 0.17f * static_cast<float>(i));
        const float grain = static_cast<float>(i % 7) / 7;
        const glm::vec2 one = leanOf(1, at, grain), quiver = one - leanOf(1, at, -1);
        most = std::max(most, glm::length(one)), quivers = std::max(quivers, glm::length(quiver));
        EXPECT_LT(glm::length(leanOf(2, at, grain) - 0.5f * one), 1e-7f);
        EXPECT_LT(glm::length(leanOf(0.5f, at, grain) - 2.0f * one), 1e-6f);
        EXPECT_LT(glm::length(leanOf(4, at, grain) - leanOf(4, at, -1) - 0.25f * quiver), 1e-7f) << "the quiver too";
    }
    EXPECT_GT(most, 0.2f);
    EXPECT_GT(quivers, 0.02f);
}
INSTANTIATE_TEST_SUITE_P(Models, WindModels, ::testing::Values(WindModel::Waves, WindModel::Noise));

TEST(Wind, WavesComeBackAfterTheirPeriod) {
    Wind w = windOfModel(WindModel::Waves);
    w.c1 = 0.3f, w.c3 = 0.45f, w.speed = 5, w.turbulence = 0;
    const double period = wavePeriod(w);
    EXPECT_NEAR(period, 2 / (0.15 * 5), 1e-6);
    for (int i = 0; i < 40; ++i)
        EXPECT_LT(glm::length(leanAt(w, {}, {0.3 * i, 2}, 1) - leanAt(w, {}, {0.3 * i, 2}, 1 + 1000 * period)), 1e-5f);
    w.speed = 0;
    EXPECT_TRUE(std::isinf(wavePeriod(w)));
}

TEST(Wind, LeansTheSoftestNoFartherThanTheStrongestWindLeansOthers) {
    Wind w;
    Species s;
    for (const float strength : {0.0f, 0.3f, 1.9f, kStrongestWind})
        for (const float stiffness : {0.05f, 0.5f, 1.0f, 3.0f, 100.0f}) {
            w.strength = strength, s.stiffness = stiffness;
            EXPECT_LE(windStrength(w, s), kStrongestWind);
            EXPECT_EQ(windStrength(w, s), std::min(strength / stiffness, kStrongestWind))
                << strength << " " << stiffness;
            const f32::BladePose pose =
                f32::poseBlade({0, 0.5f, 0}, {0, 1, 0}, {1, 0}, {1, 1}, {windStrength(w, s), 0}, 1);
            EXPECT_GE(pose.tip.y, 0.049f);
            EXPECT_NEAR(glm::length(pose.tip), 1, 1e-5f);
        }
}

TEST(Wind, GustsHaveNoSeamAndFillTheirRange) {
    const Map m = makeGusts();
    const MapInfo& i = m.info();
    float inner = 0, seam = 0, low = 1, high = 0;
    for (int y = 0; y < i.height; ++y)
        for (int x = 0; x < i.width; ++x) {
            low = std::min(low, m.at(x, y)), high = std::max(high, m.at(x, y));
            if (x > 0)
                inner = std::max(inner, std::abs(m.at(x, y) - m.at(x - 1, y)));
            else
                seam = std::max(seam, std::abs(m.at(0, y) - m.at(i.width - 1, y)));
        }
    EXPECT_LE(seam, inner);
    EXPECT_LT(low, 0.1f);
    EXPECT_GT(high, 0.9f);
}

TEST(Wind, ACalmOrAQuietBladeIsTheRestPoseToTheLastBit) {
    EXPECT_EQ(f32::windLean({1, 0}, 0, 0.7f, 1, 0.5f), glm::vec2(0));
    for (uint32_t i = 0; i < 1000; ++i) {
        const auto number = [&](uint32_t k) { return 2 * f32::hashUnit(f32::hash3(i, k, 9)) - 1; };
        const glm::vec2 lean(number(0), number(1));
        EXPECT_EQ(f32::forcedLean(lean, {0, 0}, 0, {1, 0}), lean);
    }
}

}  // namespace
}  // namespace sward
