// The file dialog: what it lists, what it refuses, and that another project is told of.
#include "app/background_work.h"
#include "app/file_tasks.h"
#include "app/thumbnails.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"
#include "techniques.h"

namespace sward {
namespace {

class FileDialogPanel : public test::PanelStage {
  protected:
    FileDialogPanel() {
        draw = [this] { drawFileDialog(files, doc, edits, messages, work, thumbnails, [this] { ++adopted; }); };
    }
    void open(FileTask task) {
        requestTask(files, unsaved, doc, task);
        frames(4);
    }
    FileDialog files;
    UnsavedDialog unsaved;
    BackgroundWork work;
    Thumbnails thumbnails;
    int adopted = 0;
};

TEST_F(FileDialogPanel, ListsFoldersAndKnowsProjects) {
    std::filesystem::create_directories(dir / "plain");
    std::filesystem::create_directories(dir / ".hidden");
    test::writeText(dir / "file.txt", "x");
    open(FileTask::Open);
    EXPECT_EQ(files.folder, dir.path);
    EXPECT_EQ(files.entries, (std::vector<std::pair<std::string, bool>>{{"meadow", true}, {"plain", false}}));
}

TEST_F(FileDialogPanel, WithoutAPathItSaysWhatToDo) {
    open(FileTask::Open);
    click("Panel/Open");
    EXPECT_NE(files.error.find("no folder is named"), std::string::npos) << files.error;
    EXPECT_EQ(files.task, FileTask::Open) << "it stays open";
    EXPECT_EQ(adopted, 0);
}

TEST_F(FileDialogPanel, AChosenProjectIsOpenedAndTold) {
    Document other(tables());
    ASSERT_TRUE(other.create(dir / "other"));
    open(FileTask::Open);
    click("Panel/other");
    click("Panel/Open");
    EXPECT_EQ(doc.project().dir, dir / "other");
    EXPECT_EQ(adopted, 1);
    EXPECT_EQ(files.task, FileTask::None);
}

TEST_F(FileDialogPanel, SavingElsewhereIsNoOtherProject) {
    open(FileTask::SaveAs);
    files.path = (dir / "copy").string();
    click("Panel/Save");
    EXPECT_EQ(doc.project().dir, dir / "copy");
    EXPECT_EQ(adopted, 0);
}

TEST_F(FileDialogPanel, ANewProjectIsAsLargeAndHillyAsAskedFor) {
    open(FileTask::New);
    EXPECT_EQ(value("Panel/Template/field"), "true");
    EXPECT_TRUE(shown("Panel/Template/pond"));
    files.wish.size = 200, files.wish.relief = 6;
    files.path = (dir / "wide").string();
    click("Panel/Create");
    EXPECT_EQ(files.error, "");
    EXPECT_EQ(adopted, 1);
    EXPECT_EQ(field("ground.Terrain.size"), "[200, 200]");
    EXPECT_TRUE(firstOf<Terrain>(doc.project())->height.present());
    EXPECT_FALSE(doc.canUndo()) << "it is as if it had been opened";
}

TEST_F(FileDialogPanel, ASizeThatCannotBeIsRefusedAndNothingIsMade) {
    open(FileTask::New);
    files.wish.size = 9000;
    files.path = (dir / "huge").string();
    click("Panel/Create");
    EXPECT_NE(files.error.find("9000"), std::string::npos) << files.error;
    EXPECT_FALSE(std::filesystem::exists(dir / "huge"));
    EXPECT_EQ(doc.project().dir, dir / "meadow");
}

TEST_F(FileDialogPanel, CancelChangesNothing) {
    open(FileTask::New);
    click("Panel/Cancel");
    EXPECT_EQ(files.task, FileTask::None);
    EXPECT_EQ(doc.project().dir, dir / "meadow");
}

TEST_F(FileDialogPanel, ExportStartsInTheBackgroundAndRefusesWhatIsNoGlb) {
    open(FileTask::Export);
    EXPECT_EQ(files.path, (dir / "meadow.glb").string());
    files.path = (dir / "meadow.txt").string();
    click("Panel/Export");
    frames(2);
    EXPECT_NE(files.error, "");
    EXPECT_FALSE(work.exporting);
    files.path = (dir / "meadow.glb").string(), files.bladesWithin = "far";
    click("Panel/Export");
    frames(2);
    EXPECT_FALSE(work.exporting);
    files.bladesWithin = "1.5";
    click("Panel/Export");
    frames(2);
    EXPECT_EQ(files.task, FileTask::None);
    ASSERT_TRUE(work.exporting);
    EXPECT_EQ(work.exporting->file, dir / "meadow.glb");
    EXPECT_EQ(adopted, 0);
}

TEST_F(FileDialogPanel, AnExportOfTooMuchIsRefusedInTheDialog) {
    ASSERT_TRUE(doc.setField("lawn.GrassField.species[0].bladesPerM2", "100000"));
    open(FileTask::Export);
    click("Panel/Export");
    frames(2);
    EXPECT_NE(files.error.find("million blades"), std::string::npos) << files.error;
    EXPECT_EQ(files.task, FileTask::Export) << "it stays open";
    EXPECT_FALSE(work.exporting);
}

TEST_F(FileDialogPanel, AnExportThatFailsLaterIsAskedForAgain) {
    EXPECT_TRUE(askAgain(files, dir / "scene.glb", failed("more than 5 blades")));
    frames(4);
    EXPECT_EQ(value("Panel/Path"), (dir / "scene.glb").string());
    EXPECT_EQ(value("Panel/Error"), "more than 5 blades");
    EXPECT_FALSE(askAgain(files, dir / "other.glb", failed("no"))) << "another dialog is open";
}

}  // namespace
}  // namespace sward
