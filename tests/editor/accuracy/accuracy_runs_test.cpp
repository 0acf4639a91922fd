// What is done with the results of sweeps and fits.
#include "editor/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include "cost/cost_files.h"
#include "editor/model/document.h"
#include "scene/antialias.h"
#include "support.h"
#include "techniques.h"
#include "tools/camera_control.h"

namespace sward {
namespace {

TEST(AccuracyRuns, AdoptingIsOneUndoStepAndNamesWhatIsTheViews) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    const auto value = [&](const char* name) {
        return fieldText(*findField(doc.project(), doc.tables().components, std::string("lawn.GrassField.") + name));
    };
    const std::string before = value("maxGeom");
    const CostSetting wanted = settingOf("slices", "minGeom=3 maxGeom=7 minBTF=9 maxBTF=18 msaa=1");
    EXPECT_FALSE(isPresent(doc, wanted));
    const auto left = adoptSettings(doc, wanted);
    ASSERT_TRUE(left);
    EXPECT_EQ(*left, std::vector<std::string>{"msaa=1"});
    EXPECT_EQ(value("technique"), "slices");
    EXPECT_EQ(value("maxGeom"), "7");
    EXPECT_EQ(value("maxBTF"), "18");
    EXPECT_EQ(doc.undoLabel(), "adopt settings");
    EXPECT_FALSE(isPresent(doc, wanted)) << "one sample is not what the editor draws";
    EXPECT_TRUE(isPresent(doc, settingOf("slices", "maxGeom=7 msaa=4")));
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(value("maxGeom"), before);
    EXPECT_EQ(value("technique"), "hybrid");
    EXPECT_FALSE(doc.canUndo());
}

TEST(AccuracyRuns, SamplesInOneFrameAreAdoptedOverFramesThatAddUp) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    const CostSetting four = settingOf("slices", "msaa=4");
    ASSERT_TRUE(adoptSettings(doc, settingOf("slices", "antialias=temporal")));
    EXPECT_NE(temporalOf(doc.project()), nullptr);
    EXPECT_FALSE(isPresent(doc, four));
    ASSERT_TRUE(adoptSettings(doc, four));
    EXPECT_EQ(temporalOf(doc.project()), nullptr);
    EXPECT_TRUE(isPresent(doc, four));
}

TEST(AccuracyRuns, AForestsSettingsAreAdoptedByItAndLeaveTheGrassAsItIs) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    ASSERT_TRUE(doc.addEntity("wood"));
    ASSERT_TRUE(doc.addComponent("wood", "Forest"));
    const auto value = [&](const char* path) {
        return fieldText(*findField(doc.project(), doc.tables().components, path));
    };
    const std::string grass = value("lawn.GrassField.technique");
    const CostSetting wanted = settingOf("forest-texcells", "meshesTo=30 msaa=4");
    EXPECT_FALSE(isPresent(doc, wanted));
    ASSERT_TRUE(adoptSettings(doc, wanted));
    EXPECT_EQ(value("wood.Forest.meshesTo"), "30");
    EXPECT_TRUE(isPresent(doc, wanted));
    ASSERT_TRUE(adoptSettings(doc, settingOf("forest-trees", "meshDetail=2")));
    EXPECT_EQ(value("wood.Forest.technique"), "trees");
    EXPECT_EQ(value("lawn.GrassField.technique"), grass);
    EXPECT_FALSE(isPresent(doc, wanted));
}

TEST(AccuracyRuns, SettingsThatDoNotExistChangeNothing) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    EXPECT_FALSE(adoptSettings(doc, settingOf("slices", "maxGeom=7 nonsense=1")));
    EXPECT_FALSE(doc.canUndo());
    EXPECT_EQ(techniqueShown(doc), "hybrid");
    EXPECT_TRUE(settingOf("flat", "as it is").values.empty());
}

TEST(AccuracyRuns, AFitIsReadWithWhatItGivesUp) {
    const auto fit = fitFrom(
        R"({"budget_ms": 8, "fits": true, "tried": 20, "best": {"ms": 7.5, "appearance": 0.02, "settings": "maxGeom=6"},
        "shipped": {"ms": 12, "appearance": 0.015, "settings": "maxGeom=12"}, "next_better": {"ms": 9, "appearance": 0.018, "settings": "maxGeom=8"}, "grid": null})");
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_TRUE(fit->fits);
    EXPECT_EQ(fit->ms, 7.5);
    EXPECT_EQ(fit->settings, "maxGeom=6");
    EXPECT_EQ(fit->shippedMs, 12);
    EXPECT_EQ(fit->better, "9 ms for 0.0180: maxGeom=8");
    EXPECT_EQ(fit->outcome, "");
    EXPECT_FALSE(fit->cutShort);
    EXPECT_TRUE(fitFrom(R"({"fits": true, "cut_short": true, "best": {"ms": 7.5}, "shipped": null})")->cutShort);
    const auto lost = fitFrom(
        R"({"budget_ms": 8, "fits": true, "best": {"ms": 7.5, "appearance": 0.02, "settings": "maxGeom=6"}, "shipped": null,
        "outcome": {"seen": {"search": "wins", "against": "grid"}, "held_out": {"search": "loses", "against": "shipped"}}})");
    ASSERT_TRUE(lost) << lost.error().text();
    EXPECT_EQ(lost->outcome, "from other cameras the settings as they are come nearer: better not adopted");
    EXPECT_FALSE(fitFrom("{\"fits\": true}"));
    EXPECT_FALSE(fitFrom(""));
}

TEST(AccuracyRuns, AdoptingIsToldInWords) {
    EXPECT_EQ(adoptedText(settingOf("flat", "msaa=1"), std::vector<std::string>{"msaa=1"}),
              "adopted: flat; 4 samples stay as they are");
    EXPECT_EQ(adoptedText(settingOf("hybrid", "maxGeom=6"), {}), "adopted: hybrid, maxGeom 6");
}

TEST(AccuracyRuns, WhatIsDrawnSoFarIsShownByItsFirstFrames) {
    const test::TempDir dir;
    CostRow row;
    row.camera = "view", row.technique = "flat", row.settings = "msaa=1", row.ms = {9, 5, 7};
    row.metrics.appearance.distance = 0.04;
    test::writeText(dir / "row-a.json", writeJson(costRowJson(row)));
    row.camera = "other";
    test::writeText(dir / "row-b.json", writeJson(costRowJson(row)));
    row.camera = "view", row.skipped = "too slow";
    test::writeText(dir / "row-c.json", writeJson(costRowJson(row)));
    test::writeText(dir / "row-d.json", "{");
    const std::vector<CostRow> rows = rowsSoFar(dir.path, "view");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].msMedian, 7);
    EXPECT_EQ(rows[0].technique, "flat");
    EXPECT_TRUE(rowsSoFar(dir / "none", "view").empty());
}

TEST(AccuracyRuns, MeasuringIsFromTheViewThatIsShown) {
    const test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    FlyCamera view = flyFrom(viewOf(*findCamera(doc.project(), "")));
    EXPECT_EQ(accuracyCamera(doc, view), "camera");
    view.eye.x += 1;
    const std::string moved = accuracyCamera(doc, view);
    EXPECT_TRUE(moved.starts_with("view-")) << moved;
    view.eye.x += 1;
    EXPECT_NE(accuracyCamera(doc, view), moved);
}

}  // namespace
}  // namespace sward
