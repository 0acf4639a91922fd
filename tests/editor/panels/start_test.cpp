// The start screen: a sample opens by a click, a broken project says why and leaves the screen.
#include "panels/start.h"

#include <fstream>

#include "editor/panels/panel_stage.h"

namespace sward::test {
namespace {

using StartPanel = PanelStage;

TEST_F(StartPanel, OpensASampleOrSaysWhyNot) {
    const std::filesystem::path sample = doc.project().dir;
    Document none(tables());
    std::filesystem::create_directories(dir / "broken");
    std::ofstream(dir / "broken/project.json") << "{";
    StartScreen start{{dir / "broken"}, {sample}};
    FileDialog files;
    Thumbnails thumbnails;
    UnsavedDialog unsaved;
    int adopted = 0;
    draw = [&] {
        drawStart({start, thumbnails, none, files, unsaved, edits, messages, waiting, [&] { ++adopted; }},
                  {0, 30, 800, 570});
    };
    click("Panel/Start/Last opened/broken");
    EXPECT_FALSE(none.isOpen());
    EXPECT_NE(messages.notice.find("project.json"), std::string::npos) << messages.notice;
    click("Panel/Start/Samples/" + sample.filename().string());
    EXPECT_TRUE(none.isOpen());
    EXPECT_EQ(adopted, 1);
    click("Panel/Start/New project...");
    EXPECT_EQ(files.task, FileTask::New);
}

TEST_F(StartPanel, ATemplateOpensTheDialogNewWithItsOwnSize) {
    Document none(tables());
    StartScreen start;
    start.templates = {{"field", "Empty field", "", dir / "field.lua", "field.png", 40, 0},
                       {"hills", "Hills", "", dir / "hills.lua", "hills.png", 120, 14}};
    FileDialog files;
    Thumbnails thumbnails;
    UnsavedDialog unsaved;
    draw = [&] {
        drawStart({start, thumbnails, none, files, unsaved, edits, messages, waiting, [] {}}, {0, 30, 800, 570});
    };
    click("Panel/Start/New/hills");
    EXPECT_EQ(files.task, FileTask::New);
    EXPECT_EQ(files.wish.name, "hills");
    EXPECT_EQ(files.wish.size, 120);
    EXPECT_EQ(files.wish.relief, 14);
}

}  // namespace
}  // namespace sward::test
