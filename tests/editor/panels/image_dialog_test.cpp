// The dialog that shows an image before it is taken.
#include "panels/image_dialog.h"

#include "editor/panels/panel_stage.h"
#include "maps/map_io.h"

namespace sward {
namespace {

class ImageDialogPanel : public test::PanelStage {
  protected:
    void SetUp() override {
        PanelStage::SetUp();
        name = "Image";
        Map map({8, 4, 1, PixelType::U16});
        map.set(0, 0, 0, 0.75f);
        ASSERT_TRUE(writeMap(dir / "hills.png", map));
        test::writeText(dir / "notes.txt", "no image");
        test::writeText(dir / "broken.png", "no image either");
        images.folder = dir.path;
        requestImage(images, doc, ImageTask::Map, "ground.Terrain.height");
        draw = [this] {
            drawImageDialog(images, edits, [this](const ImageDialog& d, const auto& then) { then(take(d)); });
        };
        frames(3);
    }
    Status take(const ImageDialog& d) {
        taken = d.path;
        return refused ? Status{usage("it is refused", "choose another")} : Status{};
    }
    ImageDialog images;
    std::string taken;
    bool refused = false;
};

TEST_F(ImageDialogPanel, ShowsAnImageWithItsRangeAndFlipsAndTakesIt) {
    EXPECT_EQ(value("Image/Told"), "Choose an image.");
    EXPECT_FALSE(shown("Image/notes.txt"));
    click("Image/hills.png");
    frames(2);
    EXPECT_EQ(value("Image/Told"), "8 x 4, 16 bit, 1 channel, 0 to 0.75");
    EXPECT_EQ(value("Image/Preview"), (dir / "hills.png").string());
    EXPECT_EQ(images.preview.pixels[0], 0xffffffffu);
    click("Image/Flip Z");
    EXPECT_TRUE(images.flipZ);
    EXPECT_EQ(taken, "") << "nothing is taken before it is asked for";
    click("Image/Import");
    EXPECT_EQ(taken, (dir / "hills.png").string());
    EXPECT_EQ(images.task, ImageTask::None);
}

TEST_F(ImageDialogPanel, AFileThatIsTypedIsShownAndNotYetTaken) {
    type("Image/Path", (dir / "hills.png").string());
    EXPECT_EQ(value("Image/Told"), "8 x 4, 16 bit, 1 channel, 0 to 0.75");
    EXPECT_EQ(taken, "");
    EXPECT_EQ(images.task, ImageTask::Map);
}

TEST_F(ImageDialogPanel, SaysWhatIsWrongAndStays) {
    click("Image/broken.png");
    frames(2);
    EXPECT_NE(value("Image/Told").find("broken.png"), std::string::npos);
    refused = true;
    click("Image/Import");
    frames(2);
    EXPECT_NE(value("Image/Error").find("it is refused"), std::string::npos);
    EXPECT_EQ(images.task, ImageTask::Map);
    click("Image/Cancel");
    EXPECT_EQ(images.task, ImageTask::None);
}

TEST(ImageRange, IsTwoRisingNumbersOrNothing) {
    EXPECT_FALSE(*rangeOf("", ""));
    EXPECT_EQ(**rangeOf("-5", "12.5"), std::pair(-5.0, 12.5));
    for (const auto& [low, high] : {std::pair{"5", ""}, {"5", "5"}, {"a", "9"}, {"1", "inf"}})
        EXPECT_FALSE(rangeOf(low, high)) << low << " " << high;
}

}  // namespace
}  // namespace sward
