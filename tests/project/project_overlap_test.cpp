// Saves and loads of one project that overlap: of threads, of processes, of one that was killed.
#include <gtest/gtest.h>

#include "core/log.h"
#include "core/save_folder.h"
#include "project/project_files.h"
#include "tests/project/kill_save.h"
#include "tests/rows.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {
SaveWay waiting(double seconds) {
    SaveWay way;
    way.waitSeconds = seconds;
    return way;
}

// In the middle of a save until it is killed; writes a byte once it is there.
const ChildFunctionRow kSaveForEver("save-for-ever", [](const std::vector<std::string>& args) -> std::string {
    const fs::path dir = args.at(0);
    const auto lock = SaveLock::take(dir, 0);
    if (!lock) return lock.error().text();
    const SaveFile file{"project.json", [](const fs::path& to) -> Status {
                            writeText(to, "half");
                            if (write(STDOUT_FILENO, ".", 1) != 1) return failed("nobody listens");
                            for (;;) pause();
                        }};
    const Status saved = commitSave(dir, {file}, {});
    return saved ? "saved" : saved.error().text();
});
Child startSaving(const fs::path& dir) {
    const Child child = startChild("save-for-ever", {dir.string()});
    char begun = 0;
    EXPECT_EQ(read(child.output, &begun, 1), 1);
    return child;
}

// What is logged while one lives.
struct Heard {
    std::mutex mutex;
    std::string text;
    int id = addLogSink([this](LogLevel, const std::string& line) {
        const std::lock_guard guard(mutex);
        text += line + "\n";
    });
    ~Heard() { removeLogSink(id); }
};
}  // namespace

TEST(OverlappingSaves, TheSecondIsRefusedAndNamesTheProcessThatSaves) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    const Child child = startSaving(dir / "p");
    const auto second = saveProject(killState(dir / "p", true), rows(), nullptr, waiting(0.1));
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, ExitCode::Failed);
    EXPECT_EQ(second.error().file, (dir / "p").string());
    EXPECT_TRUE(second.error().message.starts_with("is being saved by process " + std::to_string(child.pid) + " on "))
        << second.error().text();
    EXPECT_NE(second.error().remedy.find("try again"), std::string::npos);
    EXPECT_EQ(readText(dir / "p/.sward-save.tmp/project.json"), "half") << "what the first wrote is left alone";
    EXPECT_EQ(faultOf(dir / "p"), "") << "who reads need not wait while files are written";
    EXPECT_EQ(loadProject(dir / "p", rows())->name, "a");
    kill(child.pid, SIGKILL);
    finishChild(child);
    ASSERT_TRUE(saveProject(killState(dir / "p", true), rows(), nullptr, waiting(0))) << "its lock died with it";
    EXPECT_EQ(loadProject(dir / "p", rows())->name, "b");
    EXPECT_FALSE(fs::exists(dir / "p" / kSaveLockFile));
    EXPECT_FALSE(fs::exists(dir / "p" / kSaveTempFolder));
}

TEST(OverlappingSaves, TheSecondWaitsSaysWhyAndSaves) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    Heard heard;
    {
        auto lock = std::make_unique<Result<SaveLock>>(SaveLock::take(dir / "p", 0));
        ASSERT_TRUE(*lock);
        const std::jthread first([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(1100));
            lock.reset();
        });
        EXPECT_TRUE(saveProject(killState(dir / "p", true), rows(), nullptr, waiting(60)));
    }
    EXPECT_EQ(faultOf(dir / "p"), "");
    EXPECT_EQ(loadProject(dir / "p", rows())->name, "b");
    EXPECT_NE(heard.text.find("is being saved by process " + std::to_string(getpid())), std::string::npos)
        << heard.text;
    EXPECT_NE(heard.text.find("up to 60 s"), std::string::npos) << heard.text;
}

TEST(OverlappingSaves, OfThreadsComeOneAfterTheOther) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    std::atomic<int> failures = 0;
    {
        std::vector<std::jthread> savers;
        for (int t = 0; t < 4; ++t)
            savers.emplace_back([&, t] {
                for (int i = 0; i < 4; ++i)
                    if (!saveProject(killState(dir / "p", (t + i) % 2 == 0), rows())) ++failures;
            });
        for (int i = 0; i < 8; ++i) EXPECT_EQ(faultOf(dir / "p"), "");
    }
    EXPECT_EQ(failures, 0);
    EXPECT_EQ(faultOf(dir / "p"), "");
}

TEST(OverlappingSaves, WhoReadsIsNotLeftWithHalfOfEach) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    {
        const auto reading = lockFolder(dir / "p", LockKind::Shared, 0);
        ASSERT_TRUE(reading && reading->held());
        const auto saved = saveProject(killState(dir / "p", true), rows(), nullptr, waiting(0.05));
        ASSERT_FALSE(saved);
        EXPECT_TRUE(saved.error().message.starts_with("is being read by ")) << saved.error().text();
        EXPECT_FALSE(fs::exists(dir / "p" / kSaveTempFolder));
        EXPECT_FALSE(fs::exists(dir / "p" / kSaveFolder));
        EXPECT_EQ(loadProject(dir / "p", rows())->name, "a");
    }
    EXPECT_TRUE(saveProject(killState(dir / "p", true), rows(), nullptr, waiting(0)));
    EXPECT_EQ(loadProject(dir / "p", rows())->name, "b");
}

// Two that opened the same state: what the later one did not change, the earlier one did.
TEST(OverlappingSaves, TheLaterOfTwoLeavesItsOwnStateWhole) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    Project mine = std::move(*loadProject(dir / "p", rows()));
    const Project opened = snapshot(mine, rows());
    ASSERT_TRUE(saveProject(killState(dir / "p", true), rows()));
    mine.registry.get<GrassField>(findEntity(mine, "lawn"))->seed = 77;
    Heard heard;
    ASSERT_TRUE(saveProject(mine, rows(), &opened));
    EXPECT_EQ(faultOf(dir / "p"), "") << "nothing of the other's state is left";
    EXPECT_EQ(loadProject(dir / "p", rows())->name, "a");
    EXPECT_NE(heard.text.find("another program saved it since"), std::string::npos) << heard.text;
}

TEST(OverlappingSaves, MapsThatAreKnownToLieThereAreNotReadAgain) {
    TempDir dir;
    Project p = killState(dir / "p", true);
    SaveWay way;
    way.stamps = &p.stamps;
    ASSERT_TRUE(saveProject(p, rows(), nullptr, way));
    EXPECT_EQ(p.stamps.size(), 4u) << "project.json and three maps";
    const Project before = snapshot(p, rows());
    Heard heard;
    p.name = "a";
    EXPECT_EQ(*saveProject(p, rows(), &before, way), std::vector<std::string>{"project.json"});
    EXPECT_EQ(p.stamps, loadProject(dir / "p", rows())->stamps);
    EXPECT_EQ(heard.text, "");
}
