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
    Messages messages;
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
    EXPECT_TRUE(saveNow(d.doc, d.files, d.messages));
    EXPECT_EQ(d.messages.status, "saved: 1 file written");
    EXPECT_EQ(d.messages.notice, "");
    EXPECT_TRUE(saveNow(d.doc, d.files, d.messages));
    EXPECT_EQ(d.messages.status, "saved: nothing had changed");
}

TEST(FileTasks, ASaveThatFailsRaisesTheBar) {
    Desk d;
    ASSERT_TRUE(d.doc.addEntity("second"));
    std::filesystem::remove_all(d.dir / "p");
    test::writeText(d.dir / "p", "a file where the folder was");
    EXPECT_FALSE(saveNow(d.doc, d.files, d.messages));
    EXPECT_NE(d.messages.notice, "");
    EXPECT_TRUE(d.doc.dirty());
}

}  // namespace
}  // namespace sward
