// Copies of unsaved work, offered to the next run; with the clock in the test's hand.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorTools;

TEST_F(EditorTools, UnsavedWorkIsCopiedAndOfferedToTheNextRun) {
    setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
    app->autosave.on = true;
    const auto copies = [&] {
        int n = 0;
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(autosaveFolder(dir / "meadow"), none))
            n += std::filesystem::exists(entry.path() / "project.json");
        return n;
    };
    const auto tickUntilIdle = [&](double now) {
        const auto tick = [&] { return tickAutosave(app->autosave, doc, false, now); };
        if (tick()) app->clock.wanted = 4;
        while (app->autosave.job.active()) tick();
    };
    tickUntilIdle(0);
    ok(ui->set("Inspector/sun.Light.elevationDeg", "20"));
    tickUntilIdle(kAutosaveSeconds - 1);
    EXPECT_EQ(copies(), 0);
    tickUntilIdle(kAutosaveSeconds + 1);
    EXPECT_EQ(copies(), 1);
    EXPECT_TRUE(autosavesOf(dir / "meadow").empty()) << "their maker lives";
    tickUntilIdle(3 * kAutosaveSeconds);  // nothing new
    EXPECT_EQ(copies(), 1);
    app->autosave.mine = {};  // as if the program had been killed, and another run began
    ASSERT_TRUE(doc.open(dir / "meadow"));
    app->autosave.of.clear();
    tickUntilIdle(0);
    ok(ui->wait(2));
    ASSERT_TRUE(ui->exists("Recovery/Recover"));
    ok(ui->click("Recovery/Recover"));
    EXPECT_EQ(field("sun.Light.elevationDeg"), "20");
    EXPECT_EQ(get("Status/Saved"), "false");
    EXPECT_EQ(copies(), 1);
    ok(ui->key("ctrl+s"));
    tickUntilIdle(1);
    EXPECT_EQ(copies(), 0);
    app->autosave.on = false;
    unsetenv("XDG_STATE_HOME");
}

TEST_F(EditorTools, WhereTheNewestCopyIsDamagedAnOlderOneIsTaken) {
    setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
    app->autosave.on = true;
    const auto copyAt = [&](double now, const char* elevation) {
        ASSERT_TRUE(doc.setField("sun.Light.elevationDeg", elevation));
        tickAutosave(app->autosave, doc, false, now);
        while (app->autosave.job.active()) tickAutosave(app->autosave, doc, false, now);
    };
    tickAutosave(app->autosave, doc, false, 0);
    copyAt(kAutosaveSeconds + 1, "20");
    copyAt(3 * kAutosaveSeconds, "30");
    app->autosave.mine = {};  // as if the program had been killed
    const std::vector<std::filesystem::path> copies = autosavesOf(dir / "meadow");
    ASSERT_EQ(copies.size(), 2u);
    test::writeText(copies.front() / "project.json", "{ \"format\": ");
    const auto recover = [&] {
        ASSERT_TRUE(doc.open(dir / "meadow"));
        app->autosave.of.clear();
        tickAutosave(app->autosave, doc, false, 0);
        ok(ui->wait(3));
        ok(ui->click("Recovery/Recover"));
    };
    recover();
    EXPECT_EQ(field("sun.Light.elevationDeg"), "20");
    EXPECT_NE(app->messages.status.find("older"), std::string::npos) << app->messages.status;
    app->autosave.mine = {};
    test::writeText(copies.back() / "project.json", "");
    const std::string saved = [&] {
        EXPECT_TRUE(doc.open(dir / "meadow"));
        return field("sun.Light.elevationDeg");
    }();
    recover();
    EXPECT_EQ(field("sun.Light.elevationDeg"), saved) << "none can be read: the project stays as it was saved";
    EXPECT_NE(app->messages.notice.find("project.json"), std::string::npos) << app->messages.notice;
    app->messages.notice.clear();
    app->autosave.on = false;
    unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace sward
