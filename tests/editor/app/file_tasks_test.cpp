// Who is asked before work would be lost, and what saving says.
#include "app/file_tasks.h"

#include <gtest/gtest.h>

#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

struct Desk {
    test::TempDir dir;
    Document doc{tables()};
    FileDialog files;
    UnsavedDialog unsaved;
    OutsideDialog outside;
    Messages messages;
    Waiting waiting;
    SaveParts parts() { return {doc, files, outside, messages, waiting}; }
    bool takeDisk() {
        bool taken = false;
        takeTheirs(outside, doc, waiting, [&] { taken = true; });
        return taken;
    }
    Desk() { EXPECT_TRUE(doc.create(dir / "p")); }
};

TEST(FileTasks, WithoutUnsavedWorkNobodyIsAsked) {
    Desk d;
    bool ran = false;
    askFirst(d.unsaved, d.doc, [&] { ran = true; });
    EXPECT_TRUE(ran);
    EXPECT_FALSE(d.unsaved.then);
    Document none(tables());
    ran = false;
    askFirst(d.unsaved, none, [&] { ran = true; });
    EXPECT_TRUE(ran) << "no project is open";
}

TEST(FileTasks, OpenAndNewAskFirstAndSaveAsDoesNot) {
    Desk d;
    ASSERT_TRUE(d.doc.addEntity("second"));
    requestTask(d.files, d.unsaved, d.doc, FileTask::SaveAs);
    EXPECT_EQ(d.files.task, FileTask::SaveAs);
    EXPECT_EQ(d.files.path, (d.dir / "p").string());
    d.files = {};
    requestTask(d.files, d.unsaved, d.doc, FileTask::Open);
    EXPECT_EQ(d.files.task, FileTask::None) << "the answer is not given yet";
    ASSERT_TRUE(d.unsaved.then);
    d.unsaved.then();
    EXPECT_EQ(d.files.task, FileTask::Open);
    EXPECT_EQ(d.files.folder, d.dir.path);
    EXPECT_EQ(d.files.path, "");
}

TEST(FileTasks, SavingCountsFilesAndTakesTheBarDown) {
    Desk d;
    d.messages.notice = "an older error";
    ASSERT_TRUE(d.doc.addEntity("second"));
    EXPECT_TRUE(saveNow(d.parts()));
    EXPECT_EQ(d.messages.status, "saved: 1 file written");
    EXPECT_EQ(d.messages.notice, "");
    EXPECT_TRUE(saveNow(d.parts()));
    EXPECT_EQ(d.messages.status, "saved: nothing had changed");
}

TEST(FileTasks, ASaveThatFailsRaisesTheBar) {
    Desk d;
    ASSERT_TRUE(d.doc.addEntity("second"));
    std::filesystem::remove_all(d.dir / "p");
    test::writeText(d.dir / "p", "a file where the folder was");
    EXPECT_FALSE(saveNow(d.parts()));
    EXPECT_NE(d.messages.notice, "");
    EXPECT_TRUE(d.doc.dirty());
}

// Another editor of the same project saves between.
struct TwoDesks : Desk {
    Document other{tables()};
    TwoDesks() {
        EXPECT_TRUE(doc.addEntity("mine"));
        EXPECT_TRUE(other.open(dir / "p"));
        EXPECT_TRUE(other.addEntity("theirs"));
        EXPECT_TRUE(other.save());
        EXPECT_FALSE(saveNow(parts())) << "asked first";
        EXPECT_TRUE(outside.files.contains("project.json"));
    }
    bool has(const char* entity) { return findEntity(doc.project(), entity) != kNoEntity; }
};

TEST(FileTasks, WhatAnotherSavedIsNotReplacedUnasked) {
    TwoDesks d;
    d.outside.files.clear();  // cancelled
    EXPECT_FALSE(saveNow(d.parts())) << "asked again: it would be lost";
    d.outside.files.clear();
    EXPECT_FALSE(askOutside(d.outside, d.doc, false)) << "but not every second";
    Document disk(tables());
    ASSERT_TRUE(disk.open(d.dir / "p"));
    EXPECT_NE(findEntity(disk.project(), "theirs"), kNoEntity);
    EXPECT_EQ(findEntity(disk.project(), "mine"), kNoEntity);
}

TEST(FileTasks, TheirsIsTakenInAStepThatUndoTakesBack) {
    TwoDesks d;
    ASSERT_TRUE(d.takeDisk());
    EXPECT_TRUE(d.has("theirs"));
    EXPECT_FALSE(d.has("mine"));
    EXPECT_FALSE(d.doc.dirty());
    EXPECT_FALSE(askOutside(d.outside, d.doc, true));
    ASSERT_TRUE(d.doc.undo());
    EXPECT_TRUE(d.has("mine"));
    EXPECT_FALSE(d.has("theirs"));
    EXPECT_TRUE(d.doc.dirty());
}

TEST(FileTasks, OnesOwnIsSavedOnceThatIsDecidedAndAskedAboutTheNextChange) {
    TwoDesks d;
    keepOwn(d.outside);
    EXPECT_FALSE(askOutside(d.outside, d.doc, false));
    EXPECT_TRUE(saveNow(d.parts()));
    ASSERT_TRUE(d.other.open(d.dir / "p"));
    EXPECT_NE(findEntity(d.other.project(), "mine"), kNoEntity);
    ASSERT_TRUE(d.other.addEntity("more"));
    ASSERT_TRUE(d.other.save());
    EXPECT_TRUE(askOutside(d.outside, d.doc, false));
}

TEST(FileTasks, TheirsThatCannotBeOpenedChangesNothing) {
    TwoDesks d;
    test::writeText(d.dir / "p" / "project.json", "{ broken");
    EXPECT_FALSE(d.takeDisk());
    EXPECT_NE(d.outside.error.find("project.json"), std::string::npos) << d.outside.error;
    EXPECT_TRUE(d.has("mine"));
    EXPECT_TRUE(d.doc.dirty());
}

}  // namespace
}  // namespace sward
