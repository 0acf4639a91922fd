#include "editor/app/layout.h"

#include <gtest/gtest.h>

#include "support.h"

namespace sward {
namespace {

Areas at(const Layout& l, float w = 1280, float h = 800) { return areasOf(l, w, h, 22, 36, 24, 44); }

TEST(Layout, AreasFillTheWindow) {
    const Areas a = at({});
    EXPECT_FLOAT_EQ(a.tools.w + a.viewport.w + a.inspector.w, 1280);
    EXPECT_FLOAT_EQ(a.outliner.h + a.inspector.h, a.viewport.h + a.bottom.h);
    EXPECT_FLOAT_EQ(a.bottom.y + a.bottom.h, a.status.y);
    EXPECT_FLOAT_EQ(a.status.y + a.status.h, 800);
}

TEST(Layout, AHiddenPanelGivesItsPlaceAway) {
    Layout l;
    l.hidden = {"Outliner", "Inspector"};
    l.hidden.insert(std::begin(kBottomPanels), std::end(kBottomPanels));
    const Areas a = at(l);
    EXPECT_FLOAT_EQ(a.viewport.w, 1280 - 44);
    EXPECT_FLOAT_EQ(a.viewport.h, 800 - 22 - 36 - 24);
    l.hidden = {"Outliner"};
    EXPECT_FLOAT_EQ(at(l).inspector.h, 800 - 22 - 36 - 24);
}

TEST(Layout, TheTabInSightIsTheChosenOneOrTheFirstThatIsNotHidden) {
    Layout l;
    l.tab = "Tiers";
    EXPECT_EQ(openTab(l), "Tiers");
    l.hidden = {"Tiers", "Console"};
    EXPECT_EQ(openTab(l), "Profiler");
    l.tab = "nonsense";
    EXPECT_EQ(openTab(l), "Profiler");
    l.hidden = {std::begin(kBottomPanels), std::end(kBottomPanels)};
    EXPECT_EQ(openTab(l), "");
}

TEST(Layout, ThePlotOfAccuracyHasAHeightOfItsOwn) {
    Layout l;
    const float usual = at(l).bottom.h;
    l.tab = "Accuracy";
    EXPECT_GT(at(l).bottom.h, usual);
    bottomHeight(l) = 333;
    EXPECT_FLOAT_EQ(at(l).bottom.h, 333);
    l.tab = "Console";
    EXPECT_FLOAT_EQ(at(l).bottom.h, usual);
}

TEST(Layout, ATinyWindowHasNoNegativeSizes) {
    for (const float size : {1.f, 50.f, 200.f}) {
        const Areas a = at({}, size, size);
        for (const Rect& r : {a.viewport, a.outliner, a.inspector, a.bottom, a.tools}) {
            EXPECT_GE(r.w, 0);
            EXPECT_GE(r.h, 0);
        }
    }
}

TEST(Layout, WhatWasSavedIsLoaded) {
    const test::TempDir dir;
    Layout l;
    l.right = 401, l.bottom = 99, l.accuracy = 222, l.outliner = 0.5f, l.tab = "Hard Cases",
    l.hidden = {"Inspector", "Hard Cases"}, l.shiftErases = true;
    l.timesStrokes = false;
    ASSERT_TRUE(saveLayout(dir / "a/b/layout.txt", l));
    const Layout back = loadLayout(dir / "a/b/layout.txt");
    EXPECT_EQ(back.right, 401);
    EXPECT_EQ(back.bottom, 99);
    EXPECT_EQ(back.accuracy, 222);
    EXPECT_EQ(back.outliner, 0.5f);
    EXPECT_EQ(back.tab, "Hard Cases");
    EXPECT_EQ(back.hidden, l.hidden);
    EXPECT_TRUE(back.shiftErases);
    EXPECT_FALSE(back.timesStrokes);
}

TEST(Layout, SenselessFilesGiveTheDefaults) {
    const test::TempDir dir;
    test::writeText(dir / "layout.txt", "right nan\nbottom -5\noutliner\n\x01\x02 zzz\n");
    const Layout l = loadLayout(dir / "layout.txt");
    EXPECT_EQ(l.right, Layout{}.right);
    EXPECT_EQ(l.outliner, Layout{}.outliner);
    EXPECT_GE(l.bottom, 50);
    EXPECT_EQ(loadLayout(dir / "none.txt").right, Layout{}.right);
}

}  // namespace
}  // namespace sward
