// The dialog New: a template by its picture, with the size and relief that suit it, and others typed.
#include "panels/new_project.h"

#include "editor/panels/panel_stage.h"

namespace sward {
namespace {

class NewProjectPanel : public test::PanelStage {
  protected:
    void SetUp() override {
        PanelStage::SetUp();
        thumbnails.tables = &doc.tables();
        files.templates = {{"field", "Empty field", "a lawn", dir / "field.lua", "", 40, 0},
                           {"hills", "Meadow with hills", "hills", dir / "hills.lua", "", 120, 9}};
        chooseTemplate(files.wish, files.templates[0]);
        draw = [this] { drawNewProject(files, thumbnails); };
    }
    FileDialog files;
    Thumbnails thumbnails;
};

TEST_F(NewProjectPanel, AClickOnATemplateTakesTheSizeAndReliefThatSuitIt) {
    frames(2);
    EXPECT_EQ(value("Panel/Size"), "40");
    click("Panel/Template/hills");
    frames(2);
    EXPECT_EQ(files.wish.name, "hills");
    EXPECT_EQ(value("Panel/Size"), "120");
    EXPECT_EQ(value("Panel/Relief"), "9");
    EXPECT_EQ(findTemplate(files.templates, "hills"), &files.templates[1]);
    EXPECT_EQ(findTemplate(files.templates, "swamp"), nullptr);
}

}  // namespace
}  // namespace sward
