// help(), and the words that a console's line may be completed to.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(HelpCalls, HelpListsTablesAndTheCallsOfOne) {
    ScriptStage r;
    EXPECT_EQ(r.fault("help()"), "");
    std::string all;
    for (const std::string& line : r.printed) all += line + "\n";
    EXPECT_NE(all.find("\nmap:  "), std::string::npos) << all;
    EXPECT_NE(all.find("docs/scripting.md"), std::string::npos) << all;
    r.printed.clear();
    EXPECT_EQ(r.fault("help('expect')"), "");
    EXPECT_EQ(r.printed, (std::vector<std::string>{"expect.equal  expect.less  expect.near  expect.truthy"}));
    EXPECT_FAULT(r, "help('nothing')", "'nothing'");
}

TEST(HelpCalls, AConsolesWordBecomesGlobalsAndWhatLiesInThem) {
    ScriptStage r;
    ScriptConsole console(r.host);
    using Words = std::vector<std::string>;
    EXPECT_EQ(console.completions("expect.ne"), Words{"expect.near"});
    EXPECT_EQ(console.completions("sorted"), Words{"sortedPairs"});
    EXPECT_EQ(console.completions("nothing.at"), Words{});
    EXPECT_EQ(console.completions("print.x"), Words{}) << "a call holds no names";
    ASSERT_TRUE(console.run("expectation = 3"));
    EXPECT_EQ(console.completions("expect"), (Words{"expect", "expectation"}));
    EXPECT_GT(console.completions("").size(), 10u);
}

}  // namespace
}  // namespace sward
