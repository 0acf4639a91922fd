// Files: limits, atomic writing, the user's folders, paths that stay inside.
#include "core/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <optional>

#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {
// Sets or, with null, unsets a variable until this goes.
struct Environment {
    std::string name;
    std::optional<std::string> old;
    Environment(const char* variable, const char* value) : name(variable) {
        if (const char* v = getenv(variable)) old = v;
        value ? setenv(variable, value, 1) : unsetenv(variable);
    }
    ~Environment() { old ? setenv(name.c_str(), old->c_str(), 1) : unsetenv(name.c_str()); }
};
}  // namespace

TEST(Files, ReadingRefusesWhatIsTooLargeMissingOrNoFile) {
    TempDir dir;
    writeText(dir / "f", "12345");
    EXPECT_EQ(*readFile(dir / "f", 5), "12345");
    const auto large = readFile(dir / "f", 4);
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().message, "has 5 bytes; the limit is 4");
    EXPECT_EQ(large.error().code, ExitCode::Unsound);
    EXPECT_EQ(readFile(dir / "none", 4).error().remedy, "check the path");
}

TEST(Files, WhatIsNoFileIsCalledWhatItIs) {
    TempDir dir;
    EXPECT_EQ(readFile(dir.path, 4).error().message, "is a folder, not a file");
    ASSERT_EQ(mkfifo((dir / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(readFile(dir / "pipe", 4).error().message, "is a FIFO (a named pipe), not a file")
        << "and does not wait for a writer";
    EXPECT_EQ(checkRegular("/dev/null").error().message, "is a device, not a file");
    EXPECT_EQ(checkRegular(dir / "pipe").error().code, ExitCode::Unsound);
    writeText(dir / "f", "");
    fs::create_symlink(dir / "f", dir / "link");
    EXPECT_TRUE(checkRegular(dir / "link"));
}

TEST(Files, WritingReplacesTheWholeFileAndLeavesNothingBeside) {
    TempDir dir;
    ASSERT_TRUE(writeFileAtomic(dir / "f", "a long first version"));
    ASSERT_TRUE(writeFileAtomic(dir / "f", std::string("b\0c", 3)));
    EXPECT_EQ(readText(dir / "f"), std::string("b\0c", 3));
    EXPECT_EQ(std::distance(fs::directory_iterator(dir.path), {}), 1);
}

TEST(Files, AFailedWriteLeavesTheOldFileAndSaysWhy) {
    TempDir dir;
    fs::create_directory(dir / "f");
    writeText(dir / "f/inside", "x");
    const Status overFolder = writeFileAtomic(dir / "f", "new");
    ASSERT_FALSE(overFolder);
    EXPECT_EQ(overFolder.error().file, (dir / "f").string());
    EXPECT_EQ(std::distance(fs::directory_iterator(dir.path), {}), 1) << "no left-over";
    EXPECT_FALSE(writeFileAtomic(dir / "none/f", "new"));
    const Status full = writeFileSynced("/dev/full", "new");
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().message.find("No space left"), std::string::npos);
    EXPECT_EQ(full.error().remedy, "free some space and try again");
    EXPECT_TRUE(fs::exists("/dev/full")) << "only files are cleared away";
}

TEST(Files, TheUsersFoldersFollowTheXdgRules) {
    {
        const Environment cache("XDG_CACHE_HOME", "/x/cache"), state("XDG_STATE_HOME", "/x/state");
        EXPECT_EQ(cacheDir(), "/x/cache/sward");
        EXPECT_EQ(stateDir(), "/x/state/sward");
    }
    const Environment cache("XDG_CACHE_HOME", "relative"), state("XDG_STATE_HOME", nullptr);
    {
        const Environment home("HOME", "/h");
        EXPECT_EQ(cacheDir(), "/h/.cache/sward");
        EXPECT_EQ(stateDir(), "/h/.local/state/sward");
    }
    const Environment home("HOME", nullptr);
    EXPECT_TRUE(cacheDir().is_absolute());
    EXPECT_TRUE(stateDir().is_absolute());
    EXPECT_NE(cacheDir(), stateDir());
}

TEST(Files, PathsStayInside) {
    TempDir dir;
    fs::create_directories(dir / "p/maps");
    fs::create_directory_symlink(dir.path, dir / "p/up");
    fs::create_directory_symlink(dir / "p/maps", dir / "p/in");
    for (const char* good : {"a.png", "maps/a.png", "./maps//a.png", "in/a.png", "..a/b", "not/yet/there"})
        EXPECT_TRUE(resolveInside(dir / "p", good)) << good;
    for (const char* bad : {"", "/a.png", "..", "../a.png", "maps/../../a.png", "maps/..", "up/a.png"})
        EXPECT_FALSE(resolveInside(dir / "p", bad)) << bad;
    EXPECT_TRUE(resolveInside(dir.path.string() + "/p/", "a.png")) << "a root that ends in a slash";
    EXPECT_TRUE(resolveInside(dir / "not-made", "a.png"));
    EXPECT_FALSE(resolveInside(dir / "p", std::string("a\0b", 3)));
    EXPECT_TRUE(checkInside("up/a.png")) << "links are not looked at";
    for (const std::string& bad :
         {std::string(), std::string("/a.png"), std::string("maps/.."), std::string("a\0b", 3)})
        EXPECT_FALSE(checkInside(bad)) << bad;
}
