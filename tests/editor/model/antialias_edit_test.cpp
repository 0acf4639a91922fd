#include "model/antialias_edit.h"

#include <gtest/gtest.h>

#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

TEST(AntialiasEdit, IsOneStepThatAddsWhoSaysItAndIsTakenBackWhole) {
    test::TempDir dir;
    Document doc{tables()};
    ASSERT_TRUE(doc.create(dir / "p"));
    const size_t entities = doc.project().entities.size();
    ASSERT_TRUE(chooseAntialias(doc, Antialiasing::Msaa));
    EXPECT_FALSE(doc.canUndo()) << "samples of one frame are what a project without the component has";
    ASSERT_TRUE(chooseAntialias(doc, Antialiasing::Temporal));
    EXPECT_NE(temporalOf(doc.project()), nullptr);
    EXPECT_EQ(doc.project().entities.size(), entities + 1);
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(doc.project().entities.size(), entities);
    EXPECT_FALSE(doc.canUndo());
}
TEST(AntialiasEdit, SetsAllThatSayIt) {
    test::TempDir dir;
    Document doc{tables()};
    ASSERT_TRUE(doc.create(dir / "p"));
    for (const char* name : {"a", "b"}) {
        ASSERT_TRUE(doc.addEntity(name));
        ASSERT_TRUE(doc.addComponent(name, "Antialias"));
        ASSERT_TRUE(doc.setField(std::string(name) + ".Antialias.antialias", "temporal"));
    }
    const size_t entities = doc.project().entities.size();
    ASSERT_TRUE(chooseAntialias(doc, Antialiasing::Msaa));
    EXPECT_EQ(temporalOf(doc.project()), nullptr);
    EXPECT_EQ(doc.project().entities.size(), entities);
}

}  // namespace
}  // namespace sward
