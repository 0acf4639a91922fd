// Programs beside the editor: their end, their output, and that stopping stops all they started.
#include "editor/app/child_process.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/file.h"
#include "support.h"

namespace sward {
namespace {

std::optional<int> ended(ChildProcess& child) {
    for (int i = 0; i < 1000; ++i) {
        if (const auto code = child.poll()) return code;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return {};
}

TEST(ChildProcess, AProgramBesideWritesToFilesAndTellsItsEnd) {
    test::TempDir dir;
    auto child = ChildProcess::start({"/bin/sh", "-c", "echo said; echo wrong >&2; exit 3"}, dir / "out", dir / "err");
    ASSERT_TRUE(child) << child.error().text();
    EXPECT_EQ(ended(*child), 3);
    EXPECT_FALSE(child->running());
    EXPECT_EQ(*readFile(dir / "out", 100), "said\n");
    EXPECT_EQ(*readFile(dir / "err", 100), "wrong\n");
    auto missing = ChildProcess::start({"/no/such/program"}, dir / "out", dir / "err");
    ASSERT_TRUE(missing);
    EXPECT_EQ(ended(*missing), 127);
    EXPECT_FALSE(ChildProcess::start({"/bin/true"}, dir / "nowhere" / "out", dir / "err"));
}

TEST(ChildProcess, StoppingAProgramEndsWhatItStartedToo) {
    test::TempDir dir;
    auto child = ChildProcess::start(
        {"/bin/sh", "-c",
         "(sleep 0.4; echo late > " + (dir / "late").string() + ") & echo up > " + (dir / "up").string() + "; wait"},
        dir / "out", dir / "err");
    ASSERT_TRUE(child);
    for (int i = 0; i < 1000 && !std::filesystem::exists(dir / "up"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    child->stop();
    EXPECT_FALSE(child->running());
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    EXPECT_FALSE(std::filesystem::exists(dir / "late"));
}

}  // namespace
}  // namespace sward
