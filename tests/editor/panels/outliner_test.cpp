// The outliner: entities are chosen, added and removed.
#include "app/object_actions.h"
#include "app/selection.h"
#include "editor/panels/panel_stage.h"
#include "model/folder_edits.h"
#include "panels/panels.h"
#include "scene/in_folder.h"
#include "scene/locked.h"

namespace sward {
namespace {

class Outliner : public test::PanelStage {
  protected:
    Outliner() {
        name = "Outliner";
        draw = [this] { drawOutliner(fieldParts(), selection, menu); };
    }
    void drag(const std::string& from, const std::string& to) {
        frames(2);
        ASSERT_TRUE(shown(from) && shown(to)) << from << " " << to;
        const auto move = [&](const std::string& path) {
            const ui::Widget& w = book.widgets.at(path);
            queue.push({InputKind::Move, w.x0 + 20.0, (w.y0 + w.y1) / 2.0, 0, false});
            frames(2);
        };
        move(from);
        queue.push({InputKind::Button, 0, 0, 0, true});
        frames(2);
        move(to);
        queue.push({InputKind::Button, 0, 0, 0, false});
        frames(3);
        ui::forgetClicks();
    }
    Selection selection;
    bool menu = false;
};

TEST_F(Outliner, AClickChoosesAndRemoveTakesTheChosenOne) {
    click("Outliner/camera");
    EXPECT_EQ(shownEntity(selection), "camera");
    click("Outliner/Remove");
    EXPECT_TRUE(selection.entities.empty());
    EXPECT_FALSE(doc.project().entities.contains("camera"));
    ASSERT_TRUE(doc.undo());
    EXPECT_TRUE(doc.project().entities.contains("camera"));
}

TEST_F(Outliner, ATypedNameIsAddedChosenAndClearedFromItsLine) {
    type("Outliner/New entity", "hedge");
    EXPECT_TRUE(doc.project().entities.contains("hedge"));
    EXPECT_EQ(shownEntity(selection), "hedge");
    EXPECT_EQ(selection.newEntity, "");
}

TEST_F(Outliner, ANameThatIsTakenIsRefusedUnderItsLineAndKeptThere) {
    type("Outliner/New entity", "camera");
    EXPECT_NE(book.errors["Outliner/New entity"].find("camera"), std::string::npos);
    EXPECT_EQ(selection.newEntity, "camera");
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(Outliner, NothingIsRemovedWhileNothingIsChosen) {
    frames(2);
    EXPECT_FALSE(book.widgets.at("Outliner/Remove").enabled);
    EXPECT_FALSE(book.widgets.at("Outliner/Add entity").enabled) << "without a name";
}

TEST_F(Outliner, AFolderIsListedAboveOpensClosesAndChoosesAllInIt) {
    ASSERT_TRUE(moveToFolder(doc, std::vector<std::string>{"sun", "sky"}, "light"));
    click("Outliner/Folders/light");
    EXPECT_EQ(selection.entities, (std::vector<std::string>{"sky", "sun"}));
    EXPECT_TRUE(shown("Outliner/sun"));
    EXPECT_LT(book.widgets.at("Outliner/sun").y0, book.widgets.at("Outliner/camera").y0);
    click("Outliner/Folders/light/Open");
    frames(2);
    EXPECT_FALSE(shown("Outliner/sun"));
    selection.search = "light";
    frames(2);
    EXPECT_TRUE(shown("Outliner/sun")) << "what is searched for is listed whatever is closed";
    EXPECT_FALSE(shown("Outliner/lawn"));
}

TEST_F(Outliner, AllInAFolderAreHiddenAndLockedInOneStep) {
    ASSERT_TRUE(moveToFolder(doc, std::vector<std::string>{"sun", "sky"}, "light"));
    const size_t steps = doc.stepsDone();
    click("Outliner/Folders/light/Hide");
    click("Outliner/Folders/light/Lock");
    EXPECT_EQ(doc.stepsDone(), steps + 2);
    for (const char* entity : {"sun", "sky"}) {
        EXPECT_TRUE(doc.project().registry.get<Hidden>(findEntity(doc.project(), entity)));
        EXPECT_TRUE(isLocked(doc.project(), entity));
    }
    EXPECT_FALSE(isLocked(doc.project(), "camera"));
    click("Outliner/Folders/light/Show");
    click("Outliner/Folders/light/Unlock");
    EXPECT_FALSE(isLocked(doc.project(), "sun"));
    EXPECT_FALSE(doc.project().registry.get<Hidden>(findEntity(doc.project(), "sky")));
}

TEST_F(Outliner, DraggedRowsComeIntoTheFolderAndOutOfIt) {
    ASSERT_TRUE(moveToFolder(doc, std::vector<std::string>{"sun"}, "light"));
    choose(selection, std::vector<std::string>{"sky", "haze"}, Choose::Only);
    drag("Outliner/haze", "Outliner/Folders/light");
    EXPECT_EQ(folderOf(doc.project(), "sky"), "light") << "all that is chosen goes along";
    EXPECT_EQ(folderOf(doc.project(), "haze"), "light");
    drag("Outliner/camera", "Outliner/sun");
    EXPECT_EQ(folderOf(doc.project(), "camera"), "light") << "to where that row is";
    drag("Outliner/sun", "Outliner/No folder");
    EXPECT_EQ(folderOf(doc.project(), "sun"), "");
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(folderOf(doc.project(), "sun"), "light");
}

TEST_F(Outliner, ANewFolderAsksForItsName) {
    choose(selection, std::vector<std::string>{"sky", "sun"}, Choose::Only);
    folderChosen(doc, selection, messages);
    frames(3);
    for (const char c : std::string("air")) queue.push({InputKind::Char, 0, 0, c, false});
    frames(4);
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_ENTER, true});
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_ENTER, false});
    frames(4);
    EXPECT_TRUE(folderOf(doc.project(), "sun").ends_with("air")) << folderOf(doc.project(), "sun");
    EXPECT_EQ(selection.renaming, "");
}

}  // namespace
}  // namespace sward
