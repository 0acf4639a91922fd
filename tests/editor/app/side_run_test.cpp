// A verb beside the editor: what it says of how far it is, what it is given, and how it ends.
#include "editor/app/side_run.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/frame_clock.h"
#include "app/messages.h"
#include "core/file.h"
#include "model/document.h"
#include "project/project_files.h"
#include "support.h"
#include "techniques.h"
#include "tools/camera_control.h"

namespace sward {
namespace {

TEST(SideRun, ProgressIsTheLastLineThatTellsIt) {
    const auto news = newsFrom("  3 %  view: truth\nsward: warning: odd\n 50 %  view: hybrid maxGeom=6\n");
    ASSERT_TRUE(news);
    EXPECT_EQ(news->what, "view: hybrid maxGeom=6");
    EXPECT_EQ(news->share, 0.5);
    EXPECT_FALSE(newsFrom("sward: error: no\n"));
    RunNews at = *news;
    at.since = 100;
    EXPECT_EQ(newsText(at, 130), "50 %, 30 s left: view: hybrid maxGeom=6");
    EXPECT_EQ(newsText({.since = 2}, 5), "starts, 3 s");
}

// A program that keeps its arguments and the project that it is given beside its output, says something, and fails.
constexpr const char* kProgram =
    "#!/bin/sh\necho \"$@\"\ncp \"$2/project.json\" \"$0.seen\"\necho ' 40 %  half' >&2\necho 'sward: error: tired' "
    ">&2\n"
    "exit 3\n";

TEST(SideRun, GetsACopyWithUnsavedWorkAndTheViewAndTellsWhyItFailed) {
    const test::TempDir dir;
    setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
    const std::filesystem::path program = dir / "program";
    test::writeText(program, kProgram);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    Document doc(tables());
    FlyCamera camera;
    FrameClock clock;
    Messages messages;
    SideRun run;
    const std::string file = program.string();
    const MeasureParts parts{doc, file, camera, clock, messages};
    EXPECT_FALSE(launchRun(run, parts, "effects", "view", {})) << "no project is open";
    ASSERT_TRUE(doc.create(dir / "p"));
    ASSERT_TRUE(doc.addEntity("unsaved"));
    ASSERT_TRUE(launchRun(run, parts, "effects", "view", {"--json"}));
    std::optional<int> code;
    for (int i = 0; i < 1000 && !(code = endedRun(run, clock)); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_EQ(code, 3);
    EXPECT_EQ(failureOf(run, "effects", 3), "sward: error: tired");
    EXPECT_EQ(run.folder, sideFolder(doc));
    EXPECT_EQ(test::readText(run.folder / "effects.out"),
              "effects " + (run.folder / "project-effects").string() + " --camera view --json\n");
    const std::string seen = test::readText(file + ".seen");
    EXPECT_NE(seen.find("unsaved"), std::string::npos);
    EXPECT_NE(seen.find("\"view\""), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(run.folder / "project-effects")) << "the copy is gone";
    EXPECT_EQ(findEntity(doc.project(), "view"), kNoEntity) << "the project itself has no such camera";
    unsetenv("XDG_STATE_HOME");
}

TEST(SideRun, ACopyThatCannotBeWrittenIsToldAndAStoppedOneLeavesNothing) {
    const test::TempDir dir;
    setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    FlyCamera camera;
    FrameClock clock;
    Messages messages;
    SideRun run;
    const std::string file = "/bin/true";
    const MeasureParts parts{doc, file, camera, clock, messages};
    const auto end = [&] {
        std::optional<int> code;
        for (int i = 0; i < 1000 && !code; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(5)))
            code = endedRun(run, clock);
        return code;
    };
    ASSERT_TRUE(launchRun(run, parts, "cost", "view", {}));
    EXPECT_FALSE(launchRun(run, parts, "cost", "view", {})) << "it runs already";
    const std::filesystem::path copy = run.copy;
    stopRun(run);
    EXPECT_FALSE(run.running());
    ASSERT_TRUE(launchRun(run, parts, "cost", "view", {})) << "another may begin at once";
    EXPECT_EQ(end(), 0) << failureOf(run, "cost", 1);
    EXPECT_FALSE(std::filesystem::exists(copy));
    const auto wait = [](const auto& until) {
        for (int i = 0; i < 1000 && !until(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return until();
    };
    ASSERT_TRUE(launchRun(run, parts, "cost", "view", {}));
    ASSERT_TRUE(wait([&] { return run.copying.finished(); }));
    EXPECT_TRUE(std::filesystem::exists(copy));
    stopRun(run);
    EXPECT_TRUE(run.copy.empty()) << "one that was written but not used yet is left behind";
    EXPECT_TRUE(wait([&] { return !std::filesystem::exists(copy); }));
    std::filesystem::remove_all(run.folder);
    test::writeText(run.folder, "a file where the folder of the copy is wanted");
    ASSERT_TRUE(launchRun(run, parts, "cost", "view", {}));
    EXPECT_EQ(end(), 1);
    EXPECT_NE(failureOf(run, "cost", 1).find(run.folder.string()), std::string::npos) << failureOf(run, "cost", 1);
    unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace sward
