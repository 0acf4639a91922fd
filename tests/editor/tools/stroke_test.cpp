// Strokes: where a hand is heading, what brushes are refused, and how maps lie on the terrain.
#include "tools/stroke.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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
    EXPECT_NE(comb.error().text().find("raise, lower, flatten, ramp or erode"), std::string::npos);
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

}  // namespace
}  // namespace sward
