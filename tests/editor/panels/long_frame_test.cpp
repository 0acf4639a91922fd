// The bar where all blades would take too long: all of them, few of them, or another technique.
#include "panels/long_frame.h"

#include "editor/panels/panel_stage.h"

namespace sward {
namespace {

constexpr const char* kTechniqueOfLawn = "lawn.GrassField.technique";

class LongFrameBar : public test::PanelStage {
  protected:
    void SetUp() override {
        PanelStage::SetUp();
        ASSERT_TRUE(doc.setField("ground.Terrain.size", "[60, 60]"));
        ASSERT_TRUE(doc.setField("lawn.GrassField.species[lawn].bladesPerM2", "20000"));
        ASSERT_TRUE(doc.setField(kTechniqueOfLawn, "geometry"));
        draw = [this] { drawLongFrame({frame, doc, edits, messages}, {0, 30, 800, 500}); };
        name = "Viewport";
        look();
    }
    void look() { followLongFrame(frame, {doc.project(), doc.tables(), doc.revision(), camera, 320, 240}, true); }
    std::string technique() { return field(kTechniqueOfLawn); }

    ViewCamera camera{{1, 1.7, 1}, {20, 0, 20}, 55, 0};
    LongFrame frame;
};

TEST_F(LongFrameBar, AllBladesAreDrawnWhenAskedForAndFewAgain) {
    frames(2);
    ASSERT_TRUE(book.widgets.contains("Viewport/Long frame"));
    click("Viewport/Draw All");
    EXPECT_EQ(shareOfBlades(frame), 1);
    click("Viewport/Draw Few");
    EXPECT_LT(shareOfBlades(frame), 0.1);
}

TEST_F(LongFrameBar, AQuickerTechniqueIsOneUndoStep) {
    frames(2);
    click("Viewport/Draw Quicker");
    EXPECT_NE(technique(), "geometry");
    EXPECT_NE(messages.status.find("undo brings geometry back"), std::string::npos) << messages.status;
    look();
    frames(2);
    EXPECT_FALSE(book.widgets.contains("Viewport/Long frame")) << "it is quick now";
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(technique(), "geometry");
}

}  // namespace
}  // namespace sward
