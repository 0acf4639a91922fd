// Brushes on maps of colours: add, set, noise, subtract, smooth.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "brushes/brush.h"
#include "tests/editor/brushes/stamped.h"
#include "tools/stroke.h"

namespace sward {
namespace {

using namespace test;

constexpr glm::vec3 kYellow{0.9f, 0.8f, 0.1f}, kPurple{0.5f, 0.1f, 0.6f};
float colourStep(PixelType type) {
    return type == PixelType::U8 ? 1.f / 255 : type == PixelType::U16 ? 1.f / 65535 : 1e-6f;
}

Map colourMap(int side, PixelType type, const glm::vec4& texel = glm::vec4(0)) {
    Map m({side, side, 4, type});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int c = 0; c < 4; ++c) m.set(x, y, c, texel[c]);
    return m;
}
glm::vec4 texelAt(const Map& m, int x, int y) { return {m.at(x, y, 0), m.at(x, y, 1), m.at(x, y, 2), m.at(x, y, 3)}; }
BrushSettings colourBrush(const glm::vec3& color, float strength, float value = 1, float falloff = 0.5f) {
    BrushSettings b;
    b.color = color, b.strength = strength, b.value = value, b.falloff = falloff, b.colours = true;
    return b;
}
void expectNear(const glm::vec4& a, const glm::vec4& b, float tolerance, const std::string& where = "") {
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c << ' ' << where;
}

TEST(Colours, AddLaysTheColourWithItsFalloffAsOpacity) {
    for (const PixelType type : kTypes) {
        Map m = colourMap(200, type);
        paint(m, "add", {100, 100, 60, 60}, colourBrush(kYellow, 0.5f));
        expectNear(texelAt(m, 100, 100), glm::vec4(kYellow, 0.5f), colourStep(type));
        float before = 1;
        for (int x = 100; x < 162; ++x) {
            const glm::vec4 t = texelAt(m, x, 100);
            EXPECT_LE(t.w, before);
            before = t.w;
            if (t.w > 0) expectNear(t, glm::vec4(kYellow, t.w), colourStep(type), "at the edge: never a darker colour");
        }
        EXPECT_EQ(before, 0);
    }
}

// Porter and Duff's over: of colours times opacities.
TEST(Colours, AddOverAColourIsThatColourUnderTheOther) {
    for (const PixelType type : kTypes)
        for (const float under : {0.25f, 1.0f}) {
            Map m = colourMap(64, type, glm::vec4(kPurple, under));
            paint(m, "add", {32, 32, 30, 30}, colourBrush(kYellow, 0.4f));
            const float opacity = under + 0.4f * (1 - under);
            const glm::vec3 color = (kPurple * under * 0.6f + kYellow * 0.4f) / opacity;
            expectNear(texelAt(m, 32, 32), glm::vec4(color, opacity), 3 * colourStep(type));
        }
}

TEST(Colours, OpacityGoesUpToTheBrushsValueAndNeverDown) {
    for (const PixelType type : kTypes) {
        Map m = colourMap(64, type);
        for (uint32_t i = 0; i < 60; ++i) paint(m, "add", {32, 32, 30, 30, i}, colourBrush(kYellow, 0.3f, 0.6f));
        expectNear(texelAt(m, 32, 32), glm::vec4(kYellow, 0.6f), colourStep(type));
        for (uint32_t i = 0; i < 60; ++i) paint(m, "add", {32, 32, 30, 30, i}, colourBrush(kPurple, 0.3f, 0.2f));
        expectNear(texelAt(m, 32, 32), glm::vec4(kPurple, 0.6f), colourStep(type));
        paint(m, "set", {32, 32, 30, 30}, colourBrush(kYellow, 1, 0.2f));
        expectNear(texelAt(m, 32, 32), glm::vec4(kYellow, 0.2f), colourStep(type));
    }
}

TEST(Colours, SubtractLowersOpacityAndKeepsTheColour) {
    for (const PixelType type : kTypes) {
        const glm::vec4 was = texelAt(colourMap(1, type, glm::vec4(kPurple, 0.8f)), 0, 0);
        Map m = colourMap(64, type, was);
        paint(m, "subtract", {32, 32, 30, 30}, colourBrush(kYellow, 0.5f));
        EXPECT_NEAR(m.at(32, 32, 3), 0.4f, colourStep(type));
        for (uint32_t i = 0; i < 20; ++i) paint(m, "subtract", {32, 32, 30, 30, i}, colourBrush(kYellow, 0.7f, 1, 1));
        paint(m, "subtract", {32, 32, 30, 30}, colourBrush(kYellow, 1));
        EXPECT_EQ(m.at(32, 32, 3), 0);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                for (int c = 0; c < 3; ++c) ASSERT_NEAR(m.at(x, y, c), was[c], 1e-6f) << x << ' ' << y;
    }
}

// The mean of yellow and of nothing is yellow of half the opacity, whatever colour the nothing holds.
TEST(Colours, SmoothBlursWhatShowsAndNotWhatIsHidden) {
    for (const PixelType type : kTypes)
        for (const glm::vec3 hidden : {glm::vec3(0), glm::vec3(0, 0, 1)}) {
            Map m = colourMap(160, type, glm::vec4(hidden, 0));
            for (int y = 0; y < 160; ++y)
                for (int x = 0; x < 80; ++x)
                    for (int c = 0; c < 4; ++c) m.set(x, y, c, glm::vec4(kYellow, 1)[c]);
            paint(m, "smooth", {80, 80, 60, 60}, colourBrush(kPurple, 1, 1, 0));
            for (int x = 70; x < 90; ++x) {
                const glm::vec4 t = texelAt(m, x, 80);
                if (t.w > 0) expectNear(t, glm::vec4(kYellow, t.w), 2 * colourStep(type), "at " + std::to_string(x));
            }
            EXPECT_NEAR(m.at(79, 80, 3) + m.at(80, 80, 3), 1, 2 * colourStep(type));
            EXPECT_LT(m.at(79, 80, 3), 0.6f);
        }
}

TEST(Colours, SmoothingTwoColoursWeighsThemByOpacity) {
    for (const PixelType type : kTypes) {
        Map m = colourMap(160, type, glm::vec4(0, 0, 1, 0.25f));
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 160; x += 2) m.set(x, y, 0, 1), m.set(x, y, 2, 0), m.set(x, y, 3, 0.75f);
        for (uint32_t i = 0; i < 40; ++i) paint(m, "smooth", {80, 80, 60, 60, i}, colourBrush(kYellow, 1, 1, 0));
        expectNear(texelAt(m, 80, 80), {0.75f, 0, 0.25f, 0.5f}, 0.06f);
        Map flat = colourMap(160, type, {0.3f, 0.62f, 0.11f, 0.47f});
        const uint64_t hash = flat.hash();
        for (uint32_t i = 0; i < 50; ++i) paint(flat, "smooth", {80, 80, 90, 90, i}, colourBrush(kYellow, 0.7f));
        EXPECT_EQ(flat.hash(), hash);
    }
}

// Filters mix texels' colours before opacity is asked: a rim of black would show.
TEST(Colours, WhatIsTransparentAroundAStampTakesItsColour) {
    for (const PixelType type : kTypes) {
        Map m = colourMap(160, type);
        paint(m, "add", {126, 80, 20, 20, 0, 0, 0, kColourSpread}, colourBrush(kYellow, 1, 1, 0));
        for (const auto& [x, y] : {std::pair{148, 80}, {104, 80}, {126, 104}, {130, 56}})
            expectNear(texelAt(m, x, y), glm::vec4(kYellow, 0), colourStep(type), std::to_string(x));
        EXPECT_EQ(texelAt(m, 156, 80), glm::vec4(0)) << "no farther than the spread";
        Map painted = colourMap(160, type, glm::vec4(kPurple, 0.5f));
        const glm::vec4 beside = texelAt(painted, 150, 80);
        paint(painted, "add", {126, 80, 20, 20, 0, 0, 0, kColourSpread}, colourBrush(kYellow, 1, 1, 0));
        EXPECT_EQ(texelAt(painted, 148, 80), beside) << "what is seen stays as it is";
    }
}

// Weak strokes must neither stall nor run away, nor come out in bands: many weak stamps are as one of their sum.
TEST(Colours, WeakStampsAddUpToWhatTheyWouldWithoutRounding) {
    for (const PixelType type : kTypes)
        for (const auto& [strength, stamps] : {std::pair{0.01f, 100}, {0.001f, 800}}) {
            const float kept = std::pow(1 - strength, static_cast<float>(stamps));
            Map clear = colourMap(32, type), over = colourMap(32, type, glm::vec4(kPurple, 1));
            for (int i = 0; i < stamps; ++i) {
                paint(clear, "add", {16, 16, 14, 14, uint32_t(i)}, colourBrush(kYellow, strength));
                paint(over, "add", {16, 16, 14, 14, uint32_t(i)}, colourBrush(kYellow, strength));
            }
            const float tolerance = 2.5f * colourStep(type) + 1e-4f;
            expectNear(texelAt(clear, 16, 16), glm::vec4(kYellow, 1 - kept), tolerance);
            expectNear(texelAt(over, 16, 16), glm::vec4(glm::mix(kYellow, kPurple, kept), 1), tolerance);
        }
}

TEST(Colours, ASoftStrokeHasAsManyShadesAsItsTypeHolds) {
    Map m = colourMap(1024, PixelType::U8);
    BrushSettings b = colourBrush(kYellow, 0.02f, 1, 1);
    b.radius = 300, b.spacing = 0.02f;
    Stroke stroke(*findBrush("add"), b, {1024, 1024, false}, m.info(), 0);
    stroke.moveTo(200, 512), stroke.moveTo(824, 512);
    stroke.end();
    stroke.pump(m, 0);
    std::set<float> shades;
    float before = m.at(512, 512, 3);
    for (int y = 512; y < 812; ++y) {
        const float now = m.at(512, y, 3);
        EXPECT_LT(std::abs(now - before), 4.f / 255) << "a band at " << y;
        before = now;
        shades.insert(now);
    }
    EXPECT_GT(shades.size(), static_cast<size_t>(0.8f * 255 * m.at(512, 512, 3)));
}

TEST(Colours, NoiseLaysTheColourWithRandomOpacityTheSameForASeed) {
    for (const PixelType type : kTypes) {
        Map a = colourMap(128, type), b = a, c = a;
        BrushSettings brush = colourBrush(kYellow, 1, 0.8f, 0);
        paint(a, "noise", {64, 64, 200, 200}, brush);
        paint(b, "noise", {64, 64, 200, 200}, brush);
        EXPECT_EQ(a.hash(), b.hash());
        brush.seed = 1;
        paint(c, "noise", {64, 64, 200, 200}, brush);
        EXPECT_NE(a.hash(), c.hash());
        EXPECT_NEAR(a.mean(3), 0.4, 0.02);
        EXPECT_NEAR(a.mean(0), 0.9, 0.01);
    }
}

TEST(Colours, NoRadiusNoStrengthAndBrokenNumbersPaintNothing) {
    const float nan = std::nanf("");
    for (const PixelType type : kTypes) {
        const Map before = colourMap(160, type, {0.9f, 0.3f, 0.5f, 0.6f});
        Map m = before;
        for (const char* mode : {"add", "set", "noise", "smooth", "subtract"}) {
            paint(m, mode, {80, 80, 0, 0, 0, 0, 0, kColourSpread}, colourBrush(kYellow, 1));
            paint(m, mode, {80, 80, 40, 40, 3}, colourBrush(kYellow, 0));
            paint(m, mode, {80, 80, 40, 40}, colourBrush(kYellow, nan));
            paint(m, mode, {80, 80, 40, 40}, colourBrush({0.5f, nan, 0.5f}, 1));
        }
        EXPECT_TRUE(m.sameTiles(before));
        Map clear = colourMap(160, type);
        const uint64_t hash = clear.hash();
        paint(clear, "add", {80, 80, 40, 40, 0, 0, 0, kColourSpread}, colourBrush(kYellow, 1, 0));  // of no opacity
        EXPECT_EQ(clear.hash(), hash);
    }
}

TEST(Colours, WhateverIsPaintedStaysBetweenZeroAndOne) {
    std::mt19937 random(4);
    const auto any = [&](double from, double to) {
        return static_cast<float>(std::uniform_real_distribution<>(from, to)(random));
    };
    for (const PixelType type : kTypes) {
        Map m = colourMap(180, type);
        for (uint32_t i = 0; i < 200; ++i) {
            const char* modes[] = {"add", "set", "noise", "smooth", "subtract"};
            paint(m, modes[random() % 5], {any(0, 180), any(0, 180), any(0, 60), any(0, 60), i, 0, 0, kColourSpread},
                  colourBrush({any(0, 1), any(0, 1), any(0, 1)}, any(0, 1), any(-1, 2), any(0, 1)));
        }
        for (int y = 0; y < 180; ++y)
            for (int x = 0; x < 180; ++x)
                for (int c = 0; c < 4; ++c) ASSERT_TRUE(m.at(x, y, c) >= 0 && m.at(x, y, c) <= 1) << m.at(x, y, c);
    }
}

// A stroke over the edge of a map that repeats is the same stroke inside it, shifted: colour, opacity and spread alike.
TEST(Colours, AStrokeGoesOnOverTheSeamOfAMapThatRepeats) {
    const auto painted = [](double x, double z) {
        Map m = colourMap(256, PixelType::U16);
        BrushSettings b = colourBrush(kYellow, 0.7f);
        b.radius = 3;
        Stroke stroke(*findBrush("add"), b, {40, 40, true}, m.info(), 0);
        stroke.moveTo(x, z), stroke.moveTo(x + 5, z);
        stroke.end();
        stroke.pump(m, 0);
        return m;
    };
    const Map inside = painted(15, 20), over = painted(37.5, 40);  // shifted by 144 and 128 texels
    int seen = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const glm::vec4 a = texelAt(inside, x, y), b = texelAt(over, (x + 144) % 256, (y + 128) % 256);
            seen += a.w > 0;
            for (int c = 0; c < 4; ++c) ASSERT_NEAR(a[c], b[c], 2.f / 65535) << x << ' ' << y;
        }
    EXPECT_GT(seen, 1000);
}

}  // namespace
}  // namespace sward
