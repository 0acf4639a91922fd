// expect.* and sortedPairs of docs/scripting.md.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(ExpectCalls, EveryExpectationPassesAndFails) {
    EXPECT_RUNS(
        "expect.equal(1, 1.0) expect.equal('a', 'a') expect.equal({1, {b = 2}}, {1, {b = 2}}) expect.equal(nil, nil)"
        "expect.near(1, 1.05, 0.1) expect.less(1, 2) expect.truthy(0) expect.truthy('')");
    for (const char* failing : {"expect.equal(1, 2)", "expect.equal({1}, {1, 2})", "expect.equal({1, 2}, {1})",
                                "expect.equal('1', 1)", "expect.near(1, 1.2, 0.1)", "expect.near(0/0, 1, 1)",
                                "expect.less(2, 2)", "expect.truthy(nil)", "expect.truthy(false)"})
        EXPECT_FAULT(ScriptStage(), failing, "test.lua:1: expected");
}

TEST(ExpectCalls, SortedPairsVisitsNumbersThenStringsInOrder) {
    EXPECT_RUNS(R"(
        local seen = {}
        for k, v in sortedPairs({b = 1, [10] = 2, a = 3, [2] = 4, [-1.5] = 5}) do seen[#seen + 1] = tostring(k) .. v end
        expect.equal(seen, {'-1.55', '24', '102', 'a3', 'b1'})
        for k in sortedPairs({}) do error('nothing to visit') end
        expect.truthy(not pcall(sortedPairs, {[true] = 1})))");
}

}  // namespace
}  // namespace sward
