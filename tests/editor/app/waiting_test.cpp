// What a person waits for: it runs on another thread, its result comes between frames, and cancelling changes nothing.
#include "app/waiting.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "model/whole_map.h"
#include "project/project_files.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

constexpr const char* kDensity = "lawn.GrassField.species[lawn].density";

class WaitedWorks : public testing::Test {
  protected:
    void SetUp() override {
        waiting.patient = false;
        ASSERT_TRUE(doc.create(dir / "p"));
    }
    // Until it has ended, as frames would.
    void finish() {
        while (waits(waiting))
            if (!followWaiting(waiting)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    // Takes as long as `go` is false; then it lays `mark`.
    WaitedWork slow() {
        return [this](JobControl& c) -> Result<Taking> {
            worker = std::this_thread::get_id();
            c.setProgress(0.5);
            while (!go && !c.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            if (c.cancelled()) return failed("it was cancelled");
            return Taking([this]() -> Status {
                taker = std::this_thread::get_id();
                return {};
            });
        };
    }
    WaitedEnd note() {
        return [this](const Status& s) { ended = s, ++ends; };
    }
    uint64_t density() {
        const auto f = findField(std::as_const(doc).project(), doc.tables().components, kDensity);
        return static_cast<const MapField*>(f->value)->map.hash();
    }
    test::TempDir dir;
    Document doc{tables()};
    Waiting waiting;
    std::atomic<bool> go = false;
    std::thread::id worker, taker;
    Status ended;
    int ends = 0;
};

TEST_F(WaitedWorks, WorkRunsElsewhereAndItsResultIsTakenHere) {
    waitFor(waiting, "Working", slow(), note());
    ASSERT_TRUE(waits(waiting)) << "it takes longer than the patience of a frame";
    EXPECT_EQ(waiting.windows, 1u);
    EXPECT_TRUE(waiting.opening);
    EXPECT_EQ(waiting.slot->progress(), 0.5);
    EXPECT_FALSE(followWaiting(waiting));
    EXPECT_EQ(ends, 0);
    go = true;
    finish();
    EXPECT_EQ(ends, 1);
    EXPECT_TRUE(ended);
    EXPECT_EQ(taker, std::this_thread::get_id());
    EXPECT_NE(worker, taker);
}

TEST_F(WaitedWorks, WhatIsQuickEndsAtOnceAndShowsNoWindow) {
    go = true;
    waitFor(waiting, "Working", slow(), note());
    EXPECT_EQ(ends, 1);
    EXPECT_FALSE(waits(waiting));
    EXPECT_EQ(waiting.windows, 0u);
}

TEST_F(WaitedWorks, WhoIsPatientWaitsForTheEnd) {
    waiting.patient = true;
    std::thread later([this] {
        std::this_thread::sleep_for(3 * kPatience);
        go = true;
    });
    waitFor(waiting, "Working", slow(), note());
    EXPECT_EQ(ends, 1);
    later.join();
}

TEST_F(WaitedWorks, OneAtATime) {
    waitFor(waiting, "Working", slow(), note());
    Status second;
    waitFor(waiting, "More", slow(), [&](const Status& s) { second = s; });
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().text().find("Working goes on"), std::string::npos) << second.error().text();
    cancelWaiting(waiting);
    finish();
    EXPECT_EQ(ends, 1);
    EXPECT_FALSE(ended);
}

TEST_F(WaitedWorks, WhatThrowsEndsWithAnError) {
    waitFor(
        waiting, "Working", [](JobControl&) -> Result<Taking> { throw std::runtime_error("out of memory"); }, note());
    finish();
    ASSERT_FALSE(ended);
    EXPECT_NE(ended.error().text().find("out of memory"), std::string::npos);
}

// It runs while something else is made beside.
TEST_F(WaitedWorks, WhatIsMadeBesideKeepsNobodyWaiting) {
    std::atomic<bool> stop = false;
    const Job<int> beside("a bake of an hour", 0, [&](JobControl&) -> Result<int> {
        while (!stop) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return 1;
    });
    go = true;
    waiting.patient = true;
    waitFor(waiting, "Working", slow(), note());
    EXPECT_EQ(ends, 1);
    stop = true;
    while (!beside.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST_F(WaitedWorks, AnEditIsOneStepWithItsLabelAndItsCall) {
    Document plain(tables());
    ASSERT_TRUE(plain.open(dir / "p"));
    ASSERT_TRUE(clearMap(plain, kDensity));
    editBeside(
        waiting, doc, "Clearing", [](Document& d, JobControl&) { return clearMap(d, kDensity); }, note());
    finish();
    ASSERT_TRUE(ended) << ended.error().text();
    EXPECT_EQ(doc.stepLabels(), plain.stepLabels());
    EXPECT_TRUE(doc.dirty());
    EXPECT_EQ(projectHash(doc.project(), doc.tables().components),
              projectHash(plain.project(), plain.tables().components));
    ASSERT_TRUE(doc.undo());
    EXPECT_FALSE(doc.dirty());
}

TEST_F(WaitedWorks, AnEditThatIsCancelledOrFailsChangesNothing) {
    const uint64_t before = density(), revision = doc.revision();
    const auto edit = [this](Document& d, JobControl& c) {
        while (!c.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return clearMap(d, kDensity);
    };
    editBeside(waiting, doc, "Clearing", edit, note());
    ASSERT_TRUE(waits(waiting));
    cancelWaiting(waiting);
    finish();
    ASSERT_FALSE(ended);
    EXPECT_NE(ended.error().text().find("cancelled"), std::string::npos) << ended.error().text();
    EXPECT_EQ(ended.error().code, ExitCode::Interrupted);
    editBeside(
        waiting, doc, "Clearing", [](Document& d, JobControl&) { return clearMap(d, "no.such.map"); }, note());
    finish();
    EXPECT_FALSE(ended);
    EXPECT_EQ(density(), before);
    EXPECT_EQ(doc.revision(), revision);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(WaitedWorks, AnEditOfWhatChangedMeanwhileIsRefused) {
    const auto edit = [this](Document& d, JobControl&) {
        while (!go) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return clearMap(d, kDensity);
    };
    editBeside(waiting, doc, "Clearing", edit, note());
    ASSERT_TRUE(doc.addEntity("second"));
    const uint64_t before = density();
    go = true;
    finish();
    ASSERT_FALSE(ended);
    EXPECT_NE(ended.error().text().find("changed meanwhile"), std::string::npos) << ended.error().text();
    EXPECT_EQ(density(), before);
    EXPECT_EQ(doc.stepsDone(), 1u);
}

TEST_F(WaitedWorks, ASaveAndAnOpeningAreAsThoseOfTheDocument) {
    ASSERT_TRUE(clearMap(doc, kDensity));
    const uint64_t hash = projectHash(doc.project(), doc.tables().components);
    std::vector<std::string> files;
    saveBeside(waiting, doc, {}, [&](const auto& written) { files = written ? *written : files; });
    finish();
    EXPECT_EQ(files.size(), 1u);
    EXPECT_FALSE(doc.dirty());
    EXPECT_EQ(doc.savedStep(), 1u);
    EXPECT_TRUE(changedOutside(doc.project()).empty());
    saveBeside(waiting, doc, dir / "copy", [&](const auto& written) { ended = written ? Status{} : written.error(); });
    finish();
    ASSERT_TRUE(ended) << ended.error().text();
    EXPECT_EQ(doc.project().name, "copy");
    EXPECT_EQ(doc.project().dir, dir / "copy");
    openBeside(waiting, doc, dir / "p", note());
    finish();
    ASSERT_TRUE(ended) << ended.error().text();
    EXPECT_EQ(projectHash(doc.project(), doc.tables().components), hash);
    EXPECT_FALSE(doc.canUndo());
    openBeside(waiting, doc, dir / "nowhere", note());
    finish();
    EXPECT_FALSE(ended);
    EXPECT_EQ(doc.project().name, "p");
}

TEST_F(WaitedWorks, WhatIsEditedWhileItIsSavedStaysUnsaved) {
    ASSERT_TRUE(clearMap(doc, kDensity));
    Result<SaveWork> work = doc.beginSave();
    ASSERT_TRUE(work);
    ASSERT_TRUE(doc.addEntity("later"));
    writeSave(*work, nullptr);
    ASSERT_TRUE(doc.endSave(*work));
    EXPECT_TRUE(doc.dirty());
    EXPECT_EQ(doc.savedStep(), 1u);
    ASSERT_TRUE(doc.undo());
    EXPECT_FALSE(doc.dirty());
}

TEST_F(WaitedWorks, ASaveThatIsCancelledLeavesTheDiskAsItWas) {
    ASSERT_TRUE(clearMap(doc, kDensity));
    Result<SaveWork> work = doc.beginSave();
    ASSERT_TRUE(work);
    JobControl control;
    control.cancel();
    writeSave(*work, &control);
    const auto written = doc.endSave(*work);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().text().find("cancelled"), std::string::npos) << written.error().text();
    EXPECT_TRUE(doc.dirty());
    Document disk(tables());
    ASSERT_TRUE(disk.open(dir / "p"));
    EXPECT_NE(projectHash(disk.project(), disk.tables().components),
              projectHash(doc.project(), doc.tables().components));
    EXPECT_TRUE(doc.save());
}

TEST_F(WaitedWorks, ReadingThatIsCancelledIsSaid) {
    JobControl control;
    control.cancel();
    const auto loaded = loadProject(dir / "p", doc.tables().components, control);
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().text().find("cancelled"), std::string::npos) << loaded.error().text();
}

}  // namespace
}  // namespace sward
