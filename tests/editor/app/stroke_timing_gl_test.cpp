// What a stroke costs, measured while the editor rests. Counts prove that both states were drawn, times only that they
// were taken.
#include "app/stroke_timing.h"

#include "editor/editor_fixture.h"

namespace sward::test {
namespace {

class StrokeTimingEditor : public EditorFixture {
  protected:
    const std::string map_ = "lawn.GrassField.species[lawn].density";
    void SetUp() override {
        EditorFixture::SetUp();
        const auto density = findMap(std::as_const(doc).project(), tables().components, map_);
        ASSERT_TRUE(density);
        Map thin = static_cast<const MapField*>(density->value)->map;
        for (int y = 0; y < thin.info().height; ++y)
            for (int x = 0; x < thin.info().width; ++x) thin.set(x, y, 0, 0.1f);
        ok(doc.setMap(map_, thin, "thin"));
        ok(ui->click("Menu/Brush/Time Strokes"));
        ok(ui->wait(3));
    }
    StrokeTiming& timing() { return app->strokeTiming; }
    // Over the middle of the terrain, all of its blades.
    void stroke(float value) {
        BrushSettings brush;
        brush.map = map_, brush.mode = "set", brush.value = value, brush.radius = 30, brush.falloff = 0;
        ok(doc.beginStroke(brush, 20, 20));
        doc.endStroke();
        while (doc.pumpStroke(0)) {
        }
    }
    void rest() {
        for (int i = 0; i < 400 && !timing().ms; ++i) ok(ui->wait(1));
    }
};

TEST_F(StrokeTimingEditor, TenTimesTheBladesAreMeasuredFromTheViewThatIsShown) {
    ASSERT_TRUE(timing().on);
    stroke(1);
    EXPECT_FALSE(timing().ms);
    rest();
    ASSERT_TRUE(timing().ms);
    EXPECT_EQ(timing().ms->pairs, 7);
    EXPECT_GT(timing().blades->low, 1000) << "with the stroke there are more in every pair";
    for (const double with : timing().frames.blades[0])
        EXPECT_NEAR(with / timing().frames.blades[1][0], 10, 1.5) << "of its 0.1 before";
    ok(ui->wait(3));
    EXPECT_NE(get("Status/Stroke").find(" blades, "), std::string::npos) << get("Status/Stroke");
    EXPECT_NE(get("Status/Stroke").find(" ms ("), std::string::npos) << get("Status/Stroke");
    EXPECT_EQ(timing().now, nullptr) << "nothing is kept";
    ok(ui->key("ctrl+z"));
    ok(ui->wait(3));
    EXPECT_FALSE(timing().ms) << "undone: there is no last stroke";
}

TEST_F(StrokeTimingEditor, AnyEventComesFirstAndAnotherViewBeginsAnew) {
    stroke(1);
    for (int i = 0; i < 400 && timing().frames.drawn < 6; ++i) ok(ui->wait(1));
    ASSERT_EQ(timing().frames.drawn, 6);
    ASSERT_FALSE(timing().ms);
    app->queue.push({InputKind::Move, 5, 5, 0, false});
    for (int i = 0; i < 10; ++i) {
        ok(ui->wait(1));
        EXPECT_EQ(timing().frames.drawn, 6) << "it waits until all has rested for a while";
    }
    rest();
    ASSERT_TRUE(timing().ms) << "and then it goes on";
    EXPECT_EQ(timing().frames.drawn, framesOf(timing().frames));
    app->view.camera.eye.y += 1;
    ok(ui->wait(3));
    EXPECT_FALSE(timing().ms) << "it was of another view";
    EXPECT_TRUE(timing().due);
}

TEST_F(StrokeTimingEditor, WhoTurnsItOffGetsNoFramesForIt) {
    ok(ui->click("Menu/Brush/Time Strokes"));
    stroke(1);
    ok(ui->wait(80));
    EXPECT_FALSE(timing().ms);
    EXPECT_EQ(timing().frames.drawn, 0);
    EXPECT_LT(secondsToTiming(timing(), app->clock.now), 0);
    EXPECT_NE(get("Status/Stroke").find(" blades"), std::string::npos) << "the count stays";
}

TEST_F(StrokeTimingEditor, AStrokeThatMadeItsMapIsNotTimed) {
    BrushSettings brush;
    brush.map = "lawn.GrassField.vegetation", brush.mode = "set", brush.radius = 5;
    const std::vector<BrushSettings> brushes{brush};
    ok(doc.beginStrokes(brushes, 20, 20, true));
    doc.endStroke();
    while (doc.pumpStroke(0)) {
    }
    ok(ui->wait(80));
    EXPECT_FALSE(timing().ms);
    EXPECT_EQ(timing().frames.drawn, 0);
    EXPECT_FALSE(timing().due) << "and is not tried again";
    EXPECT_EQ(timing().view.revision, doc.revision()) << "it was looked at";
}

TEST(StrokeTiming, SlowViewsAreTimedBySmallerPictures) {
    EXPECT_EQ(timingScale(0), 1);
    EXPECT_EQ(timingScale(kTimingFrameMs), 1);
    EXPECT_NEAR(timingScale(4 * kTimingFrameMs), 0.5, 1e-9) << "a quarter of the pixels";
    EXPECT_EQ(timingScale(1e9), 0.25);
}

TEST(StrokeTiming, WhatIsDueWaitsForRestAndForWhatElseIsMade) {
    StrokeTiming t;
    EXPECT_LT(secondsToTiming(t, 0), 0);
    t.due = true, t.lastEvent = 10;
    EXPECT_NEAR(secondsToTiming(t, 10.2), kTimingRestSeconds - 0.2, 1e-9);
    EXPECT_EQ(secondsToTiming(t, 11), 0);
    t.blocked = true;
    EXPECT_LT(secondsToTiming(t, 11), 0) << "nobody is woken in vain";
    t.on = false;
    dropTiming(t);
    EXPECT_FALSE(t.on) << "the setting stays";
    EXPECT_FALSE(t.due);
}

}  // namespace
}  // namespace sward::test
