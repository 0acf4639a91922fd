// Scripts and the console: how they run, and how failures are told.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(Script, PrintGoesToTheHostLineByLine) {
    ScriptStage r;
    ASSERT_TRUE(r.run("print('a', 1, 2.5, nil, true)\nprint()"));
    EXPECT_EQ(r.printed, (std::vector<std::string>{"a\t1\t2.5\tnil\ttrue", ""}));
}

TEST(Script, AFailureNamesFileAndLineAndEndsWithOne) {
    ScriptStage r;
    const Status s = r.run("local x = 1\n\nexpect.equal(x, 2, 'the count')\n");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().code, ExitCode::Failed);
    EXPECT_EQ(s.error().line, 3);
    EXPECT_EQ(s.error().text(), (r.dir / "test.lua").string() + ":3: the count: expected 1 to equal 2");
}

TEST(Script, SyntaxErrorsNameFileAndLine) {
    ScriptStage r;
    const Status s = r.run("local x = 1\nlocal = 3\n");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().line, 2);
    EXPECT_EQ(s.error().file, (r.dir / "test.lua").string());
    EXPECT_EQ(s.error().code, ExitCode::Failed);
}

TEST(Script, CallsThatFailKeepTheirExitCode) {
    ScriptStage r;
    Status s = r.run("project.new()\nentity.set('camera.Camera.zoom', 1)");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().code, ExitCode::Usage);
    EXPECT_NE(s.error().text().find("fovDeg"), std::string::npos) << s.error().text();
    test::writeText(r.dir / "broken/project.json", "{");
    s = r.run("project.open('broken')");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().code, ExitCode::Unsound);
    s = r.run("pcall(project.open, 'broken')\nerror('mine')");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().code, ExitCode::Failed);
    EXPECT_EQ(runScript(r.dir / "missing.lua", r.host).error().code, ExitCode::Usage);
}

TEST(ScriptConsole, KeepsItsStateAndPrintsExpressions) {
    ScriptStage r;
    ASSERT_TRUE(r.doc.create(r.dir / "p"));
    ScriptConsole console(r.host);
    EXPECT_TRUE(console.run("x = 20"));
    EXPECT_TRUE(console.run("x + 1, 'two'"));
    EXPECT_TRUE(console.run("map.mean('density')"));
    EXPECT_TRUE(console.run("-- nothing"));
    EXPECT_EQ(r.printed, (std::vector<std::string>{"21\ttwo", "1.0"}));
    const Status s = console.run("nonsense(");
    ASSERT_FALSE(s);
    const Status t = console.run("expect.equal(1, 2)");
    ASSERT_FALSE(t);
    EXPECT_EQ(t.error().text(), "console:1: expected 1 to equal 2");
    EXPECT_TRUE(console.run("x"));
    EXPECT_EQ(r.printed.back(), "20");
}

TEST(ScriptConsole, BoundsEachLineByItself) {
    ScriptStage r;
    r.host.limits.instructions = 1'000'000;
    ScriptConsole console(r.host);
    EXPECT_FALSE(console.run("while true do end"));
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(console.run("for i = 1, 100000 do end"));
}

}  // namespace
}  // namespace sward
