// What is chosen follows undo and redo.
#include "app/step_actions.h"

#include <gtest/gtest.h>

#include "model/entity_edits.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

using Names = std::vector<std::string>;

struct Steps : testing::Test {
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "p"));
        ASSERT_TRUE(doc.addEntity("bench"));
    }
    test::TempDir dir;
    Document doc{tables()};
    Selection selection;
    Messages messages;
};

TEST_F(Steps, AnEntityThatComesBackIsChosen) {
    choose(selection, "bench");
    ASSERT_TRUE(doc.removeEntity("bench"));
    dropMissing(selection, doc.project());
    undoStep(doc, selection, messages);
    EXPECT_EQ(selection.entities, Names{"bench"});
    EXPECT_TRUE(messages.status.starts_with("undone: "));
}

TEST_F(Steps, ItIsChosenByItsFormerNameOnceARenamingIsTakenBack) {
    ASSERT_TRUE(renameEntity(doc, "bench", "seat"));
    choose(selection, "seat");
    undoStep(doc, selection, messages);
    EXPECT_EQ(selection.entities, Names{"bench"});
    redoStep(doc, selection, messages);
    EXPECT_EQ(selection.entities, Names{"seat"});
}

TEST_F(Steps, AStepThatBringsNothingLeavesWhatIsChosen) {
    choose(selection, "lawn");
    ASSERT_TRUE(doc.setField("sun.Light.elevationDeg", "20"));
    undoStep(doc, selection, messages);
    EXPECT_EQ(selection.entities, Names{"lawn"});
    EXPECT_TRUE(goToStep(doc, selection, 0));
    EXPECT_FALSE(goToStep(doc, selection, 9));
}

}  // namespace
}  // namespace sward
