// Strokes: where a hand is heading, what brushes are refused, and how maps lie on the terrain.
#include "tools/stroke.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "brushes/shape.h"
#include "core/log.h"
#include "model/document.h"
#include "support.h"
#include "techniques.h"
#include "world/ground.h"

namespace sward {
namespace {

TEST(Stroke, AHeadingFollowsTheHandAndForgetsWhatLiesBehind) {
    EXPECT_EQ(headingAfter({0.2, 0.3}, 0, 0, 0, 1), glm::dvec2(0.2, 0.3)) << "no motion";
    glm::dvec2 heading{0};
    for (int i = 0; i < 50; ++i) heading = headingAfter(heading, 0.1, 0, 0.1, 0.5);
    EXPECT_NEAR(heading.x, 1, 1e-3);
    EXPECT_EQ(heading.y, 0);
    const glm::dvec2 turned = headingAfter(heading, 0, 0.1, 0.1, 0.5);
    EXPECT_GT(turned.x, 0.5) << "one small step does not turn it";
    for (int i = 0; i < 50; ++i) heading = headingAfter(heading, 0, 0.1, 0.1, 0.5);
    EXPECT_NEAR(heading.y, 1, 1e-3);
}

TEST(Stroke, BrushesOutOfTheirRangesAreRefused) {
    BrushSettings good;
    good.mode = "add", good.radius = 2;
    EXPECT_TRUE(checkBrush(good));
    const float nan = std::nanf("");
    for (const auto& change : std::initializer_list<std::function<void(BrushSettings&)>>{
             [](BrushSettings& b) { b.mode = "spray"; }, [&](BrushSettings& b) { b.radius = nan; },
             [](BrushSettings& b) { b.radius = -1; }, [](BrushSettings& b) { b.strength = 2; },
             [&](BrushSettings& b) { b.falloff = nan; }, [](BrushSettings& b) { b.value = 1e9f; }}) {
        BrushSettings bad = good;
        change(bad);
        const Status s = checkBrush(bad);
        ASSERT_FALSE(s);
        EXPECT_EQ(s.error().code, ExitCode::Usage);
    }
}

TEST(Stroke, AMapLiesOnItsTerrainOnceOrAsOftenAsItsTilingSays) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    const auto scale = [&] {
        const auto f = findField(doc.project(), tables().components, "lawn.GrassField.species[lawn].density");
        return mapScale(doc.project(), *f);
    };
    ASSERT_TRUE(scale());
    EXPECT_EQ(scale()->width, 40);
    EXPECT_FALSE(scale()->repeats);
    ASSERT_TRUE(doc.setField("lawn.GrassField.species[lawn].densityTiling", "4"));
    EXPECT_EQ(scale()->width, 10);
    EXPECT_TRUE(scale()->repeats);
    ASSERT_TRUE(doc.removeEntity("ground"));
    ASSERT_FALSE(scale());
    EXPECT_NE(scale().error().text().find("add an entity with a Terrain"), std::string::npos);
}

// --- sculpting: strokes on heights

// What is logged while it lives.
class LogCollector {
  public:
    LogCollector() : sink_(addLogSink([this](LogLevel, const std::string& line) { text_ += line; })) {}
    ~LogCollector() { removeLogSink(sink_); }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
    int sink_;
};

class Sculpting : public testing::Test {
  protected:
    static constexpr const char* kHeight = "ground.Terrain.height";

    void SetUp() override { ASSERT_TRUE(doc.create(dir / "p")); }
    const Terrain& terrain() { return *findGround(doc.project()).terrain; }
    double height(double x, double z) { return terrainHeight(terrain(), x, z); }
    BrushSettings brush(const std::string& mode, float metres = 1, float radius = 4) {
        BrushSettings b;
        b.map = kHeight, b.mode = mode, b.radius = radius, b.value = metres, b.falloff = 0.2f;
        return b;
    }
    Status stroke(const BrushSettings& b, const std::vector<std::pair<double, double>>& points) {
        if (Status begun = doc.beginStrokes({&b, 1}, points[0].first, points[0].second, true); !begun) return begun;
        for (const auto& [x, z] : points) doc.strokeTo(x, z);
        doc.endStroke();
        doc.pumpStroke(0);
        return {};
    }
    // 10 m at full scale, 5 m everywhere.
    void integers() {
        Map map({256, 256, 1, PixelType::U16});
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) map.set(x, y, 0, 0.5f);
        ASSERT_TRUE(doc.setMap(kHeight, map, "heights"));
    }

    test::TempDir dir;
    Document doc{tables()};
};

TEST_F(Sculpting, TheFirstStrokeMakesLevelFloatsAndUndoTakesThemBack) {
    ASSERT_FALSE(terrain().height.present());
    EXPECT_EQ(doc.beginStroke(brush("raise"), 20, 20).error().code, ExitCode::Usage) << "not without being told";
    ASSERT_TRUE(stroke(brush("raise", 2), {{20, 20}}));
    EXPECT_EQ(terrain().height.map.info().type, PixelType::F32);
    EXPECT_GE(terrain().height.map.info().width, 256);
    EXPECT_NEAR(height(20, 20), 2, 1e-5);
    EXPECT_EQ(height(30, 20), 0);
    ASSERT_TRUE(doc.undo());
    EXPECT_FALSE(terrain().height.present());
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(Sculpting, EveryBrushIsOneStepAndUndoGivesTheFirstHash) {
    for (const bool whole : {false, true}) {
        if (whole) integers();
        ASSERT_TRUE(stroke(brush("raise", 0.3f, 6), {{20, 20}, {23, 26}}));
        for (const BrushRow& row : brushRows()) {
            if (!paints(row, MapKind::Heights)) continue;
            const uint64_t before = terrain().height.map.hash();
            ASSERT_TRUE(stroke(brush(row.name, 0.5f), {{18, 18}, {22, 21}, {26, 22}})) << row.name;
            const uint64_t after = terrain().height.map.hash();
            EXPECT_NE(after, before) << row.name;
            ASSERT_TRUE(doc.undo());
            EXPECT_EQ(terrain().height.map.hash(), before) << row.name;
            ASSERT_TRUE(doc.redo());
            EXPECT_EQ(terrain().height.map.hash(), after) << row.name;
        }
    }
}

TEST_F(Sculpting, OnHeightsAddSubtractAndSetMeanRaiseLowerAndFlatten) {
    ASSERT_TRUE(stroke(brush("add", 3), {{10, 10}}));
    EXPECT_NEAR(height(10, 10), 3, 1e-5);
    ASSERT_TRUE(stroke(brush("subtract", 5), {{10, 10}}));
    EXPECT_NEAR(height(10, 10), -2, 1e-5);
    ASSERT_TRUE(stroke(brush("set", 7), {{10, 10}}));
    EXPECT_NEAR(height(10, 10), 7, 1e-5);
    const Status comb = stroke(brush("comb"), {{10, 10}});
    ASSERT_FALSE(comb);
    EXPECT_NE(comb.error().text().find("raise, lower, flatten, ramp, erode or imprint"), std::string::npos);
    BrushSettings density = brush("raise");
    density.map = "density";
    EXPECT_FALSE(stroke(density, {{10, 10}}));
}

TEST_F(Sculpting, FlattenGoesToTheHeightWhereTheStrokeBeginsOrToAValue) {
    ASSERT_TRUE(stroke(brush("raise", 4, 8), {{10, 20}}));
    ASSERT_TRUE(stroke(brush("flatten", 99), {{10, 20}, {30, 20}}));
    for (double x = 10; x <= 30; x += 2) EXPECT_NEAR(height(x, 20), 4, 1e-3) << x;
    BrushSettings typed = brush("flatten", 1.5f);
    typed.fromStart = false;
    ASSERT_TRUE(stroke(typed, {{10, 20}}));
    EXPECT_NEAR(height(10, 20), 1.5, 1e-5);
}

TEST_F(Sculpting, ARampGoesFromTheFirstPointsHeightToTheLasts) {
    ASSERT_TRUE(stroke(brush("raise", 6, 5), {{8, 8}}));
    const BrushSettings ramp = brush("ramp", 0, 2);
    ASSERT_TRUE(doc.beginStrokes({&ramp, 1}, 8, 8, true));
    for (const double x : {10.0, 38.0, 30.0}) doc.strokeTo(x, 30);
    doc.pumpStroke(0);
    EXPECT_EQ(height(30, 30), 0);
    EXPECT_NEAR(height(20, 20), 0, 1e-3) << "not before the drag ends";
    doc.endStroke();
    doc.pumpStroke(0);
    EXPECT_FALSE(doc.stroking());
    EXPECT_NEAR(height(8, 8), 6, 1e-2);  // between texels, where the slope begins
    EXPECT_NEAR(height(30, 30), 0, 1e-2);
    EXPECT_NEAR(height(19, 19), 3, 1e-2);
    EXPECT_EQ(height(38, 30), 0) << "where the hand has only been";
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(height(19, 19), 0);
}

TEST_F(Sculpting, HeightsThatAreMirroredAreSculptedWhereTheHandIs) {
    ASSERT_TRUE(doc.setField("ground.Terrain.mapSize", "10"));
    ASSERT_TRUE(stroke(brush("raise", 2, 1), {{13, 24}}));
    for (const auto& [x, z] : {std::pair{13.0, 24.0}, {7.0, 4.0}, {27.0, 16.0}})
        EXPECT_NEAR(height(x, z), 2, 0.02) << x;
    EXPECT_NEAR(height(3, 4), 0, 1e-5);
    ASSERT_TRUE(doc.undo());
    ASSERT_TRUE(stroke(brush("raise", 2, 1), {{2, 5}}));
    ASSERT_TRUE(stroke(brush("ramp", 0, 1), {{2, 5}, {15, 5}}));  // over the mirror at 10
    EXPECT_NEAR(height(2, 5), 2, 0.02);
    EXPECT_NEAR(height(15, 5), 0, 0.02);
    EXPECT_NEAR(height(5.0, 5), height(15, 5), 1e-6) << "the same texels";
    EXPECT_NEAR(height(3.0, 5), 2 - 2.0 / 13, 0.06);
}

TEST_F(Sculpting, TheEndOfARangeIsToldAndAFlatRangeIsRefused) {
    integers();
    const auto told = [&](const BrushSettings& b, const std::vector<std::pair<double, double>>& points) {
        LogCollector log;
        EXPECT_TRUE(stroke(b, points));
        return log.text();
    };
    EXPECT_EQ(told(brush("raise", 1), {{20, 20}}), "");
    const std::string high = told(brush("raise", 50), {{20, 20}});
    EXPECT_NE(high.find("end of heightRange, 10 m, where ground cannot rise higher"), std::string::npos) << high;
    EXPECT_NE(high.find("Heights as Floats"), std::string::npos);
    EXPECT_NE(told(brush("lower", 50), {{20, 20}}).find("0 m, where ground cannot sink lower"), std::string::npos);
    EXPECT_EQ(told(brush("smooth", 1), {{30, 30}}), "") << "not of what was there before";
    ASSERT_TRUE(doc.setField("ground.Terrain.heightRange", "5 5"));
    const uint64_t before = terrain().height.map.hash();
    const Status flat = stroke(brush("raise"), {{20, 20}});
    ASSERT_FALSE(flat);
    EXPECT_NE(flat.error().text().find("spans nothing, from 5 to 5 m"), std::string::npos) << flat.error().text();
    EXPECT_NE(flat.error().text().find("widen"), std::string::npos);
    EXPECT_EQ(terrain().height.map.hash(), before);
}

TEST_F(Sculpting, BadBrushesAreRefusedAndAStrokeBesideTheTerrainIsTold) {
    const float nan = std::nanf("");
    for (const auto& change : std::initializer_list<std::function<void(BrushSettings&)>>{
             [](BrushSettings& b) { b.radius = 0; }, [&](BrushSettings& b) { b.value = nan; },
             [&](BrushSettings& b) { b.talusDeg = nan; }, [](BrushSettings& b) { b.talusDeg = 90; },
             [](BrushSettings& b) { b.water = 1.5f; }, [](BrushSettings& b) { b.bumpSize = -1; }}) {
        BrushSettings bad = brush("erode");
        change(bad);
        const Status s = stroke(bad, {{20, 20}});
        ASSERT_FALSE(s);
        EXPECT_EQ(s.error().code, ExitCode::Usage);
        EXPECT_FALSE(terrain().height.present()) << "nothing was made";
    }
    LogCollector log;
    ASSERT_TRUE(stroke(brush("raise"), {{-60, -60}}));
    EXPECT_NE(log.text().find("beside the terrain"), std::string::npos) << log.text();
    ASSERT_TRUE(stroke(brush("raise"), {{20, 20}, {std::nan(""), 3}, {22, 20}}));
    EXPECT_GT(height(22, 20), 0);
}

TEST_F(Sculpting, WhatAStrokePaintsIsKeptAsItWasUntilSomethingElseChanges) {
    EXPECT_EQ(doc.strokeBefore(), nullptr);
    ASSERT_TRUE(stroke(brush("raise"), {{20, 20}}));
    ASSERT_NE(doc.strokeBefore(), nullptr);
    EXPECT_TRUE(doc.strokeBefore()->at(kHeight).empty());
    ASSERT_TRUE(doc.setField("ground.Terrain.tileSize", "3"));
    EXPECT_EQ(doc.strokeBefore(), nullptr);
    const uint64_t was = terrain().height.map.hash();
    ASSERT_TRUE(stroke(brush("raise"), {{20, 20}}));
    ASSERT_NE(doc.strokeBefore(), nullptr);
    EXPECT_EQ(doc.strokeBefore()->at(kHeight).hash(), was);
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(doc.strokeBefore(), nullptr);
}

// --- shapes, imprint, mirrors, spacing ---------------------------------------------------------------------------

double groundVolume(const Map& map) {
    double sum = 0;
    for (int y = 0; y < map.info().height; ++y)
        for (int x = 0; x < map.info().width; ++x) sum += static_cast<double>(map.at(x, y));
    return sum;
}

TEST_F(Sculpting, StampsLieByTheLengthOfTheWayHoweverFastAndCurved) {
    BrushSettings b = brush("raise", 1, 1);
    b.falloff = 0.5f, b.spacing = 0.25f;  // a stamp every half metre
    ASSERT_TRUE(stroke(b, {{20, 20}}));
    const double one = groundVolume(terrain().height.map);
    ASSERT_TRUE(doc.undo());
    // How many, by the ground that they raised: one more or less is one away.
    const auto stamps = [&](const std::vector<std::pair<double, double>>& points) {
        EXPECT_TRUE(stroke(b, points));
        const double all = groundVolume(terrain().height.map);
        EXPECT_TRUE(doc.undo());
        return all / one;
    };
    std::vector<std::pair<double, double>> slow, circle;
    for (int i = 0; i <= 500; ++i) slow.emplace_back(10 + i * 0.04, 15);
    EXPECT_NEAR(stamps({{10, 15}, {30, 15}}), 41, 0.3) << "20 m in one leap: the first and 40 more";
    EXPECT_NEAR(stamps(slow), 41, 0.3) << "the same way in 500 steps";
    for (int i = 0; i <= 720; ++i)
        circle.emplace_back(20 + 8 * std::cos(i * 0.0087266), 20 + 8 * std::sin(i * 0.0087266));
    EXPECT_NEAR(stamps(circle), 1 + std::floor(2 * 3.14159265 * 8 / 0.5), 0.3) << "50.3 m around";
    EXPECT_NEAR(stamps({{10, 10}, {10.3, 10}, {10.3, 10.3}, {10.6, 10.3}, {10.6, 10.6}}), 3, 0.3)
        << "1.2 m of corners shorter than a step";
    std::vector<std::pair<double, double>> back{{10, 10}, {16.2, 10}, {10, 10}};
    EXPECT_NEAR(stamps(back), 1 + std::floor(12.4 / 0.5), 0.3) << "turning back counts on";
}

TEST_F(Sculpting, AStrokeIsMirroredAboutTheTerrainsMiddleInOneStep) {
    for (const bool whole : {false, true}) {
        if (whole) integers();
        for (const char* mode : {"raise", "noise", "ramp", "imprint", "lower"}) {
            BrushSettings b = brush(mode, 1.5f, 3);
            b.mirrorX = true, b.mirrorZ = std::string(mode) != "noise";
            const double level = height(20, 20);
            const size_t steps = doc.stepsDone();
            const bool ramp = std::string(mode) == "ramp";
            if (ramp) {
                BrushSettings hill = brush("raise", 2, 2);
                hill.mirrorX = hill.mirrorZ = true;
                ASSERT_TRUE(stroke(hill, {{8, 9}}));
            }
            ASSERT_TRUE(stroke(b, {{8, 9}, {12, 13}}));
            EXPECT_EQ(doc.stepsDone(), steps + (ramp ? 2 : 1)) << mode;
            if (std::string(mode) != "noise")
                for (const auto& [x, z] : {std::pair{8.3, 9.1}, {9.5, 11.2}, {11.7, 12.4}}) {
                    EXPECT_NEAR(height(40 - x, z), height(x, z), 2e-3) << mode;
                    EXPECT_NEAR(height(x, 40 - z), height(x, z), 2e-3) << mode;
                    EXPECT_NEAR(height(40 - x, 40 - z), height(x, z), 2e-3) << mode;
                }
            EXPECT_GT(std::abs(height(32, 9) - level), 0.01) << mode;
            if (std::string(mode) == "noise") EXPECT_EQ(height(8, 31), level) << "mirrored across x alone";
            while (doc.stepsDone() > steps) ASSERT_TRUE(doc.undo());
            EXPECT_EQ(height(32, 9), level) << mode;
        }
    }
}

TEST_F(Sculpting, OnTheMiddleLineAMirroredStampIsOne) {
    BrushSettings b = brush("raise", 1, 3);
    b.mirrorX = true;
    ASSERT_TRUE(stroke(b, {{20, 10}}));
    EXPECT_NEAR(height(20, 10), 1, 1e-4);
}

TEST_F(Sculpting, AMirroredShapeAndHeadingAreTurnedRound) {
    std::vector<float> texels(8 * 8, 0.0f);
    for (int y = 0; y < 4; ++y)
        for (int x = 4; x < 8; ++x) texels[static_cast<size_t>(y * 8 + x)] = 1;
    BrushSettings b = brush("raise", 1, 4);
    b.shape = makeShape("corner", 8, 8, std::move(texels)), b.mirrorX = b.mirrorZ = true;
    ASSERT_TRUE(stroke(b, {{10, 10}}));
    EXPECT_NEAR(height(12, 8), 1, 1e-4);
    EXPECT_NEAR(height(28, 8), 1, 1e-4);
    EXPECT_NEAR(height(12, 32), 1, 1e-4);
    EXPECT_NEAR(height(28, 32), 1, 1e-4);
    EXPECT_EQ(height(32, 8), 0);
}

TEST_F(Sculpting, AShapeTurnsByItsAngleAtRandomOrAlongTheStroke) {
    std::vector<float> texels(16 * 16, 0.0f);
    for (int y = 0; y < 8; ++y)
        for (int x = 6; x < 10; ++x) texels[static_cast<size_t>(y * 16 + x)] = 1;  // a bar from the middle up
    BrushSettings b = brush("raise", 1, 3);
    b.shape = makeShape("bar", 16, 16, std::move(texels)), b.spacing = 10;
    ASSERT_TRUE(stroke(b, {{20, 20}}));
    EXPECT_NEAR(height(20, 18), 1, 1e-4);
    EXPECT_EQ(height(22, 20), 0);
    ASSERT_TRUE(doc.undo());
    b.shapeTurn = ShapeTurn::Along;
    ASSERT_TRUE(stroke(b, {{20, 20}, {21, 20}}));
    EXPECT_NEAR(height(22, 20), 1, 1e-4) << "the first stamp waits for the way";
    EXPECT_EQ(height(20, 18), 0);
    ASSERT_TRUE(doc.undo());
    b.shapeTurn = ShapeTurn::Random, b.spacing = 1.5f;  // stamps beside each other
    std::set<int> angles;
    ASSERT_TRUE(stroke(b, {{4, 20}, {36, 20}}));
    for (double x = 4; x < 36; x += 9)
        for (int i = 0; i < 12; ++i)
            if (height(x + 2 * std::sin(i * 0.5236), 20 - 2 * std::cos(i * 0.5236)) > 0.5) angles.insert(i);
    EXPECT_GE(angles.size(), 4u) << "no two alike";
    const uint64_t hash = terrain().height.map.hash();
    ASSERT_TRUE(doc.undo());
    ASSERT_TRUE(stroke(b, {{4, 20}, {36, 20}}));
    EXPECT_EQ(terrain().height.map.hash(), hash) << "the same for the same history";
}

TEST_F(Sculpting, ImprintIsOneStampAStrokeAndStandsOnTheGroundOrABase) {
    ASSERT_TRUE(stroke(brush("flatten", 0), {{1, 1}}));
    BrushSettings hill = brush("raise", 5, 10);
    ASSERT_TRUE(stroke(hill, {{20, 20}}));
    BrushSettings b = brush("imprint", 2, 3);
    b.blend = HeightBlend::Replace, b.falloff = 0;
    ASSERT_TRUE(stroke(b, {{20, 20}, {30, 20}, {35, 20}}));
    EXPECT_NEAR(height(20, 20), 7, 1e-3) << "2 m on the hill of 5";
    EXPECT_LT(height(27, 20), 5.01) << "the drag stamps once";
    b.fromStart = false, b.base = 1;
    ASSERT_TRUE(stroke(b, {{20, 20}}));
    EXPECT_NEAR(height(20, 20), 3, 1e-4);
}

}  // namespace
}  // namespace sward
