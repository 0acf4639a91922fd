// Files that grow: what is added counts only after the switch, and can be taken back without a trace.
#include "core/file_growth.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/file.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

TEST(FileGrowth, CountsFromTheSwitchOn) {
    TempDir dir;
    writeText(dir / "f", std::string("\x08\x00\x00\x00", 4) + "old");
    Result<FileGrowth> growth = FileGrowth::begin(dir / "f");
    ASSERT_TRUE(growth);
    EXPECT_EQ(growth->size(), 7u);
    ASSERT_TRUE(growth->append("new"));
    EXPECT_EQ(growth->size(), 10u);
    ASSERT_TRUE(growth->flush());
    EXPECT_EQ(readText(dir / "f"), std::string("\x08\x00\x00\x00", 4) + "oldnew");
    const HeadSwitch to{0, 8, 0x01020304, 10};
    ASSERT_TRUE(switchHead(dir / "f", to));
    EXPECT_EQ(readText(dir / "f"), "\x04\x03\x02\x01oldnew");
    ASSERT_TRUE(switchHead(dir / "f", to)) << "done already: no error";
    ASSERT_TRUE(switchHead(dir / "f", {0, 8, 9, 10}));
    EXPECT_EQ(readText(dir / "f"), "\x04\x03\x02\x01oldnew") << "another number stands there";
}

TEST(FileGrowth, AFileThatLacksItsNewEndIsNotSwitched) {
    TempDir dir;
    writeText(dir / "f", std::string("\x08\x00\x00\x00", 4) + "old");
    const Status short_ = switchHead(dir / "f", {0, 8, 9, 10});
    ASSERT_FALSE(short_);
    EXPECT_NE(short_.error().text().find("lacks what an interrupted save"), std::string::npos) << short_.error().text();
    EXPECT_EQ(readText(dir / "f"), std::string("\x08\x00\x00\x00", 4) + "old");
}

TEST(FileGrowth, IsTakenBackWithTheFilesTime) {
    TempDir dir;
    writeText(dir / "f", "old");
    const FileStamp before = stampOf(dir / "f");
    Result<FileGrowth> growth = FileGrowth::begin(dir / "f");
    ASSERT_TRUE(growth && growth->append("new"));
    EXPECT_FALSE(stampOf(dir / "f") == before);
    growth->undo();
    EXPECT_EQ(readText(dir / "f"), "old");
    EXPECT_TRUE(stampOf(dir / "f") == before);
}

TEST(FileGrowth, IsOnlyForFilesOfOneNameThatMayBeWritten) {
    TempDir dir;
    EXPECT_FALSE(mayGrow(dir / "absent"));
    EXPECT_FALSE(mayGrow(dir.path));
    EXPECT_FALSE(FileGrowth::begin(dir / "absent"));
    writeText(dir / "f", "old");
    EXPECT_TRUE(mayGrow(dir / "f"));
    fs::create_symlink(dir / "f", dir / "link");
    EXPECT_FALSE(mayGrow(dir / "link"));
    EXPECT_FALSE(FileGrowth::begin(dir / "link"));
    fs::create_hard_link(dir / "f", dir / "copy");
    EXPECT_FALSE(mayGrow(dir / "f")) << "the copy would change with it";
}

TEST(FileGrowth, SwitchesGoThroughAFile) {
    TempDir dir;
    const HeadSwitch to{4, 8, 4294967295u, 4000000000};
    ASSERT_TRUE(writeSwitch(dir / "s", to));
    const Result<HeadSwitch> back = readSwitch(dir / "s");
    ASSERT_TRUE(back);
    EXPECT_TRUE(*back == to);
    for (const char* bad :
         {"", "{}", "[1]", R"({"at": 4, "before": 8})", R"({"at": -1, "before": 8, "after": 9, "size": 1})",
          R"({"at": 4, "before": 8, "after": 4294967296, "size": 1})",
          R"({"at": 4, "before": 8.5, "after": 9, "size": 1})", R"({"at": 4, "before": 8, "after": 9})"}) {
        writeText(dir / "s", bad);
        const Result<HeadSwitch> none = readSwitch(dir / "s");
        ASSERT_FALSE(none) << bad;
        EXPECT_EQ(none.error().code, ExitCode::Unsound) << bad;
        EXPECT_NE(none.error().text().find((dir / "s").string()), std::string::npos) << none.error().text();
    }
}
