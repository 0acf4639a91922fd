// The transition meter without a GPU: what is refused, stopped and dropped. Whole walks:
// panels/transitions_gl_test.cpp.
#include "app/transition_run.h"

#include <gtest/gtest.h>

#include "model/document.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

struct TransitionMeters : testing::Test {
    void SetUp() override { ASSERT_TRUE(doc.create(dir / "meadow")); }
    void addPath(double end) {
        ASSERT_TRUE(doc.addComponent("camera", "CameraPath"));
        for (int key = 0; key < 2; ++key) ASSERT_TRUE(doc.addListElement("camera.CameraPath.keys"));
        ASSERT_TRUE(doc.setField("camera.CameraPath.keys[1].seconds", fmt::format("{}", end)));
    }
    test::TempDir dir;
    Document doc{tables()};
    TransitionMeter meter;
};

TEST_F(TransitionMeters, WithoutAPathItSaysWhatToDo) {
    meter.plan.path = "camera";
    startTransitions(meter, doc);
    EXPECT_FALSE(walking(meter));
    EXPECT_NE(meter.error.find("CameraPath"), std::string::npos) << meter.error;
}

TEST_F(TransitionMeters, AWalkBeginsWithNothingDrawnAndStops) {
    addPath(2);
    meter.plan.path = "camera", meter.plan.pictures = 7;
    startTransitions(meter, doc);
    ASSERT_TRUE(walking(meter)) << meter.error;
    EXPECT_EQ(meter.error, "");
    EXPECT_EQ(shareOf(meter), 0);
    EXPECT_EQ(newsOf(meter), "drawing 1 of 7");
    stopTransitions(meter);
    EXPECT_FALSE(walking(meter));
    EXPECT_EQ(newsOf(meter), "");
}

TEST_F(TransitionMeters, AnotherWalkDropsWhatTheLastOneFound) {
    addPath(2);
    meter.result = Transitions{};
    meter.shown = 3, meter.error = "old";
    meter.plan.path = "camera";
    startTransitions(meter, doc);
    EXPECT_FALSE(meter.result);
    EXPECT_EQ(meter.shown, -1);
    EXPECT_EQ(meter.error, "");
}

}  // namespace
}  // namespace sward
