#include "script/map_ops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace sward {
namespace {

Map filled(int width, int height, int channels, PixelType type, float value) {
    Map map({width, height, channels, type});
    fillMap(map, {value, value, value, value});
    return map;
}

TEST(MapOps, FillRoundsToNearestInEveryTypeAndLeavesThePaddingZero) {
    for (const PixelType type : {PixelType::U8, PixelType::U16, PixelType::F32}) {
        const Map map = filled(200, 130, 1, type, 0.3f);
        EXPECT_NEAR(map.mean(), 0.3, type == PixelType::U8 ? 0.002 : 1e-5);
        for (const std::byte b :
             std::span(map.tile(1, 1)->look(), map.tileBytes()).subspan(size_t(100) * pixelBytes(type), 20))
            EXPECT_EQ(b, std::byte(0));
    }
}

TEST(MapOps, NoiseLiesInItsRangeAndIsCentredAndFollowsItsSeed) {
    NoiseSettings s;
    s.scale = 3;
    s.mode = NoiseMode::Set;
    s.amount = 2;
    Map a({512, 512, 1, PixelType::F32}), b = a, c = a;
    noiseMap(a, 100, 100, s, kAllChannels);
    noiseMap(b, 100, 100, s, kAllChannels);
    s.seed = 1;
    noiseMap(c, 100, 100, s, kAllChannels);
    EXPECT_EQ(a.hash(), b.hash());
    EXPECT_NE(a.hash(), c.hash());
    EXPECT_NEAR(a.mean(), 1, 0.08);
    float low = 9, high = -9, steepest = 0;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 511; ++x) {
            low = std::min(low, a.at(x, y));
            high = std::max(high, a.at(x, y));
            steepest = std::max(steepest, std::abs(a.at(x, y) - a.at(x + 1, y)));
        }
    EXPECT_GE(low, 0);
    EXPECT_LE(high, 2);
    EXPECT_LT(low, 0.5f);
    EXPECT_GT(high, 1.5f);
    EXPECT_LT(steepest, 0.5f);  // it is smooth, over tiles too
}

TEST(MapOps, NoiseAddsAndMultipliesOnChosenChannelsOnly) {
    Map map = filled(64, 64, 4, PixelType::F32, 0.5f);
    NoiseSettings s;
    s.amount = 0.25;
    noiseMap(map, 64, 64, s, {true, false, false, false});
    s.mode = NoiseMode::Multiply;
    noiseMap(map, 64, 64, s, {false, true, false, false});
    EXPECT_NEAR(map.mean(0), 0.5, 0.05);
    EXPECT_NE(map.at(3, 5, 0), map.at(40, 40, 0));
    EXPECT_LE(std::abs(map.at(3, 5, 1) - 0.5f), 0.125f);
    EXPECT_NE(map.at(3, 5, 1), 0.5f);
    EXPECT_EQ(map.mean(2), 0.5);
    EXPECT_EQ(map.mean(3), 0.5);
}

TEST(MapOps, BlurSpreadsAPointByItsRadiusAndKeepsTheSum) {
    for (const double radius : {2.0, 6.0, 25.0}) {
        Map map({301, 301, 1, PixelType::F32});
        map.set(150, 150, 0, 1);
        blurMap(map, radius, radius, kAllChannels);
        double sum = 0, variance = 0;
        for (int y = 0; y < 301; ++y)
            for (int x = 0; x < 301; ++x) {
                sum += map.at(x, y);
                variance += map.at(x, y) * (x - 150) * (x - 150);
            }
        EXPECT_NEAR(sum, 1, 1e-4);
        EXPECT_NEAR(std::sqrt(variance), radius / 2, 0.15 * radius + 0.3);
        EXPECT_FLOAT_EQ(map.at(150 - 5, 150), map.at(150 + 5, 150));
        EXPECT_NEAR(map.at(150, 150 + 5), map.at(150 + 5, 150), 1e-6);
    }
}

TEST(MapOps, BlurOfAFlatMapAndOfNoRadiusChangesNothing) {
    Map map = filled(100, 60, 2, PixelType::U16, 0.37f);
    const uint64_t hash = map.hash();
    blurMap(map, 9, 30, kAllChannels);
    EXPECT_EQ(map.hash(), hash);
    map.set(5, 5, 0, 1);
    const uint64_t dotted = map.hash();
    blurMap(map, 0, 0, kAllChannels);
    EXPECT_EQ(map.hash(), dotted);
    blurMap(map, 1e4, 1e4, kAllChannels);  // wider than the map
    EXPECT_NEAR(map.at(99, 59, 0), 0.37f, 0.01f);
}

TEST(MapOps, CurveGoesThroughItsPointsAndIsLevelBeyond) {
    Map map({5, 1, 1, PixelType::F32});
    const float in[] = {-1, 0.25f, 0.5f, 0.75f, 2};
    for (int x = 0; x < 5; ++x) map.set(x, 0, 0, in[x]);
    curveMap(map, {{0.25, 0.1}, {0.5, 0.9}, {1, 0.4}}, kAllChannels);
    EXPECT_FLOAT_EQ(map.at(0, 0), 0.1f);
    EXPECT_FLOAT_EQ(map.at(1, 0), 0.1f);
    EXPECT_FLOAT_EQ(map.at(2, 0), 0.9f);
    EXPECT_FLOAT_EQ(map.at(3, 0), 0.65f);
    EXPECT_FLOAT_EQ(map.at(4, 0), 0.4f);
}

// --- shapes: the sum over a float map is the area ----------------------------------------------------------

TEST(MapOps, SeamlessNoiseGoesOnOverTheMapsEdgesAsItDoesWithin) {
    NoiseSettings s;
    s.scale = 7;
    s.mode = NoiseMode::Set;
    const auto seam = [&](bool seamless) {
        s.seamless = seamless;
        Map m({200, 200, 1, PixelType::F32});
        noiseMap(m, 50, 50, s, kAllChannels);
        float over = 0, within = 0;
        for (int i = 0; i < 200; ++i) {
            over = std::max({over, std::abs(m.at(0, i) - m.at(199, i)), std::abs(m.at(i, 0) - m.at(i, 199))});
            within = std::max({within, std::abs(m.at(100, i) - m.at(101, i)), std::abs(m.at(i, 100) - m.at(i, 101))});
        }
        return std::pair{over, within};
    };
    EXPECT_LT(seam(true).first, 1.5f * seam(true).second);
    EXPECT_GT(seam(false).first, 3 * seam(false).second) << "the other kind has a seam";
}

TEST(MapOps, BlurOfAMapThatRepeatsTakesInItsOtherSide) {
    Map map = filled(64, 64, 1, PixelType::F32, 0), once = map;
    for (int y = 0; y < 64; ++y) map.set(0, y, 0, 1), once.set(0, y, 0, 1);
    blurMap(map, 6, 6, kAllChannels, true);
    blurMap(once, 6, 6, kAllChannels);
    EXPECT_NEAR(map.at(63, 30), map.at(1, 30), 1e-5f);
    EXPECT_EQ(once.at(63, 30), 0);
    EXPECT_NEAR(map.mean(), 1.0 / 64, 1e-5) << "nothing is lost over the edge";
}

}  // namespace
}  // namespace sward
