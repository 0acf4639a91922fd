// Entities copied, named anew, removed and hidden: one undo step each, or nothing.
#include "model/entity_edits.h"

#include <gtest/gtest.h>

#include "grass/mesh_grass_settings.h"
#include "model/field_walk.h"
#include "scene/locked.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

using Names = std::vector<std::string>;

class EntityEdits : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "p"));
        for (const char* name : {"bench", "tree-08", "tree-09"}) ASSERT_TRUE(doc.addEntity(name));
        ASSERT_TRUE(doc.addComponent("bench", "Transform"));
        ASSERT_TRUE(doc.setField("bench.Transform.position", "[1, 2, 3]"));
        ASSERT_TRUE(doc.addComponent("bench", "StaticMesh"));
        before = snapshot(doc.project(), tables().components);
    }
    bool asBefore() { return sameProject(doc.project(), before, tables().components); }
    std::string text(const std::string& path) {
        const auto f = findField(doc.project(), tables().components, path);
        return f ? fieldText(*f) : f.error().message;
    }
    test::TempDir dir;
    Document doc{tables()};
    Project before;
};

TEST_F(EntityEdits, FreeNamesCountOn) {
    const Project& p = doc.project();
    EXPECT_EQ(freeName(p, "stone"), "stone");
    EXPECT_EQ(freeName(p, "bench"), "bench-2");
    EXPECT_EQ(freeName(p, "tree-08"), "tree-10") << "as many digits, and the next that is free";
    EXPECT_EQ(freeName(p, "B\xC3\xA4nk 2"), "Bnk2");
    EXPECT_EQ(freeName(p, "..."), "object");
}

TEST_F(EntityEdits, CopiesHaveEverythingAndAreOneStep) {
    const auto copies = duplicateEntities(doc, Names{"bench", "tree-08", "tree-09", "lawn"});
    ASSERT_TRUE(copies) << copies.error().text();
    EXPECT_EQ(*copies, (Names{"bench-2", "tree-10", "tree-11", "lawn-2"}));
    EXPECT_EQ(text("bench-2.Transform.position"), "[1, 2, 3]");
    const std::string density = ".GrassField.species[lawn].density";
    const auto map = [&](const std::string& entity) {
        return static_cast<const MapField*>(findField(doc.project(), tables().components, entity + density)->value)
            ->map;
    };
    EXPECT_TRUE(map("lawn-2").sameTiles(map("lawn")));
    EXPECT_EQ(doc.undoLabel(), "duplicate 4 entities");
    ASSERT_TRUE(doc.undo());
    EXPECT_TRUE(asBefore());
}

TEST_F(EntityEdits, ACopyOfWhatIsNotThereChangesNothing) {
    const std::string label = doc.undoLabel();
    EXPECT_FALSE(duplicateEntities(doc, Names{"bench", "nobody"}));
    EXPECT_TRUE(asBefore());
    EXPECT_EQ(doc.undoLabel(), label);
}

TEST_F(EntityEdits, WhatNamesAnEntityFollowsItsName) {
    ASSERT_TRUE(doc.addComponent("bench", "MeshGrass"));
    ASSERT_TRUE(doc.setField("bench.MeshGrass.field", "lawn"));
    doc.rememberImport("lawn.GrassField.species[lawn].density", {"d.png", true, {}});
    before = snapshot(doc.project(), tables().components);
    ASSERT_TRUE(renameEntity(doc, "lawn", "meadow"));
    EXPECT_FALSE(doc.project().entities.contains("lawn"));
    EXPECT_EQ(text("bench.MeshGrass.field"), "meadow");
    EXPECT_EQ(doc.project().imports.at("meadow.GrassField.species[lawn].density").file, "d.png");
    EXPECT_EQ(doc.undoLabel(), "rename lawn to meadow");
    ASSERT_TRUE(doc.undo());
    EXPECT_TRUE(asBefore());
    ASSERT_TRUE(doc.redo());
    EXPECT_EQ(text("bench.MeshGrass.field"), "meadow");
}

TEST_F(EntityEdits, ANameThatIsTakenOrNoneIsRefusedAndNothingChanges) {
    EXPECT_FALSE(renameEntity(doc, "bench", "tree-08"));
    EXPECT_FALSE(renameEntity(doc, "bench", "a b"));
    EXPECT_FALSE(renameEntity(doc, "nobody", "somebody"));
    EXPECT_TRUE(renameEntity(doc, "bench", "bench"));
    EXPECT_TRUE(asBefore());
}

TEST_F(EntityEdits, WhatHoldsUnknownPartsKeepsItsName) {
    ASSERT_TRUE(doc.save());
    const auto file = dir / "p" / "project.json";
    std::string json = test::readText(file);
    const size_t at = json.find("\"bench\": {");
    ASSERT_NE(at, std::string::npos);
    json.insert(at + 10, "\"Future\": {\"a\": 1},");
    test::writeText(file, json);
    ASSERT_TRUE(doc.open(dir / "p"));
    const Status refused = renameEntity(doc, "bench", "seat");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("bench"), std::string::npos);
    EXPECT_TRUE(renameEntity(doc, "tree-08", "oak"));
}

TEST_F(EntityEdits, SeveralAreRemovedInOneStep) {
    ASSERT_TRUE(removeEntities(doc, Names{"bench", "tree-08"}));
    EXPECT_FALSE(doc.project().entities.contains("bench"));
    EXPECT_FALSE(removeEntities(doc, Names{"tree-09", "bench"})) << "bench is gone";
    EXPECT_TRUE(doc.project().entities.contains("tree-09"));
    ASSERT_TRUE(doc.undo());
    EXPECT_TRUE(asBefore());
}

TEST_F(EntityEdits, WhatIsHiddenIsNotInTheProjectThatIsShown) {
    EXPECT_EQ(&doc.visibleProject(), &doc.project());
    ASSERT_TRUE(hideEntities(doc, Names{"bench", "tree-08"}, true));
    EXPECT_FALSE(doc.visibleProject().entities.contains("bench"));
    EXPECT_TRUE(doc.visibleProject().entities.contains("tree-09"));
    EXPECT_TRUE(doc.project().entities.contains("bench"));
    ASSERT_TRUE(hideEntities(doc, Names{"bench"}, true)) << "it is already";
    ASSERT_TRUE(hideEntities(doc, Names{"bench"}, false));
    EXPECT_TRUE(doc.visibleProject().entities.contains("bench"));
    ASSERT_TRUE(doc.undo());
    ASSERT_TRUE(doc.undo());
    EXPECT_TRUE(asBefore());
    EXPECT_EQ(&doc.visibleProject(), &doc.project());
}

TEST_F(EntityEdits, HiddenIsSavedAndLoaded) {
    ASSERT_TRUE(hideEntities(doc, Names{"bench"}, true));
    ASSERT_TRUE(doc.save());
    ASSERT_TRUE(doc.open(dir / "p"));
    EXPECT_FALSE(doc.visibleProject().entities.contains("bench"));
}

TEST_F(EntityEdits, LockingIsOneStepAndComesOff) {
    const size_t steps = doc.stepsDone();
    ASSERT_TRUE(lockEntities(doc, Names{"bench", "tree-08"}, true));
    EXPECT_EQ(doc.stepsDone(), steps + 1);
    EXPECT_TRUE(isLocked(doc.project(), "bench"));
    EXPECT_FALSE(isLocked(doc.project(), "tree-09"));
    EXPECT_FALSE(isLocked(doc.project(), "nobody"));
    ASSERT_TRUE(lockEntities(doc, Names{"bench", "tree-08", "tree-09"}, false));
    EXPECT_TRUE(asBefore());
    EXPECT_FALSE(lockEntities(doc, Names{"bench", "nobody"}, true));
    EXPECT_TRUE(asBefore()) << "all or nothing";
}

}  // namespace
}  // namespace sward
