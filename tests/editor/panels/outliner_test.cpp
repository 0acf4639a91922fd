// The outliner: entities are chosen, added and removed.
#include "app/selection.h"
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

class Outliner : public test::PanelStage {
  protected:
    Outliner() {
        name = "Outliner";
        draw = [this] { drawOutliner(fieldParts(), selection, menu); };
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

}  // namespace
}  // namespace sward
