// Locks: between two of one thread, between processes, and after the death of who held one.
#include "core/file_lock.h"

#include <gtest/gtest.h>

#include "tests/child.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {
// Holds a lock on a file until it is killed; writes a byte once it has it.
const ChildFunctionRow kHoldFile("hold-file", [](const std::vector<std::string>& args) -> std::string {
    FileLock lock;
    if (lock.tryFile(args.at(0)) != LockTry::Taken) return "busy";
    if (write(STDOUT_FILENO, ".", 1) != 1) return "nobody listens";
    for (;;) pause();
});
const ChildFunctionRow kHoldFolder("hold-folder", [](const std::vector<std::string>& args) -> std::string {
    FileLock lock;
    if (lock.tryFolder(args.at(0), LockKind::Shared) != LockTry::Taken) return "busy";
    if (write(STDOUT_FILENO, ".", 1) != 1) return "nobody listens";
    for (;;) pause();
});
Child startHolding(const std::string& name, const fs::path& what) {
    const Child child = startChild(name, {what.string()});
    char begun = 0;
    EXPECT_EQ(read(child.output, &begun, 1), 1);
    return child;
}
void end(const Child& child) {
    kill(child.pid, SIGKILL);
    finishChild(child);
}
}  // namespace

TEST(FileLock, ExcludesAnotherOfTheSameThreadUntilItIsReleased) {
    TempDir dir;
    FileLock first, second;
    EXPECT_EQ(first.tryFile(dir / "lock"), LockTry::Taken);
    EXPECT_EQ(second.tryFile(dir / "lock"), LockTry::Busy);
    EXPECT_FALSE(second.held());
    FileLock moved = std::move(first);
    EXPECT_EQ(second.tryFile(dir / "lock"), LockTry::Busy) << "it moved, and is held still";
    moved.release();
    EXPECT_EQ(second.tryFile(dir / "lock"), LockTry::Taken);
}

TEST(FileLock, OfAFolderIsSharedByReadersAlone) {
    TempDir dir;
    FileLock a, b, writer;
    EXPECT_EQ(a.tryFolder(dir.path, LockKind::Shared), LockTry::Taken);
    EXPECT_EQ(b.tryFolder(dir.path, LockKind::Shared), LockTry::Taken);
    EXPECT_EQ(writer.tryFolder(dir.path, LockKind::Exclusive), LockTry::Busy);
    a.release();
    b.release();
    EXPECT_EQ(writer.tryFolder(dir.path, LockKind::Exclusive), LockTry::Taken);
    EXPECT_EQ(a.tryFolder(dir.path, LockKind::Shared), LockTry::Busy);
    EXPECT_EQ(a.tryFolder(dir / "none", LockKind::Shared), LockTry::Absent);
}

TEST(FileLock, OfAnotherProcessNamesItAndGoesWhenItIsKilled) {
    TempDir dir;
    const Child child = startHolding("hold-file", dir / "lock");
    FileLock lock;
    EXPECT_EQ(lock.tryFile(dir / "lock"), LockTry::Busy);
    const std::string named = "process " + std::to_string(child.pid);
    EXPECT_TRUE(lockHolder(dir / "lock").starts_with(named + " on ")) << lockHolder(dir / "lock");
    end(child);
    EXPECT_TRUE(fs::exists(dir / "lock")) << "its note is left behind";
    EXPECT_EQ(lock.tryFile(dir / "lock"), LockTry::Taken);
    EXPECT_TRUE(lockHolder(dir / "lock").starts_with("process " + std::to_string(getpid())));
}

TEST(FileLock, OfAFolderNamesItsHolderWhereTheSystemTells) {
    TempDir dir;
    const Child child = startHolding("hold-folder", dir.path);
    const std::string holder = lockHolder(dir.path);
    EXPECT_TRUE(holder == "another program" || holder.starts_with("process " + std::to_string(child.pid))) << holder;
    end(child);
}

TEST(FileLock, OfARemovedFileDoesNotHoldTheNextOfItsName) {
    TempDir dir;
    FileLock old, fresh;
    ASSERT_EQ(old.tryFile(dir / "lock"), LockTry::Taken);
    fs::remove(dir / "lock");
    EXPECT_EQ(fresh.tryFile(dir / "lock"), LockTry::Taken);
    EXPECT_TRUE(fs::exists(dir / "lock"));
    EXPECT_EQ(old.tryFile(dir / "lock"), LockTry::Busy);
    EXPECT_EQ(old.tryFile(dir / "none/lock"), LockTry::Absent);
}
