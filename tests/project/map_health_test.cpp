// What is found wrong with maps, where, and what of it `check` notices.
#include "project/map_health.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "project/project_files.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

constexpr const char* kHeight = "ground.Terrain.height";

float hills(int x, int y) {
    return 0.5f + 0.4f * std::sin(0.031f * static_cast<float>(x)) * std::cos(0.023f * static_cast<float>(y));
}
Map hilly(PixelType type, float steps = 0) {
    Map map({300, 260, 1, type});
    for (int y = 0; y < 260; ++y)
        for (int x = 0; x < 300; ++x) {
            const float h = hills(x, y);
            map.set(x, y, 0, steps > 0 ? std::round(h * steps) / steps : h);
        }
    return map;
}

TEST(MapHealth, SoundHillsHaveNoFault) {
    for (const PixelType type : {PixelType::U16, PixelType::F32}) {
        const TexelHealth h = healthOf(hilly(type));
        EXPECT_EQ(h.texels, 300u * 260u);
        EXPECT_EQ(h.notFinite.count + h.atLow.count + h.atHigh.count + h.banded.count, 0u);
        EXPECT_EQ(h.levels, 0);
        EXPECT_NEAR(h.low, 0.1, 0.01);
        EXPECT_NEAR(h.high, 0.9, 0.01);
    }
}

TEST(MapHealth, BrokenNumbersAreCountedWhereMostOfThemAre) {
    Map map = hilly(PixelType::F32);
    map.set(5, 5, 0, std::numeric_limits<float>::quiet_NaN());
    for (int x = 200; x < 220; ++x) map.set(x, 210, 0, std::numeric_limits<float>::infinity());
    const TexelHealth h = healthOf(map);
    EXPECT_EQ(h.notFinite.count, 21u);
    EXPECT_NEAR(h.notFinite.worst.x, 210.0 / 300, 1e-6);
    EXPECT_NEAR(h.notFinite.worst.y, 210.5 / 260, 1e-6);
    EXPECT_TRUE(std::isfinite(h.low) && std::isfinite(h.high));
}

TEST(MapHealth, CutOffTexelsAreCountedAtEachEnd) {
    Map map = hilly(PixelType::U16);
    for (int y = 130; y < 140; ++y)
        for (int x = 10; x < 20; ++x) map.set(x, y, 0, 1);
    map.set(290, 3, 0, 0);
    const TexelHealth h = healthOf(map);
    EXPECT_EQ(h.atHigh.count, 100u);
    EXPECT_EQ(h.atLow.count, 1u);
    EXPECT_NEAR(h.atHigh.worst.x, 15.0 / 300, 1e-6);
    EXPECT_NEAR(h.atHigh.worst.y, 135.0 / 260, 1e-6);
}

TEST(MapHealth, StepsOfEightBitsAreFoundInSixteenAndInFloats) {
    for (const PixelType type : {PixelType::U16, PixelType::F32})
        for (const float steps : {255.0f, 100.0f}) {
            const TexelHealth h = healthOf(hilly(type, steps));
            EXPECT_NEAR(h.levels, 0.8f * steps, 2) << steps;
            EXPECT_GT(h.banded.count, 1000u);
        }
    EXPECT_EQ(healthOf(hilly(PixelType::U16, 2000)).levels, 0) << "11 bits";
    EXPECT_EQ(healthOf(hilly(PixelType::U8)).levels, 0) << "8 bits have no finer texels";
    Map even({64, 64, 1, PixelType::U16});
    EXPECT_EQ(healthOf(even).levels, 0);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) even.set(x, y, 0, static_cast<float>(1000 + x % 40) / 65535.0f);
    EXPECT_EQ(healthOf(even).levels, 0) << "the map's own steps";
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) even.set(x, y, 0, static_cast<float>(x) / 64);
    EXPECT_EQ(healthOf(even).levels, 0) << "a ramp that climbs with each texel";
}

class Findings : public testing::Test {
  protected:
    void SetUp() override {
        Result<Project> made = newProject(dir / "p", tables().components);
        ASSERT_TRUE(made);
        p.emplace(std::move(*made));
    }
    void heights(const Map& map) {
        MapField& field = *static_cast<MapField*>(findMap(*p, tables().components, kHeight)->value);
        field.map = map, field.file = "maps/ground.height.png";
    }
    std::vector<MapFinding> of(MapFault fault) {
        std::vector<MapFinding> out;
        for (const MapFinding& f : mapFindings(*p, tables().components))
            if (f.fault == fault && f.map == kHeight) out.push_back(f);
        return out;
    }
    test::TempDir dir;
    std::optional<Project> p;
};

TEST_F(Findings, TellOfCutOffGroundWhereItIsOnTheTerrain) {
    Map map = hilly(PixelType::U16);
    for (int y = 130; y < 190; ++y)
        for (int x = 10; x < 20; ++x) map.set(x, y, 0, 1);
    heights(map);
    const auto found = of(MapFault::Clipped);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_FALSE(found[0].meant);
    EXPECT_NEAR(found[0].worst.x, 15.0 / 300 * 40, 0.01);
    EXPECT_NEAR(found[0].worst.y, 160.0 / 260 * 40, 0.01);
    EXPECT_NE(found[0].message.find("0.77 % of the ground"), std::string::npos) << found[0].message;
    Map touching = hilly(PixelType::U16);
    touching.set(7, 7, 0, 1);
    heights(touching);
    ASSERT_EQ(of(MapFault::Clipped).size(), 1u);
    EXPECT_TRUE(of(MapFault::Clipped)[0].meant) << "one texel at the end is what a stretched map has";
}

TEST_F(Findings, CheckNoticesBandsOfHeightsAndNotWhatMayBeMeant) {
    ASSERT_TRUE(saveProject(*p, tables().components));
    EXPECT_TRUE(checkProject(dir / "p", tables().components).noticed.empty());
    heights(hilly(PixelType::U16, 255));
    ASSERT_EQ(of(MapFault::Banded).size(), 1u);
    ASSERT_TRUE(saveProject(*p, tables().components));
    const CheckReport report = checkProject(dir / "p", tables().components);
    ASSERT_EQ(report.noticed.size(), 1u);
    EXPECT_NE(report.noticed[0].message.find("an image of 8 bits"), std::string::npos) << report.noticed[0].message;
    EXPECT_NE(report.noticed[0].message.find(" m"), std::string::npos);
}

TEST_F(Findings, ARangeThatIsMostlyUnusedIsTold) {
    Map low({256, 256, 1, PixelType::U16});
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) low.set(x, y, 0, 0.1f + 0.05f * hills(x, y));
    heights(low);
    const auto found = of(MapFault::UnusedRange);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].meant);
    EXPECT_NE(found[0].message.find("of heightRange"), std::string::npos);
    heights(hilly(PixelType::U16));
    EXPECT_TRUE(of(MapFault::UnusedRange).empty());
}

}  // namespace
}  // namespace sward
