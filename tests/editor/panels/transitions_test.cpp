// The tab Transitions without a GPU: its controls, and what a result shows.
#include "panels/transitions.h"

#include "editor/panels/panel_stage.h"

namespace sward::test {
namespace {

struct TransitionPanel : PanelStage {
    TransitionPanel() {
        name = "Transitions";
        draw = [this] { drawTransitions({meter, doc, view, edits}); };
    }
    void addPath() {
        ASSERT_TRUE(doc.addComponent("camera", "CameraPath"));
        for (int key = 0; key < 2; ++key) ASSERT_TRUE(doc.addListElement("camera.CameraPath.keys"));
        ASSERT_TRUE(doc.setField("camera.CameraPath.keys[1].seconds", "4"));
    }
    // Four steps, of which the third pops.
    void putResult() {
        meter.plan.path = "camera", meter.plan.pictures = 5;
        const auto walk = beginWalk(doc.project(), doc.tables(), meter.plan);
        ASSERT_TRUE(walk);
        meter.result = Transitions{meter.plan, (*walk)->seconds, (*walk)->views, {}, {}, 0};
        for (size_t i = 0; i < 5; ++i) meter.result->views[i].eye.x = static_cast<double>(i);
        meter.result->drawn = {0.1, 0.25, 2, {0.05, 0.05, 0.25, 0.05}};
        meter.result->floor = {0.1, 0.1, 0, {0.1, 0.1, 0.1, 0.1}};
        meter.revision = doc.revision();
    }
    TransitionMeter meter;
    ViewState view;
};

TEST_F(TransitionPanel, WithoutAPathThereIsNothingToWalk) {
    frames(2);
    EXPECT_FALSE(shown("Transitions/Walk"));
    addPath();
    frames(2);
    EXPECT_TRUE(shown("Transitions/Walk"));
    EXPECT_EQ(value("Transitions/Path"), "camera");
}

TEST_F(TransitionPanel, WalkBeginsAndStopEnds) {
    addPath();
    click("Transitions/Walk");
    EXPECT_TRUE(walking(meter)) << meter.error;
    frames(2);
    EXPECT_EQ(value("Transitions/Walking"), "drawing 1 of 25");
    EXPECT_FALSE(book.widgets.at("Transitions/Path").enabled) << "the plan is that of the walk";
    click("Transitions/Stop");
    EXPECT_FALSE(walking(meter));
    frames();
    EXPECT_TRUE(shown("Transitions/Walk"));
}

TEST_F(TransitionPanel, GoToWorstTakesTheViewThere) {
    addPath();
    putResult();
    frames(2);
    EXPECT_EQ(value("Transitions/Summary").substr(0, 12), "1 of 4 steps");
    EXPECT_EQ(value("Transitions/Graph"), "");
    click("Transitions/Go to worst");
    EXPECT_EQ(viewOf(view.camera).eye.x, 2);
    EXPECT_EQ(view.pathSecond, 2);
    frames();
    EXPECT_EQ(value("Transitions/Graph"), "second 2 to 3: 0.2500, other blades 0.1000");
    click("Transitions/Next moment");
    EXPECT_EQ(viewOf(view.camera).eye.x, 3) << "what pops is between the two";
    click("Transitions/Walk this step");
    ASSERT_TRUE(walking(meter)) << meter.error;
    EXPECT_EQ(meter.walk->seconds.front(), 2);
    EXPECT_EQ(meter.walk->seconds.back(), 3);
    EXPECT_EQ(meter.walk->seconds.size(), 5u);
    click("Transitions/Stop");
    click("Transitions/Walk");
    EXPECT_EQ(meter.walk->seconds.back(), 4) << "all of it again";
}

TEST_F(TransitionPanel, AClickOnABarTakesTheViewToItsStep) {
    addPath();
    putResult();
    click("Transitions/Graph");
    EXPECT_EQ(meter.shown, 1) << "labels take room at the left, so that the middle lies in the path's first half";
    EXPECT_EQ(viewOf(view.camera).eye.x, 1);
}

TEST_F(TransitionPanel, ErrorsAreShown) {
    addPath();
    ASSERT_TRUE(doc.setField("camera.CameraPath.keys[1].seconds", "0"));
    click("Transitions/Walk");
    frames();
    EXPECT_NE(value("Transitions/Error").find("no length"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
