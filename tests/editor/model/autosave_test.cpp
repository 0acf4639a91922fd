#include "editor/model/autosave.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include <thread>

#include "child.h"
#include "model/document.h"
#include "model/field_walk.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

// Another editor with copies of its own; writes a byte once it has the lock.
const test::ChildFunctionRow kHoldCopies("hold-copies", [](const std::vector<std::string>& args) -> std::string {
    FileLock lock;
    if (lock.tryFile(args.at(0)) != LockTry::Taken) return "busy";
    if (write(STDOUT_FILENO, ".", 1) != 1) return "nobody listens";
    for (;;) pause();
});

// Keeps copies in a folder of the test's own.
class AutosaveFiles : public testing::Test {
  protected:
    void SetUp() override {
        const char* was = std::getenv("XDG_STATE_HOME");
        if (was) before_ = was;
        setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
        ASSERT_TRUE(doc.create(dir / "p"));
    }
    void TearDown() override {
        if (before_)
            setenv("XDG_STATE_HOME", before_->c_str(), 1);
        else
            unsetenv("XDG_STATE_HOME");
    }
    fs::path copyWith(const char* fov) {
        EXPECT_TRUE(doc.setField("camera.Camera.fovDeg", fov));
        const auto made = writeAutosave(doc.project(), tables().components, autosaveFolder(dir / "p"));
        EXPECT_TRUE(made) << made.error().text();
        return made ? *made : fs::path();
    }
    test::TempDir dir;
    Document doc{tables()};

  private:
    std::optional<std::string> before_;
};

TEST_F(AutosaveFiles, CopiesAreNumberedWholeAndOutsideTheProject) {
    EXPECT_TRUE(autosavesOf(dir / "p").empty());
    const fs::path first = copyWith("60"), second = copyWith("61");
    EXPECT_EQ(first.filename(), "0001");
    EXPECT_EQ(second.filename(), "0002");
    EXPECT_TRUE(first.string().starts_with((dir / "state/sward/autosave").string()));
    EXPECT_EQ(autosavesOf(dir / "p"), (std::vector<fs::path>{second, first}));
    Document copy(tables());
    ASSERT_TRUE(copy.open(second));
    EXPECT_TRUE(sameProject(copy.project(), doc.project(), tables().components));
    EXPECT_TRUE(doc.dirty());
    forgetAutosaves(dir / "p");
    EXPECT_TRUE(autosavesOf(dir / "p").empty());
}

TEST_F(AutosaveFiles, OnlyTheNewestStay) {
    for (const char* fov : {"60", "61", "62", "63", "64"}) copyWith(fov);
    const std::vector<fs::path> kept = autosavesOf(dir / "p");
    ASSERT_EQ(kept.size(), kAutosavesKept);
    EXPECT_EQ(kept.front().filename(), "0005");
    EXPECT_EQ(kept.back().filename(), "0003");
}

TEST_F(AutosaveFiles, ProjectsOfTheSameNameAreKeptApart) {
    copyWith("60");
    EXPECT_NE(autosaveFolder(dir / "p"), autosaveFolder(dir / "q/p"));
    EXPECT_EQ(autosaveFolder(dir / "p"), autosaveFolder(dir / "q/../p"));
    EXPECT_TRUE(autosavesOf(dir / "q/p").empty());
}

TEST_F(AutosaveFiles, HalfACopyIsNotOffered) {
    copyWith("60");
    fs::create_directories(autosaveFolder(dir / "p") / "0002/maps");
    EXPECT_EQ(autosavesOf(dir / "p").size(), 1u);
}

// After a reboot the number of the process that made them may be anybody's.
TEST_F(AutosaveFiles, CopiesAreOfferedWhoeverHasTheirMakersNumberNow) {
    copyWith("60");
    const std::string alive = std::to_string(getppid());
    test::writeText(autosaveFolder(dir / "p") / "pid", alive);
    test::writeText(autosaveFolder(dir / "p") / "lock", alive + " meadow\n");
    EXPECT_EQ(autosavesOf(dir / "p").size(), 1u);
}

TEST_F(AutosaveFiles, ThoseOfARunningProgramAreNotOfferedUntilItEnds) {
    copyWith("60");
    const test::Child child = test::startChild("hold-copies", {(autosaveFolder(dir / "p") / "lock").string()});
    char begun = 0;
    ASSERT_EQ(read(child.output, &begun, 1), 1);
    EXPECT_TRUE(autosavesOf(dir / "p").empty());
    forgetAutosaves(dir / "p");
    kill(child.pid, SIGKILL);
    test::finishChild(child);
    EXPECT_EQ(autosavesOf(dir / "p").size(), 1u) << "what another holds is not thrown away";
    forgetAutosaves(dir / "p");
    EXPECT_TRUE(autosavesOf(dir / "p").empty());
}

TEST_F(AutosaveFiles, ASecondEditorKeepsItsCopiesApart) {
    auto first = takeAutosavePlace(dir / "p"), second = takeAutosavePlace(dir / "p");
    ASSERT_TRUE(first && second);
    EXPECT_NE(first->folder, second->folder);
    ASSERT_TRUE(writeAutosave(doc.project(), tables().components, first->folder));
    ASSERT_TRUE(writeAutosave(doc.project(), tables().components, second->folder));
    EXPECT_TRUE(autosavesOf(dir / "p").empty()) << "both live";
    second->lock.release();  // as if it had been killed
    EXPECT_EQ(autosavesOf(dir / "p").size(), 1u);
    const auto later = takeAutosavePlace(dir / "p");
    ASSERT_TRUE(later);
    EXPECT_NE(later->folder, second->folder) << "what is still to be offered is left alone";
}

TEST_F(AutosaveFiles, TakingACopyOverIsOneUnsavedStep) {
    const fs::path copy = [&] {
        EXPECT_TRUE(doc.addEntity("sheep"));
        EXPECT_TRUE(doc.removeEntity("sky"));
        return copyWith("71");
    }();
    Document later(tables());
    ASSERT_TRUE(later.open(dir / "p"));
    const Project saved = snapshot(later.project(), tables().components);
    ASSERT_TRUE(later.takeOver(copy, "recover"));
    EXPECT_TRUE(sameProject(later.project(), doc.project(), tables().components));
    EXPECT_TRUE(later.dirty());
    EXPECT_EQ(later.project().dir, dir / "p");
    ASSERT_TRUE(later.undo());
    EXPECT_TRUE(sameProject(later.project(), saved, tables().components));
    EXPECT_FALSE(later.canUndo());
    EXPECT_FALSE(later.takeOver(dir / "nowhere", "recover"));
    ASSERT_TRUE(later.redo());
    ASSERT_TRUE(later.save());
}

TEST_F(AutosaveFiles, CopiesThatTakeLongComeRarer) {
    Autosave a;
    a.on = true;
    const auto tick = [&](double now) { tickAutosave(a, doc, false, now); };
    tick(0);
    ASSERT_TRUE(doc.setField("camera.Camera.fovDeg", "40"));
    tick(kAutosaveSeconds);
    ASSERT_TRUE(a.job.active());
    while (!a.job.finished()) std::this_thread::yield();
    const double end = kAutosaveSeconds + 30;  // as the clock has it, it took half a minute
    tick(end);
    ASSERT_FALSE(a.job.active());
    ASSERT_TRUE(doc.setField("camera.Camera.fovDeg", "41"));
    tick(kAutosaveSeconds + 299);
    EXPECT_FALSE(a.job.active());
    tick(kAutosaveSeconds + 301);
    EXPECT_TRUE(a.job.active());
    endAutosave(a);
}

// As a full disk: what is written beyond a limit fails.
TEST_F(AutosaveFiles, WhereThereIsNoRoomItFailsAndWhatWasCopiedStays) {
    const fs::path first = copyWith("60");
    ASSERT_TRUE(doc.setField("camera.Camera.fovDeg", "61"));
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto ignored = signal(SIGXFSZ, SIG_IGN);
    const rlimit none{100, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &none);
    const auto made = writeAutosave(doc.project(), tables().components, autosaveFolder(dir / "p"));
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, ignored);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().text().find("cannot"), std::string::npos) << made.error().text();
    EXPECT_EQ(autosavesOf(dir / "p"), std::vector<fs::path>{first});
    Document copy(tables());
    EXPECT_TRUE(copy.open(first));
    EXPECT_TRUE(doc.dirty()) << "nothing is lost";
}

}  // namespace
}  // namespace sward
