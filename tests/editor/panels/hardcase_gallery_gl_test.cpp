// The tab Hard Cases in the editor: rows are judged on its GPU too, while the tab is in sight.
#include "editor/editor_fixture.h"

namespace sward::test {
namespace {

TEST_F(EditorUi, HardCasesAreJudgedOnTheGpuWhileTheirTabIsInSight) {
    ok(ui->wait(3));
    EXPECT_TRUE(app->hardCases.cases.empty()) << "nothing is made before somebody looks";
    ok(ui->click("Tabs/Hard Cases"));
    ok(ui->wait(4));
    ASSERT_GT(app->hardCases.results.size(), 1u);
    EXPECT_TRUE(app->hardCases.results[0].hasGpu);
    EXPECT_EQ(get("Hard Cases/Verdict"), "ok") << "of the case that the combo shows";
    EXPECT_TRUE(ui->exists("Hard Cases/Errors"));
    ok(ui->click("Tabs/Console"));
    ok(ui->wait(2));
    const size_t judged = app->hardCases.results.size();
    ok(ui->wait(3));
    EXPECT_EQ(app->hardCases.results.size(), judged);
}

}  // namespace
}  // namespace sward::test
