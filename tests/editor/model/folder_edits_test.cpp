// Folders of the outliner: saved with the project, one undo step each, and nothing else changes.
#include "model/folder_edits.h"

#include <gtest/gtest.h>

#include "model/field_walk.h"
#include "scene/in_folder.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

using Names = std::vector<std::string>;

class FolderEdits : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "p"));
        before = snapshot(doc.project(), tables().components);
    }
    bool asBefore() { return sameProject(doc.project(), before, tables().components); }
    test::TempDir dir;
    Document doc{tables()};
    Project before;
};

TEST_F(FolderEdits, EntitiesComeIntoAFolderAndOutOfItEachInOneStep) {
    ASSERT_TRUE(moveToFolder(doc, Names{"sun", "sky"}, "light & air"));
    auto folders = entitiesByFolder(doc.project());
    EXPECT_EQ(folders.at("light & air"), (Names{"sky", "sun"}));
    EXPECT_EQ(folders.at(""), (Names{"camera", "ground", "haze", "lawn"}));
    ASSERT_TRUE(moveToFolder(doc, Names{"sun", "camera"}, ""));
    EXPECT_EQ(folderOf(doc.project(), "sun"), "");
    EXPECT_EQ(doc.project().registry.get<InFolder>(findEntity(doc.project(), "sun")), nullptr) << "nothing is left";
    ASSERT_TRUE(doc.undo());
    ASSERT_TRUE(doc.undo());
    EXPECT_TRUE(asBefore());
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(FolderEdits, ItIsALineOfTheProjectFileAndComesBackFromIt) {
    ASSERT_TRUE(moveToFolder(doc, Names{"sun"}, "light"));
    ASSERT_TRUE(doc.save());
    EXPECT_NE(test::readText(dir / "p" / "project.json").find("\"folder\": \"light\""), std::string::npos);
    Document again(tables());
    ASSERT_TRUE(again.open(dir / "p"));
    EXPECT_EQ(folderOf(again.project(), "sun"), "light");
}

TEST_F(FolderEdits, RenamingJoinsFoldersAndBadNamesChangeNothing) {
    ASSERT_TRUE(moveToFolder(doc, Names{"sun"}, "a"));
    ASSERT_TRUE(moveToFolder(doc, Names{"sky"}, "b"));
    ASSERT_TRUE(renameFolder(doc, "a", "b"));
    EXPECT_EQ(entitiesByFolder(doc.project()).at("b"), (Names{"sky", "sun"}));
    EXPECT_FALSE(renameFolder(doc, "a", "c")) << "it is gone";
    EXPECT_FALSE(renameFolder(doc, "b", "  "));
    EXPECT_FALSE(moveToFolder(doc, Names{"haze", "nobody"}, "b"));
    EXPECT_EQ(folderOf(doc.project(), "haze"), "") << "all or none";
    EXPECT_EQ(freeFolder(doc.project()), "folder");
    ASSERT_TRUE(moveToFolder(doc, Names{"haze"}, "folder"));
    EXPECT_EQ(freeFolder(doc.project()), "folder 2");
}

}  // namespace
}  // namespace sward
