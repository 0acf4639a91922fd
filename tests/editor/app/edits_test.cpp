// Edits that wait for the end of a frame, and the undo group of a drag.
#include "app/edits.h"

#include <gtest/gtest.h>

#include "model/document.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

TEST(Edits, RunInOrderAndWhatTheyDeferWaitsForTheNextFrame) {
    Edits edits;
    std::string ran;
    edits.deferred.push_back([&] {
        ran += "a";
        edits.deferred.push_back([&] { ran += "c"; });
    });
    edits.deferred.push_back([&] { ran += "b"; });
    runDeferred(edits);
    EXPECT_EQ(ran, "ab");
    runDeferred(edits);
    EXPECT_EQ(ran, "abc");
    runDeferred(edits);
    EXPECT_EQ(ran, "abc");
}

TEST(Edits, AHeldGroupEndsOnceNothingIsHeld) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    Edits edits;
    doc.beginGroup("set a");
    edits.holding = "a";
    ASSERT_TRUE(doc.addEntity("one"));
    releaseGroup(edits, doc, true);
    EXPECT_EQ(edits.holding, "a");
    EXPECT_FALSE(doc.canUndo()) << "the group is open";
    releaseGroup(edits, doc, false);
    EXPECT_EQ(edits.holding, "");
    EXPECT_EQ(doc.undoLabel(), "set a");
    releaseGroup(edits, doc, false);
    EXPECT_TRUE(doc.canUndo()) << "nothing is ended twice";
}

}  // namespace
}  // namespace sward
